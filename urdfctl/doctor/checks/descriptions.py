"""The description that runs, beside that of the files: as models, not as texts."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from urdfctl.compare.changes import RobotChange, changes
from urdfctl.compare.tree import TreeNode, node_of
from urdfctl.doctor.examination import Ailment, Examination, ailment
from urdfctl.doctor.expectation import Expectation
from urdfctl.doctor.recording import LEFT_OUT
from urdfctl.rules.running.running_hardware_differs import running_hardware_differs
from urdfctl.rules.running.running_part_missing import running_part_missing
from urdfctl.rules.running.running_value_differs import running_value_differs
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse

_PARTS = ("links", "joints", "interfaces", "hardware", "transmissions")
_MOST_NOTES = 5


def check_parts(exam: Examination) -> Iterator[Ailment]:
    """Yield other hardware, and parts that only the files or only the running description have."""
    for expected in exam.expected:
        found = _differences(exam, expected)
        for change in found:
            if change.kind == "changed" and change.path[-1] == "plugin" and change.path[0].startswith("ros2_control:"):
                yield ailment(
                    running_hardware_differs,
                    component=change.path[0].partition(":")[2],
                    running=change.after or "",
                    files=change.before or "",
                )
        parts = [one for one in found if one.area in _PARTS and one.kind != "changed"]
        if parts:
            first, *rest = sorted(parts, key=lambda one: (not one.path[0].startswith("joint:"), len(one.path)))
            notes = [_of_part(one) for one in rest[:_MOST_NOTES]]
            yield ailment(running_part_missing, what=_what(first), where=_where(first), notes=notes)


def check_values(exam: Examination) -> Iterator[Ailment]:
    """Yield the values in which the running description differs from the files."""
    for expected in exam.expected:
        values = [one for one in _differences(exam, expected) if one.kind == "changed" and one.path[-1] != "plugin"]
        values = [
            one for one in values if one.after != LEFT_OUT and not _is_same_file(one.before or "", one.after or "")
        ]
        if values:
            first, *rest = values
            notes = [
                f"{one.address}: {one.after or 'missing'}, the files say {one.before or 'nothing'}" for one in rest
            ]
            yield ailment(
                running_value_differs,
                value=first.address,
                running=first.after or "missing",
                files=first.before or "nothing",
                notes=notes[:_MOST_NOTES],
            )


def _differences(exam: Examination, expected: Expectation) -> list[RobotChange]:
    """What changed from the files to what runs, without what an argument of the launch file may change."""
    text = exam.description_of(expected)
    running = tree_of(text) if text else None
    if running is None:
        return []
    found = changes(expected.tree, running)
    return [one for one in found if one.address not in expected.open and UNKNOWN not in f"{one.before}{one.after}"]


def tree_of(text: str) -> TreeNode | None:
    """Return the tree of a description; None if it is no XML."""
    try:
        root = parse(SourceText("robot_description", text.encode("utf-8", "replace"))).documentElement
    except ReadError:
        return None
    return node_of(root, lambda text: text) if root is not None else None


def _what(change: RobotChange) -> str:
    return change.after or change.before or change.address if change.kind == "renamed" else change.address


def _where(change: RobotChange) -> str:
    if change.kind == "renamed":
        return f"the files call it '{change.before}'"
    return "only the files have it" if change.kind == "removed" else "only the running description has it"


def _of_part(change: RobotChange) -> str:
    return f"{_what(change)}: {_where(change)}"


def _is_same_file(one: str, other: str) -> bool:
    """Whether two values are paths of one file, from its package, its source or where it is installed."""
    return "/" in one and "/" in other and posixpath.basename(one) == posixpath.basename(other)


__all__ = ["check_parts", "check_values", "tree_of"]
