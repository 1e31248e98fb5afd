"""UC365."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.ros2_control import Part
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
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: 'Joint 'elbow' not found in URDF'; "
    "ros2_control_demos#152, 'Do not ignore prefix argument for joint names.'",
    options=["--distro=jazzy"],
    bad={"arm.ros2_control.xacro": _MACRO % "«elbow»"},
    good={"arm.ros2_control.xacro": _MACRO % "${prefix}elbow"},
)
def part_without_prefix(project: Project) -> Iterator[Finding]:
    """A macro takes a prefix, uses it nowhere, and names the joints or sensors of `<ros2_control>` without it.

    As long as the prefix is empty all is well. With any other one the joints of the robot have it and these have not, so
    that ros2_control does not find them, and two arms share their interfaces.
    """
    for _, part in parts(project, "joint", "sensor"):
        declared = _unused_prefix(part) if part.name else None
        if declared is not None:
            yield _finding(part, declared)


def _finding(part: Part, declared: Place) -> Finding:
    name, parameter = part.name or "", declared.span.text
    at = part.at["name"]
    message = f"{label(part.kind, name)} has no prefix, though its macro takes '{parameter}' and uses it nowhere"
    fix = replaced(at, name, f"${{{parameter}}}{name}")
    return Finding(at, message, (Note(f"'{parameter}' is declared here", declared),), fix)


def _unused_prefix(part: Part) -> Place | None:
    """The parameter that is a prefix by its name, and stands nowhere in the macro that writes a part literally."""
    call = part.at.call
    if call is None or "$" in part.at["name"].span.text:
        return None
    macro = call.span if call.kind == "uncalled macro" else call.definition
    tag = macro.source.start_tag(macro.start) if macro is not None else None
    if macro is None or tag is None or "params" not in tag.attributes or macro.source is not part.at.source:
        return None
    data, (start, end) = macro.source.data, tag.attributes["params"]
    found = re.compile(_PARAMETER).search(data, start, end)
    body = data[tag.end : data.find(_ENDING, tag.end)]
    if found is None or re.search(rb"\b%s\b" % found.group(1), body) or _MACRO_TAG in body:
        return None
    return Place(macro.source, found.start(1), end=found.end(1))
