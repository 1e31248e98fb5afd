"""The table of changes between two distros, from the steps themselves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.catalog.distros import generation
from urdfctl.migrate.step import Row, Step
from urdfctl.migrate.wishes import Wishes


def rows(steps: Sequence[Step], wishes: Wishes) -> Iterator[tuple[Step, Row]]:
    """Yield the changes that a migration between two distros may make, each with its step, in order."""
    for step in steps:
        if (wishes.only and step.part not in wishes.only) or (
            step.generation == 1 and wishes.source is not None and generation(wishes.source) != 1
        ):
            continue
        for row in step.rows:
            if not row.since or wishes.crosses(row.since):
                yield step, row


def table(steps: Sequence[Step], wishes: Wishes) -> str:
    """Return the changes as text, one line each: part, old form, new form, authority."""
    found = [
        (step.part.value, row.old, row.new or "(dropped)", row.since or "ROS 2", row.authority)
        for step, row in rows(steps, wishes)
    ]
    widths = [max((len(line[column]) for line in found), default=0) for column in range(4)]
    lines = (
        "  ".join([*(cell.ljust(width) for cell, width in zip(line, widths, strict=False)), line[4]]) for line in found
    )
    return "".join(f"{line.rstrip()}\n" for line in lines)
