"""UC447."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import until
from urdfctl.catalog.values import elements
from urdfctl.control.parameters.readers import Reader, in_each_distro, robot_of
from urdfctl.model.robot import Link, Robot
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known

_TYPE = "diff_drive_controller/DiffDriveController"
_ROBOT = """
    <link name="wheel">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
      <collision><geometry>%s</geometry></collision>
    </link>
    <joint name="wheel_joint" type="continuous">
      <parent link="base"/><child link="wheel"/><axis xyz="0 1 0"/>
    </joint>
    <transmission name="left">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="wheel_joint"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
      <actuator name="left_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <transmission name="right">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
      <actuator name="right_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
"""
_CONTROLLERS = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    base:
      type: diff_drive_controller/DiffDriveController
      left_wheel: %s
      right_wheel: elbow
      wheel_separation: 0.4
      pose_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
      twist_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
      base_frame_id: base
"""


@rule(
    "UC447",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=until("noetic")[1:],
    authority="ros_controllers diff_drive_controller/src/diff_drive_controller.cpp: 'Wheel link wheel is NOT modeled as a "
    "cylinder or sphere!', 'Link wheel does not have collision description.'",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad=[{"robot.urdf": _ROBOT % '<box size="0.2 0.2 0.2"/>', "controllers.yaml": _CONTROLLERS % "«wheel_joint»"}],
    good=[{"robot.urdf": _ROBOT % '<sphere radius="0.2"/>', "controllers.yaml": _CONTROLLERS % "wheel_joint"}],
)
def wheel_radius_not_in_robot(project: Project) -> Iterator[Finding]:
    """Wheel radius is neither given nor in the robot.

    Without the parameter `wheel_radius`, diff_drive_controller of ROS 1 uses the collision shape of the left wheel: a
    cylinder, or from kinetic on a sphere. If the wheel has another shape or none, the controller is not loaded.
    """
    robot = robot_of(project)
    if robot is not None:
        yield from in_each_distro(project, lambda reader: _without_radius(reader, robot))


def _without_radius(reader: Reader, robot: Robot) -> Iterator[Finding]:
    given = reader.located.get("left_wheel")
    if reader.type is None or reader.type.type != _TYPE or given is None or "wheel_radius" in reader.located:
        return
    first = next(iter(elements(reader.given.get("left_wheel"))), None)
    joint = robot.joint(first) if isinstance(first, str) and is_known(first) else None
    child = joint.child.name if joint and joint.child else None
    link = robot.link(child) if child else None
    problem = _problem(link, reader.distro) if link else None
    if problem and link is not None:
        at = given.value.items[0].at if given.value.items else given.value.at
        message = f"radius of wheel '{link.name}' is unknown, as its collision {problem}; add 'wheel_radius'"
        yield Finding(at, message, (Note(f"link '{link.name}' is defined here", link.at),), severity=Severity.ERROR)


def _problem(link: Link, distro: str) -> str | None:
    shapes = [geometry.shape for geometry in link.geometries if geometry.role == "collision"]
    if not shapes or shapes[0] is None:
        return "has no shape" if shapes else "is missing"
    round_shapes = ("cylinder",) if distro in ("indigo", "jade") else ("cylinder", "sphere")
    return None if shapes[0].name in round_shapes else f"is a {shapes[0].name}"
