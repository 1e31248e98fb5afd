"""UC018."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import marks
from urdfctl.rules.reading.common import consequences_of
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Place, SourceSpan, SourceText

_REQUIRED = (*since("noetic"), *ROS2)
_XACRO = "http://www.ros.org/wiki/xacro"
_PROLOG = rb"(?s)(?:\xef\xbb\xbf)?(?:\s+|<\?.*?\?>|<!--.*?-->|<!DOCTYPE[^>\[]*>)*"


@rule(
    "UC018",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=_REQUIRED,
    authority="xacro CHANGELOG 1.14.0 (noetic): 'removed deprecated --xacro-ns option'; eval_all() looks at names that begin with 'xacro:' only",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>
                  «<wheel side="left"/>»
                  <link name="base"/>
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
def xacro_prefix_missing(project: Project) -> Iterator[Finding]:
    """Xacro tag or macro call without the prefix `xacro:`.

    Since noetic, xacro silently copies tags without the prefix. The tag stays in the robot, and programs that read the
    robot ignore it. The wheel or inertia that the macro defines is missing. If xacro fails because of it, this is an
    error, unless the distro may be an earlier one. The rest of the robot is checked as if the prefix were there, as xacro read it until melodic.
    """
    distros = set(project.distros)
    for problem in project.of_kind(ProblemKind.PREFIX_MISSING):
        edits = tuple(edit for at in (problem.at, *problem.also) for edit in _prefixed(at))
        fix = Fix(problem.hint, (*_declared(problem.at.source), *edits))
        is_lost = "macro call" in problem.message and distros <= set(_REQUIRED)
        fails = problem.follows and (distros <= set(_REQUIRED) or not distros.isdisjoint(ROS2))
        severity = Severity.ERROR if fails or is_lost else None
        yield Finding(problem.at, problem.message, notes=consequences_of(problem), fix=fix, severity=severity)


def _declared(source: SourceText) -> tuple[Edit, ...]:
    """Return the edit that declares the prefix in the root element of a file. Empty if it is already declared."""
    prolog = re.match(_PROLOG, source.data)
    root = source.start_tag(prolog.end()) if prolog else None
    if root is None or "xmlns:xacro" in root.attributes:
        return ()
    after_name = root.start + 1 + len(root.name.encode())
    return (Edit(SourceSpan(source, after_name, after_name), f' xmlns:xacro="{_XACRO}"'),)


def _prefixed(at: Place) -> tuple[Edit, ...]:
    """Return the edits that add the prefix to an element's start tag and end tag."""
    return tuple(Edit(SourceSpan(at.source, start, start + len(mark)), f"{mark}xacro:") for start, mark in marks(at))
