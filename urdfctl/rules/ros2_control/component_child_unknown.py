"""UC304."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Tag
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import respelt, severity_where
from urdfctl.rules.ros2_control.common import OLD, component, components
from urdfctl.rules.ros2_control.facts import CHILDREN
from urdfctl.source.opaque import UNKNOWN


@rule(
    "UC304",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "invalid tag name"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  «<joints name="elbow">»<command_interface name="position"/></joints>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  «<plugin>»mock_components/GenericSystem</plugin>
                  «<param name="port">»/dev/ttyUSB0</param>
                  «<group>»arms</group>
                  «<command_interface name="position"/>»
                  «<state_interface name="position"/>»
                  «<hardwares/>»
                  «<sensr name="tip"/>»
                  «<gpios name="io"/>»
                  «<transmision name="drive"/>»
                  «<note/>»
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  «<propertie/>»
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=iron",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  «<properties/>»
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
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
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <properties/>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def component_child_unknown(project: Project) -> Iterator[Finding]:
    """Unknown element in `<ros2_control>`.

    The parser rejects the whole description. It accepts `hardware`, `joint`, `sensor`, `gpio` and `transmission`, and
    since jazzy also `properties`.
    """
    for control in components(project):
        for child in control.others:
            if (
                child.name == UNKNOWN
                or ":" in child.name
                or (child.name == "properties" and not _rejects_properties(project))
            ):
                continue
            if child.name == "properties":
                message = f"<properties> in {component(control)} is read since jazzy; iron and earlier reject it"
                yield Finding(child.at, message, severity=severity_where(project, OLD))
                continue
            meant = None if child.name in _ELSEWHERE else nearest(child.name, CHILDREN)
            message = f"<{child.name}> is not allowed in {component(control)}{_instead(child, meant)}"
            yield Finding(child.at, message, fix=respelt(child, meant))


_ELSEWHERE = {
    "plugin": "<hardware>",
    "param": "<hardware>, <joint>, <sensor> or <gpio>",
    "group": "<hardware>",
    "command_interface": "<joint> or <gpio>",
    "state_interface": "<joint>, <sensor> or <gpio>",
}


def _rejects_properties(project: Project) -> bool:
    return bool(set(OLD) & set(project.distros))


def _instead(child: Tag, meant: str | None) -> str:
    if child.name in _ELSEWHERE:
        return f"; move it into {_ELSEWHERE[child.name]}"
    if meant:
        return f"; did you mean '{meant}'?"
    return "; expected <hardware>, <joint>, <sensor>, <gpio> or <transmission>"
