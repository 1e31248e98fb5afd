"""UC312."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, severity_where, whole_robot_in
from urdfctl.rules.links_for_joints import joint_meant_by, links_called
from urdfctl.rules.ros2_control.common import JAZZY, component, parts
from urdfctl.rules.written import at_written


@rule(
    "UC312",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Joint 'elbw' not found in URDF\"",
    whole_robot=True,
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="«elbw»"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="«lifter»"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="«lifter»"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def component_joint_unknown(project: Project) -> Iterator[Finding]:
    """Unknown joint in a ros2_control component.

    Since jazzy, the controller manager rejects the description. In earlier distros a simulator skips the joint, so its
    interfaces are missing, and mock hardware publishes states of a joint that does not exist.
    """
    robot = whole_robot_in(project)
    if robot is None or project.library or not robot.joints:
        return
    joints = list(parts(project, "joint"))
    named = [joint.name or "" for _, joint in joints]
    known = KnownNames(robot.joint_names, named)
    left = _only_left(robot, named)
    for control, joint in joints:
        name = joint.name
        if name is None or not is_known(name) or name.strip() in known:
            continue
        meant, is_sure = joint_meant_by(robot, name, known.meant_by(name), named)
        hint = f"; did you mean '{meant}'?" if meant else ""
        if meant is None and left:
            meant, hint = left, f"; did you mean '{left}', the only joint that no component has?"
        message = f"{component(control)} names joint '{name}', which the robot does not have{hint}"
        is_sure = is_sure or known.is_sure(name, meant)
        finding = at_written(joint.at["name"], name, meant, message, tuple(links_called(robot, name)), safe=is_sure)
        yield finding._replace(severity=severity_where(project, JAZZY))


def _only_left(robot: Robot, named: list[str]) -> str | None:
    """The only joint that moves by itself and that no component has, if only one name in components is unknown."""
    joints = {joint.name for joint in robot.joints}
    free = [joint.name for joint in robot.joints if joint.moves and not joint.mimic and joint.name not in named]
    is_single = len({name for name in named if name not in joints}) == 1
    return free[0] if is_single and len(free) == 1 else None
