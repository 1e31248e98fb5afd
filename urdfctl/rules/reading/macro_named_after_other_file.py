"""UC029."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


def _side(macro: str, link: str) -> str:
    return f"""
        <robot xmlns:xacro="http://www.ros.org/wiki/xacro">
          <xacro:macro name="{macro}"><link name="{link}"/></xacro:macro>
        </robot>
    """


_ROBOT = """
    <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:include filename="right_arm.xacro"/>
      <xacro:CALLED/>
    </robot>
"""


@rule(
    "UC029",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="xacro/__init__.py grab_macro(): macros[name] = macro, over whatever was there",
    bad=[
        {
            "robot.xacro": _ROBOT.replace("CALLED", "left_arm"),
            "left_arm.xacro": _side("left_arm", "left"),
            "right_arm.xacro": _side("«left_arm»", "right"),
        },
    ],
    good=[
        {
            "robot.xacro": _ROBOT.replace("CALLED", "right_arm"),
            "left_arm.xacro": _side("left_arm", "left"),
            "right_arm.xacro": _side("right_arm", "right"),
        },
    ],
)
def macro_named_after_other_file(project: Project) -> Iterator[Finding]:
    """Macro has the same name as a macro in another file.

    Usually the file was copied and its macro was not renamed. In a robot that includes both files, the later definition
    silently replaces the earlier one for every call.
    """
    yield from findings_of(project, ProblemKind.MACRO_OF_OTHER_FILE)
