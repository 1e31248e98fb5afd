"""UC365."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ComponentPart
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import label, replaced
from urdfctl.rules.ros2_control.common import parts
from urdfctl.source.span import Place

_PARAMETER = rb"(?<![\w.])((?:\w+_)?prefix)(?=[\s:]|$)"
_ENDING, _MACRO_TAG = b"</xacro:macro", b"<xacro:macro"
_MACRO = """
    <robot xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:macro name="arm_control" params="name prefix">
        <ros2_control name="${name}" type="system">
          <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
          <joint name="%s"><command_interface name="position"/><state_interface name="position"/></joint>
        </ros2_control>
      </xacro:macro>
    </robot>
"""


@rule(
    "UC365",
    runtime="works",
    because="ros2_control finds no joint with any other prefix",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: 'Joint 'elbow' not found in URDF'; "
    "ros2_control_demos#152, 'Do not ignore prefix argument for joint names.'",
    options=["--distro=jazzy"],
    bad=[{"arm.ros2_control.xacro": _MACRO % "«elbow»"}],
    good=[{"arm.ros2_control.xacro": _MACRO % "${prefix}elbow"}],
)
def part_without_prefix(project: Project) -> Iterator[Finding]:
    """Macro does not use its prefix in the joint or sensor names of `<ros2_control>`.

    An empty prefix works. With any other prefix, the robot's joints have it but these joints do not, and ros2_control
    does not find them. Two arms also share their interfaces.
    """
    for _, part in parts(project, "joint", "sensor"):
        declared = _unused_prefix(part) if part.name else None
        if declared is not None:
            yield _finding(part, declared)


def _finding(part: ComponentPart, declared: Place) -> Finding:
    name, parameter = part.name or "", declared.span.text
    at = part.at["name"]
    message = f"{label(part.kind, name)} has no prefix; its macro takes '{parameter}', but never uses it"
    fix = replaced(at, name, f"${{{parameter}}}{name}")
    return Finding(at, message, (Note(f"'{parameter}' is declared here", declared),), fix)


def _unused_prefix(part: ComponentPart) -> Place | None:
    """The prefix parameter of the macro that writes the part literally, if the macro never uses it."""
    call = part.at.call
    if call is None or "$" in part.at["name"].span.text:
        return None
    macro = call.span if call.kind == "uncalled macro" else call.definition
    tag = macro.source.start_tag(macro.start) if macro is not None else None
    if macro is None or tag is None or "params" not in tag.attributes or macro.source is not part.at.source:
        return None
    data, (start, end) = macro.source.data, tag.attributes["params"]
    parameter = re.compile(_PARAMETER).search(data, start, end)
    body = data[tag.end : data.find(_ENDING, tag.end)]
    if parameter is None or re.search(rb"\b%s\b" % parameter.group(1), body) or _MACRO_TAG in body:
        return None
    return Place(macro.source, parameter.start(1), end=parameter.end(1))
