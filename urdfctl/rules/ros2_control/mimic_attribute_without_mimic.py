"""UC316."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import robot_in, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, parts


@rule(
    "UC316",
    severity=Severity.ERROR,
    distros=JAZZY,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Joint 'elbow' has no mimic information in"
    ' the URDF"',
    whole_robot=True,
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow" mimic="«true»"><state_interface name="position"/></joint>
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
def mimic_attribute_without_mimic(project: Project) -> Iterator[Finding]:
    """A joint is marked as mimicking, and the URDF's joint has no `<mimic>`.

    From jazzy on the controller manager refuses the description: what is mimicked, and how, stands in the URDF's
    joint.
    """
    robot = robot_in(project)
    joints = {joint.name: joint for joint in reversed(robot.joints)} if robot else {}
    for _, joint in parts(project, "joint"):
        found = joints.get((joint.name or "").strip())
        marked = joint.tag.attributes.get("mimic", "").strip().lower() == "true"
        if found is None or found.mimic is not None or not marked:
            continue
        message = f"joint '{found.name}' is marked as mimicking, and has no <mimic joint=\"...\"/> in the URDF"
        notes = (Note("the URDF's joint is here", found.at),)
        yield Finding(joint.at["mimic"], message, notes, severity=severity_where(project, JAZZY))
