"""UC018."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC018",
    severity=Severity.WARNING,
    authority="xacro CHANGELOG 1.14.0 (noetic): 'removed deprecated --xacro-ns option'; eval_all() looks at names that begin with 'xacro:' only",
    bad={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>
              «<wheel side="left"/>»
              <link name="base"/>
            </robot>
        """,
    },
    good={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>
              <xacro:wheel side="left"/>
            </robot>
        """,
    },
)
def xacro_prefix_missing(project: Project) -> Iterator[Finding]:
    """A tag of xacro, or a macro's call, lacks the prefix `xacro:`.

    From noetic on xacro expands nothing without the prefix, and says nothing: the tag stays in the robot,
    where every reader passes over it. The inertia or the wheel that it stands for is missing.
    """
    yield from findings_of(project, ProblemKind.PREFIX_MISSING)
