"""The changes between two robots in text, Markdown, HTML and JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any

from urdfctl.compare.changes import RobotChange
from urdfctl.output.printing import visible
from urdfctl.report.common import as_json
from urdfctl.report.pages import page
from urdfctl.startup.records import NamedTuple

FORMATS = ("text", "markdown", "html", "json")
_SIGNS = {"added": "+", "removed": "-", "renamed": "~", "moved": "~", "changed": "~"}
_CUT = 100


class ComparedRobot(NamedTuple):
    """A robot that both sides have. complete: whether both could be expanded as a whole."""

    name: str
    changes: Sequence[RobotChange]
    complete: bool


class Comparison(NamedTuple):
    """What changed from one side to the other. removed, added: the robots that only one side has."""

    before: str
    after: str
    robots: Sequence[ComparedRobot]
    removed: Sequence[str] = ()
    added: Sequence[str] = ()

    @property
    def is_empty(self) -> bool:
        """Whether nothing changed."""
        return not (self.removed or self.added or any(robot.changes for robot in self.robots))


def rendered(comparison: Comparison, output: str) -> str:
    """Return a comparison in one of FORMATS."""
    return {"text": _text, "markdown": _markdown, "html": _html, "json": _json}[output](comparison)


def by_area(robot: ComparedRobot) -> list[tuple[str, list[RobotChange]]]:
    """Return the changes of a robot by area."""
    return [(area, list(found)) for area, found in groupby(robot.changes, key=lambda change: change.area)]


def values(change: RobotChange) -> tuple[str, str]:
    """Return the value before and after a change, as it is shown."""
    return _shown(change.before), _shown(change.after)


def _shown(value: str | None) -> str:
    if value is None:
        return "none"
    return visible(value) if len(value) <= _CUT else f"{visible(value[:_CUT])}…"


def _counted(comparison: Comparison) -> str:
    number = sum(len(robot.changes) for robot in comparison.robots)
    robots = [
        f"{len(names)} robot{'' if len(names) == 1 else 's'} {what}"
        for names, what in ((comparison.removed, "removed"), (comparison.added, "added"))
        if names
    ]
    return ", ".join([f"{number or 'no'} change{'' if number == 1 else 's'}", *robots])


def _incomplete(robot: ComparedRobot) -> str:
    return "" if robot.complete else "not all of it could be expanded; more may have changed"


# -- text ------------------------------------------------------------------------------------------------------------


def _text(comparison: Comparison) -> str:
    return "".join(f"{line}\n" for line in _lines(comparison))


def _lines(comparison: Comparison) -> Iterator[str]:
    for names, sign in ((comparison.removed, "-"), (comparison.added, "+")):
        yield from (f"{sign} robot {visible(name)}" for name in names)
    for robot in comparison.robots:
        if robot.changes and len(comparison.robots) > 1:
            yield visible(robot.name)
        for area, changes in by_area(robot):
            yield f"{area}:"
            yield from (f"  {_SIGNS[change.kind]} {_sentence(change)}" for change in changes)
        if not robot.complete:
            yield f"{visible(robot.name)}: {_incomplete(robot)}"
    yield f"{_counted(comparison)} from {visible(comparison.before)} to {visible(comparison.after)}"


def _sentence(change: RobotChange) -> str:
    before, after = values(change)
    where = visible(change.address)
    if change.kind in {"added", "removed"}:
        said = after if change.kind == "added" else before
        return f"{where} {change.kind}" + (f": {said}" if said else "")
    if change.kind == "renamed":
        return f"{where} renamed, before: {before}"
    return f"{where}: {before} → {after}"


# -- Markdown, HTML, JSON --------------------------------------------------------------------------------------------


def _markdown(comparison: Comparison) -> str:
    lines = [f"### Robot: {_counted(comparison)}", ""]
    for names, what in ((comparison.removed, "Removed"), (comparison.added, "Added")):
        lines += [f"- {what}: {_code(name)}" for name in names] + ([""] if names else [])
    for robot in comparison.robots:
        if robot.changes:
            lines += [f"**{_code(robot.name)}**", "", "| | Part | Before | After |", "|---|---|---|---|"]
            lines += [_row(area, change) for area, found in by_area(robot) for change in found] + [""]
        if not robot.complete:
            lines += [f"{_code(robot.name)}: {_incomplete(robot)}.", ""]
    return "\n".join([*lines, f"From {_code(comparison.before)} to {_code(comparison.after)}."]) + "\n"


def _row(area: str, change: RobotChange) -> str:
    before, after = (_code(value) if value and value != "none" else "" for value in values(change))
    what = f"{area}, {change.kind}" if change.kind != "changed" else area
    return f"| {what} | {_code(change.address)} | {before} | {after} |"


def _code(text: str) -> str:
    """A text as code in a table of Markdown, in which nothing of it is Markdown or HTML."""
    shown = visible(text)
    if "`" in shown or "|" in shown:  # they would end the code, or the cell
        return f"<code>{''.join(letter if letter.isalnum() else f'&#{ord(letter)};' for letter in shown)}</code>"
    return f"`{shown}`" if shown else ""


def _html(comparison: Comparison) -> str:
    robots = [
        {
            "name": robot.name,
            "note": _incomplete(robot),
            "areas": [
                {"name": area, "changes": [(change.kind, change.address, *values(change)) for change in found]}
                for area, found in by_area(robot)
            ],
        }
        for robot in comparison.robots
    ]
    return page("diff", title=f"Robot: {_counted(comparison)}", comparison=comparison, robots=robots)


def _json(comparison: Comparison) -> str:
    robots: list[dict[str, Any]] = [
        {
            "name": robot.name,
            "complete": robot.complete,
            "changes": [{**change._asdict(), "path": change.address} for change in robot.changes],
        }
        for robot in comparison.robots
    ]
    found = {
        "version": 1,
        "before": comparison.before,
        "after": comparison.after,
        "robots": robots,
        "removed": list(comparison.removed),
        "added": list(comparison.added),
    }
    return as_json(found, 1) + "\n"
