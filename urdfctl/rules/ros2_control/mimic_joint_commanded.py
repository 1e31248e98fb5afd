"""UC314."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import severity_where
from urdfctl.rules.ros2_control.common import JAZZY, followers


@rule(
    "UC314",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Joint 'elbow' has mimic attribute not set"
    ' to false: Activated mimic joints cannot have command interfaces."',
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <link name="finger"/>
                <joint name="grip" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="0" upper="0.1" effort="1" velocity="1"/><mimic joint="elbow"/>
                </joint>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="grip">
                    «<command_interface name="position"/>»
                    <state_interface name="position"/>
                  </joint>
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
def mimic_joint_commanded(project: Project) -> Iterator[Finding]:
    """Mimic joint with a command interface.

    Since jazzy, the URDF's `<mimic>` is used, and the controller manager rejects the description. The joint follows by
    itself and has only state interfaces. With `mimic="false"` it can be commanded like any other joint.
    """
    for joint, _ in followers(project):
        for interface in joint.commands[:1]:
            name = joint.name
            message = (
                f"joint '{name}' mimics another joint, but has a command interface; remove the interface, "
                f'or write <joint name="{name}" mimic="false">'
            )
            yield Finding(interface.at, message, severity=severity_where(project, JAZZY))
