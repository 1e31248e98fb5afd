"""UC317."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.robot import Ros2Control, Tag
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, replaced, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, component, components, first_of, is_boolean

_WORDS = {"1": "true", "yes": "true", "on": "true", "0": "false", "no": "false", "off": "false"}


@rule(
    "UC317",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("iron"),
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Input string : 'yes' is not a valid "
    "boolean value. Expected 'true' or 'false'.\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                    <limits enable="«yes»"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="«Yes»">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow" mimic="«1»">
                    <command_interface name="position"><limits enable="«on»"/></command_interface>
                    <state_interface name="position"><limits enable="«0»"/></state_interface>
                    <limits enable="«no»"/>
                  </joint>
                  <sensor name="tip"><state_interface name="force"><limits enable="«off»"/></state_interface></sensor>
                  <transmission name="drive">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow" read_only="«maybe»"><mechanical_reduction>1</mechanical_reduction></joint>
                  </transmission>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=iron",
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="«yes»">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/><limits enable="no"/></joint>
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
                    <limits enable="true"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def boolean_malformed(project: Project) -> Iterator[Finding]:
    """Invalid boolean attribute in a component.

    Since jazzy, the controller manager rejects the description. Iron reads only `is_async` and treats every value
    except `true` and `True` as false.
    """
    for control in components(project):
        for owner, tag, attribute in _booleans(control):
            text = tag.attributes.get(attribute)
            if text is None or not is_known(text) or is_boolean(text):
                continue
            if attribute != "is_async" and not set(JAZZY) & set(project.distros):
                continue
            meant = _WORDS.get(text.strip().lower())
            at = tag.at[attribute]
            fix = replaced(at, text, meant) if meant else None
            message = f"'{attribute}' of {owner} must be 'true' or 'false', not '{text}'"
            yield Finding(at, message, fix=fix, severity=severity_where(project, JAZZY))


def _booleans(control: Ros2Control) -> Iterator[tuple[str, Tag, str]]:
    """The elements with boolean attributes, each after its owner and before the attribute."""
    yield component(control), control.tag, "is_async"
    for part in control.parts:
        owner = label(part.kind, part.name)
        if part.kind == "joint":
            yield owner, part.tag, "mimic"
        tags = [part.tag] if part.kind != "gpio" else []
        for tag in (*tags, *(interface.tag for interface in part.interfaces)):
            yield from ((f"<limits> of {owner}", limits, "enable") for limits in first_of(tag, "limits"))
    for transmission in control.transmissions:
        for end in (*transmission.joints, *transmission.actuators):
            yield f"{label(end.kind, end.name)} of {label('transmission', transmission.name)}", end.tag, "read_only"
