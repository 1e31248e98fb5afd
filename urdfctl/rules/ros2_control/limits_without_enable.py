"""UC318."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, first_of, parts


@rule(
    "UC318",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"no attribute 'enable' in 'limits' tag\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                    «<limits min="-1" max="1"/>»
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
                    <command_interface name="position"><param name="min">-1</param><param name="max">1</param></command_interface>
                    <state_interface name="position"/>
                    <limits enable="true"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def limits_without_enable(project: Project) -> Iterator[Finding]:
    """`<limits>` of a component without `enable`.

    Since jazzy, the controller manager rejects the description. The element switches limits on or off and has no
    numbers. The numbers belong in the URDF's `<limit>`, and in `min` and `max` of the command interface.
    """
    for _, part in parts(project):
        owner = label(part.kind, part.name)
        tags = [part.tag] if part.kind != "gpio" else []
        for tag in (*tags, *(interface.tag for interface in part.interfaces)):
            for limits in first_of(tag, "limits"):
                if "enable" not in limits.attributes:
                    message = f'<limits> of {owner} has no \'enable\'; write <limits enable="true"/> or <limits enable="false"/>'
                    yield Finding(limits.at, message, severity=severity_where(project, JAZZY))
