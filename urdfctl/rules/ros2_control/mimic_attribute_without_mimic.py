"""UC316."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import robot_in, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, parts


@rule(
    "UC316",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Joint 'elbow' has no mimic information in"
    ' the URDF"',
    whole_robot=True,
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow" mimic="«true»"><state_interface name="position"/></joint>
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
def mimic_attribute_without_mimic(project: Project) -> Iterator[Finding]:
    """Joint marked as mimic has no `<mimic>` in the URDF.

    Since jazzy, the controller manager rejects the description. The URDF's joint defines what is mimicked, and how.
    """
    robot = robot_in(project)
    joints = {joint.name: joint for joint in reversed(robot.joints)} if robot else {}
    for _, joint in parts(project, "joint"):
        in_urdf = joints.get((joint.name or "").strip())
        marked = joint.tag.attributes.get("mimic", "").strip().lower() == "true"
        if in_urdf is None or in_urdf.mimic is not None or not marked:
            continue
        message = f"joint '{in_urdf.name}' is marked as mimic, but has no <mimic joint=\"...\"/> in the URDF"
        notes = (Note("the URDF's joint is defined here", in_urdf.at),)
        yield Finding(joint.at["mimic"], message, notes, severity=severity_where(project, JAZZY))
