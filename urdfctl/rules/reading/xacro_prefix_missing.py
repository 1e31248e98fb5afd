"""UC018."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import marks
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Place, SourceSpan, SourceText

_XACRO = "http://www.ros.org/wiki/xacro"
_PROLOG = rb"(?s)(?:\xef\xbb\xbf)?(?:\s+|<\?.*?\?>|<!--.*?-->|<!DOCTYPE[^>\[]*>)*"


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
    for problem in project.of_kind(ProblemKind.PREFIX_MISSING):
        edits = (*_declared(problem.at.source), *_prefixed(problem.at))
        yield Finding(problem.at, problem.message, fix=Fix(problem.hint, edits))


def _declared(source: SourceText) -> tuple[Edit, ...]:
    """The edit that declares the prefix in the root element of a file; none where that does so already."""
    prolog = re.match(_PROLOG, source.data)
    root = source.start_tag(prolog.end()) if prolog else None
    if root is None or "xmlns:xacro" in root.attributes:
        return ()
    behind_name = root.start + 1 + len(root.name.encode())
    return (Edit(SourceSpan(source, behind_name, behind_name), f' xmlns:xacro="{_XACRO}"'),)


def _prefixed(at: Place) -> tuple[Edit, ...]:
    """The edits that give an element the prefix: of all that it becomes, its old tags are no part."""
    return tuple(Edit(SourceSpan(at.source, start, start + len(mark)), f"{mark}xacro:") for start, mark in marks(at))
