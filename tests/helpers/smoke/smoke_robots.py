"""Small robots to simulate: three rovers and three arms of different builds, with their controller files."""

from __future__ import annotations

from typing import NamedTuple

INERTIAL = '<inertial><mass value="{m}"/><inertia ixx="{i}" ixy="0" ixz="0" iyy="{i}" iyz="0" izz="{i}"/></inertial>'


def link(name: str, mass: float, moment: float, shape: str = "", place: str = "0 0 0") -> str:
    """Return a link, with collision geometry if a shape is given."""
    collision = f'<collision><origin xyz="{place}"/><geometry>{shape}</geometry></collision>' if shape else ""
    return f'<link name="{name}">{INERTIAL.format(m=mass, i=moment)}{collision}</link>'


class Rover(NamedTuple):
    """A rover with a wheel on each side and a ball in front and behind."""

    radius: float = 0.1
    half: float = 0.15
    mass: float = 5.0
    turn: str = "-1.5707963 0 0"
    axis: str = "0 0 1"

    def urdf(self, left: str | None = None, right: str | None = None, effort: str = "20") -> str:
        """Return the description, with other axes of the wheels if they are given."""
        return f"""
        <robot name="rover">
          <link name="base_footprint"/>
          <joint name="foot" type="fixed"><parent link="base_footprint"/><child link="base_link"/></joint>
          {link("base_link", self.mass, self.mass / 50, '<box size="0.3 0.1 0.02"/>', f"0 0 {self.radius / 2}")}
          {self._ball("front", 1.5)}{self._ball("rear", -1.5)}
          {self._wheel("left", self.half, left or self.axis, effort)}
          {self._wheel("right", -self.half, right or self.axis, effort)}
          <ros2_control name="wheels" type="system">
            <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
            {self._control("left")}{self._control("right")}
          </ros2_control>
        </robot>
        """

    def _ball(self, name: str, far: float) -> str:
        radius = self.radius / 2
        return (
            link(name, 0.1, 0.001, f'<sphere radius="{radius}"/>')
            + f'<joint name="{name}_mount" type="fixed"><parent link="base_link"/><child link="{name}"/>'
            + f'<origin xyz="{far * self.radius} 0 {-radius}"/></joint>'
        )

    def _wheel(self, name: str, y: float, axis: str, effort: str) -> str:
        about = f'<cylinder radius="{self.radius}" length="0.04"/>'
        rolled = "" if self.turn.startswith("-1.57") else ' rpy="1.5707963 0 0"'
        shape = f'<collision><origin xyz="0 0 0"{rolled}/><geometry>{about}</geometry></collision>'
        return (
            f'<link name="{name}">{INERTIAL.format(m=0.5, i=0.002)}{shape}</link>'
            f'<joint name="{name}_wheel" type="continuous"><parent link="base_link"/><child link="{name}"/>'
            f'<origin xyz="0 {y} 0" rpy="{self.turn}"/><axis xyz="{axis}"/><limit effort="{effort}" velocity="30"/>'
            "</joint>"
        )

    def _control(self, name: str) -> str:
        states = '<state_interface name="position"/><state_interface name="velocity"/>'
        return f'<joint name="{name}_wheel"><command_interface name="velocity"/>{states}</joint>'

    def yaml(self, radius: float = 1.0, separation: float = 1.0, left: str = "left", right: str = "right") -> str:
        """Return the controller file, with the wheel radius and separation off by some factors."""
        return f"""
controller_manager:
  ros__parameters:
    update_rate: 100
    states: {{type: joint_state_broadcaster/JointStateBroadcaster}}
    base: {{type: diff_drive_controller/DiffDriveController}}
base:
  ros__parameters:
    left_wheel_names: [{left}_wheel]
    right_wheel_names: [{right}_wheel]
    wheel_separation: {2 * self.half * separation:.4f}
    wheel_radius: {self.radius * radius:.4f}
    base_frame_id: base_link
"""


ROVERS = {
    "wheels turned on their sides": Rover(),
    "wheels that stand": Rover(0.05, 0.1, 2.0, "0 0 0", "0 1 0"),
    "large and heavy": Rover(0.2, 0.35, 30.0),
}


class Arm(NamedTuple):
    """An arm with two joints that turn about or slide along an axis, each with a mass at some distance."""

    kind: str = "revolute"
    axis: str = "0 1 0"
    mass: float = 2.0
    far: float = 0.3
    gains: str = "p: 100.0, i: 10.0, d: 5.0"

    def urdf(
        self, effort: float = 200.0, velocity: float = 2.0, mass: str | None = None, interface: str = "effort"
    ) -> str:
        """Return the description, with some limits and the mass of the last link."""
        hand = link("fore", 1.0, 0.02).replace('mass value="1.0"', f'mass value="{mass or self.mass}"')
        return f"""
        <robot name="arm">
          <link name="base_link"/>
          {link("upper", self.mass, 0.02)}{hand}
          {self._joint("shoulder", "base_link", "upper", effort, velocity)}
          {self._joint("elbow", "upper", "fore", effort, velocity)}
          <ros2_control name="arm" type="system">
            <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
            {self._control("shoulder", interface)}{self._control("elbow", interface)}
          </ros2_control>
        </robot>
        """

    def _joint(self, name: str, parent: str, child: str, effort: float, velocity: float) -> str:
        return (
            f'<joint name="{name}" type="{self.kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{self.far} 0 0.1"/><axis xyz="{self.axis}"/>'
            f'<limit lower="-1" upper="1" effort="{effort}" velocity="{velocity}"/></joint>'
        )

    def _control(self, name: str, interface: str) -> str:
        states = '<state_interface name="position"/><state_interface name="velocity"/>'
        return f'<joint name="{name}"><command_interface name="{interface}"/>{states}</joint>'

    def yaml(self, gains: str | None = None, joints: str = "shoulder, elbow", interface: str = "effort") -> str:
        """Return the file of a trajectory controller with some gains."""
        given = gains or self.gains
        return f"""
controller_manager:
  ros__parameters:
    update_rate: 500
    states: {{type: joint_state_broadcaster/JointStateBroadcaster}}
    mover: {{type: joint_trajectory_controller/JointTrajectoryController}}
mover:
  ros__parameters:
    joints: [{joints}]
    command_interfaces: [{interface}]
    state_interfaces: [position, velocity]
    gains:
      shoulder: {{{given}}}
      elbow: {{{given}}}
"""


ARMS = {
    "joints that lift": Arm(),
    "joints that slide up": Arm("prismatic", "0 0 1", 3.0, 0.0, "p: 4000.0, i: 100.0, d: 400.0"),
    "joints that turn level": Arm("revolute", "0 0 1", 1.0, 0.2, "p: 50.0, i: 0.0, d: 3.0"),
}
