"""UC159."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import label, robot_in

_LITERAL = re.compile(r"\$([A-Za-z]\w*)")


@rule(
    "UC159",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="xacro/__init__.py LEXER: '$' without a brace is text; urdfdom accepts any name",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="wheel" params="side"><link name="«$side_wheel»"/></xacro:macro>
                  <xacro:wheel side="left"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>
                  <xacro:wheel side="left"/>
                </robot>
            """,
        },
    ],
)
def dollar_in_name(project: Project) -> Iterator[Finding]:
    """Link or joint name with a `$` that xacro did not expand.

    xacro expands `${name}` and copies `$name` unchanged. Each call of the macro then makes the same name, and no other
    file can refer to the name that was meant.
    """
    robot = robot_in(project)
    if robot is None:
        return
    for kind, parts in (("link", robot.links), ("joint", robot.joints)):
        for part in parts:
            found = _LITERAL.search(part.name or "")
            if found is None:
                continue
            at = part.at["name"]
            named = [
                name for name in _parameters(at.source.data) if found[1] == name or found[1].startswith(f"{name}_")
            ]
            name = max(named, key=len, default=found[1])
            right = (part.name or "").replace(f"${name}", f"${{{name}}}", 1)
            edits = (
                (Edit(at.span, at.span.text.replace(f"${name}", f"${{{name}}}", 1)),)
                if f"${name}" in at.span.text
                else ()
            )
            message = f"{label(kind, part.name)} contains '${name}', which xacro does not expand; write '{right}'"
            yield Finding(at, message, fix=Fix(f"write '{right}'", edits))


def _parameters(data: bytes) -> set[str]:
    """The names of the macro parameters, properties and arguments in a file."""
    words = re.findall(rb"params\s*=\s*[\"']([^\"']*)", data) + re.findall(
        rb"(?:property|arg)\s+name\s*=\s*[\"'](\w+)", data
    )
    return {
        name
        for text in words
        for name in re.findall(r"(?<![\w|^*])\*{0,2}([A-Za-z_]\w*)", text.decode("utf-8", "replace"))
    }
