"""UC312."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import Names, is_known, replaced, severity_where, whole_robot_in
from urdfctl.rules.ros2_control.common import JAZZY, component, parts


@rule(
    "UC312",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Joint 'elbw' not found in URDF\"",
    whole_robot=True,
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="«elbw»"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
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
)
def component_joint_unknown(project: Project) -> Iterator[Finding]:
    """A component names a joint that the robot does not have.

    From jazzy on the controller manager refuses the description. Before, a simulator passes over the joint, so that
    its interfaces are missing, and mock hardware makes joint states of a joint that nobody knows.
    """
    robot = whole_robot_in(project)
    if robot is None or project.library or not robot.joints:
        return
    known = Names(robot.joint_names)
    for control, joint in parts(project, "joint"):
        name = joint.name
        if name is None or not is_known(name) or name.strip() in known:
            continue
        right = known.meant_by(name)
        at = joint.at["name"]
        reason = f"; did you mean '{right}'?" if right else ", and none of the robot's is like it"
        fix = replaced(at, name, right) if right else None
        notes = tuple(_links(robot, name))
        message = f"unknown joint '{name}' in {component(control)}{reason}"
        yield Finding(at, message, notes, fix, severity_where(project, JAZZY))


def _links(robot: Robot, name: str) -> Iterator[Note]:
    link = next((link for link in robot.links if link.name == name), None)
    if link is None:
        return
    yield Note(f"'{name}' is a link; a component drives joints", link.at)
    for joint in robot.joints:
        if joint.child is not None and joint.child.name == name:
            yield Note(f"the joint that moves this link is '{joint.name}'", joint.at)
