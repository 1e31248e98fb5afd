"""UC313."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import IN_GAZEBO, simulator_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, component, parts


@rule(
    "UC313",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Joint 'flange' is of type 'fixed'. Fixed "
    'joints do not make sense in ros2_control."; gazebo_ros2_control gazebo_system.cpp: "Skipping joint in the URDF named '
    "'flange' which is not in the gazebo model.\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed"><parent link="fore"/><child link="tool"/></joint>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="«flange»"><command_interface name="position"/><state_interface name="position"/></joint>
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
def component_joint_fixed(project: Project) -> Iterator[Finding]:
    """Fixed joint in a ros2_control component.

    Since jazzy, the controller manager rejects the description. In earlier distros nothing can move the joint, and
    simulators do not have it at all: they skip it, and each controller that commands it fails.
    """
    robot = robot_in(project)
    joints = {joint.name: joint for joint in reversed(robot.joints)} if robot else {}
    for control, joint in parts(project, "joint"):
        in_urdf = joints.get((joint.name or "").strip())
        if in_urdf is not None and in_urdf.type == "fixed" and is_known(joint.name):
            message = (
                f"{component(control)} controls joint '{in_urdf.name}', which is fixed. "
                "Remove it, or change the joint's type"
            )
            note = Note("the joint's type is set here", in_urdf.at["type"])
            skipped = bool(joint.commands) and simulator_of(project, control) in IN_GAZEBO
            severity = Severity.ERROR if skipped else severity_where(project, JAZZY)
            yield Finding(joint.at["name"], message, (note,), severity=severity)
