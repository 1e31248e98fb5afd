"""UC475."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from urdfctl.catalog.distros import since
from urdfctl.control.session import Configured, Session
from urdfctl.model.robot import Interface
from urdfctl.rule import Finding, Note, Project, Severity, Stage, rule
from urdfctl.rules.claims.common import of_each_candidate, place_of
from urdfctl.rules.common import whole_robot_in

_MOCK = "mock_components/GenericSystem"
_READER = "joint_trajectory_controller/JointTrajectoryController"
_NOT_CAST = frozenset(("float32", "uint8", "int8", "uint16", "int16", "uint32", "int32"))
_BOOL_IS_CAST = since("kilted")
_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"%s/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: joint_trajectory_controller/JointTrajectoryController}
    arm:
      ros__parameters:
        joints: [%s]
        command_interfaces: [position]
        state_interfaces: [position]
"""


@rule(
    "UC475",
    stage=Stage.ACTIVATE,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("jazzy"),
    authority='ros2_control hardware_interface/include/hardware_interface/handle.hpp, get_optional(): "Data type: '
    "'bool' will not be casted to double for interface: elbow/position. Use get_optional<bool>() instead.\"; measured "
    "with jazzy's mock hardware and joint_trajectory_controller; from kilted on a bool is cast",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {"robot.urdf": _ROBOT % ' data_type="bool"', "controllers.yaml": _CONTROLLERS % "«elbow»"},
        {
            "robot.urdf": """
                <robot name="arm">
                  <link name="base"/>
                  <link name="link1"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="joint1" type="continuous"><parent link="base"/><child link="link1"/></joint>
                  <link name="link2"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="joint2" type="continuous"><parent link="base"/><child link="link2"/></joint>
                  <link name="link3"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="joint3" type="continuous"><parent link="base"/><child link="link3"/></joint>
                  <link name="link4"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="joint4" type="continuous"><parent link="base"/><child link="link4"/></joint>
                  <link name="link5"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="joint5" type="continuous"><parent link="base"/><child link="link5"/></joint>
                  <link name="link6"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="joint6" type="continuous"><parent link="base"/><child link="link6"/></joint>
                  <link name="link7"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="joint7" type="continuous"><parent link="base"/><child link="link7"/></joint>
                  <ros2_control name="arm" type="system">
                    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                    <joint name="joint1"><command_interface name="position"/><state_interface name="position" data_type="float32"/></joint>
                    <joint name="joint2"><command_interface name="position"/><state_interface name="position" data_type="uint8"/></joint>
                    <joint name="joint3"><command_interface name="position"/><state_interface name="position" data_type="int8"/></joint>
                    <joint name="joint4"><command_interface name="position"/><state_interface name="position" data_type="uint16"/></joint>
                    <joint name="joint5"><command_interface name="position"/><state_interface name="position" data_type="int16"/></joint>
                    <joint name="joint6"><command_interface name="position"/><state_interface name="position" data_type="uint32"/></joint>
                    <joint name="joint7"><command_interface name="position"/><state_interface name="position" data_type="int32"/></joint>
                  </ros2_control>
                </robot>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [«joint1», «joint2», «joint3», «joint4», «joint5», «joint6», «joint7»]
                    command_interfaces: [position]
                    state_interfaces: [position]
            """,
        },
    ],
    good=[
        {"robot.urdf": _ROBOT % "", "controllers.yaml": _CONTROLLERS % "elbow"},
        {
            "options": "--distro=kilted",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position" data_type="bool"/></joint>
                </ros2_control>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
            """,
        },
    ],
)
def state_of_other_data_type(project: Project) -> Iterator[Finding]:
    """State interface that a trajectory controller reads is not of type double.

    The controller reads its joints' states as `double` when it is activated, and cannot be activated if mock hardware
    exports one with another `data_type`.
    """
    typed = _typed(project)
    if typed:
        yield from of_each_candidate(project, partial(_misread, typed))


def _typed(project: Project) -> dict[tuple[str | None, str | None], tuple[str, Interface]]:
    """The state interfaces of mock hardware that have another data type than double, by joint and interface."""
    robot = whole_robot_in(project)
    typed = {}
    for control in robot.ros2_controls if robot else ():
        if (control.plugin or "").strip() == _MOCK:
            for part in control.parts:
                for interface in part.states:
                    kind = interface.tag.attributes.get("data_type", "double").strip()
                    if kind == "bool" or kind in _NOT_CAST:
                        typed[part.name, interface.name] = kind, interface
    return typed


def _misread(
    typed: dict[tuple[str | None, str | None], tuple[str, Interface]], session: Session, controller: Configured
) -> Iterator[Finding]:
    if controller.type is None or controller.type.type != _READER:
        return
    for claim in controller.claims.state:
        kind, interface = typed.get((claim.component, claim.interface), ("double", None))
        at = place_of(controller, claim)
        if interface is None or at is None or (kind == "bool" and session.distro in _BOOL_IS_CAST):
            continue
        message = f"controller '{controller.name}' reads '{claim.name}' as double, but its data type is '{kind}'"
        yield Finding(at, message, (Note("the data type is given here", interface.at["data_type"]),))
