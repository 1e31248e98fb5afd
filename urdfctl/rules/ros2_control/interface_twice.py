"""UC336."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Interface
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, label
from urdfctl.rules.ros2_control.common import called, parts, side_by_side


@rule(
    "UC336",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="measured with jazzy's controller manager, which silently accepts the second",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                    <state_interface name="«position»"/>
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
def interface_twice(project: Project) -> Iterator[Finding]:
    """Duplicate interface of a joint, sensor or gpio.

    Only one interface exists. Settings of the second one, such as limits or the initial value, are lost or replace
    those of the first.
    """
    for _, part in parts(project):
        first: dict[tuple[str, str], Interface] = {}
        for interface in part.interfaces:
            name = (interface.name or "").strip()
            before = first.setdefault((interface.kind, name), interface)
            if before is not interface and name and is_known(name) and side_by_side(project, before.at, interface.at):
                message = f"{called(interface)} of {label(part.kind, part.name)} is declared twice"
                yield Finding(interface.at["name"], message, (Note("first declared here", before.at["name"]),))
