"""The table of changes between two distros, from the steps themselves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from textwrap import wrap

from urdfctl.catalog.distros import generation
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.step import Row, Step

_WIDTH = 120


def rows(steps: Sequence[Step], options: MigrationOptions) -> Iterator[tuple[Step, Row]]:
    """Yield the changes that a migration between two distros may make, each with its step, in order."""
    for step in steps:
        if not options.takes(step.name, step.part) or (
            step.generation == 1 and options.source is not None and generation(options.source) != 1
        ):
            continue
        for row in step.rows:
            if not row.since or options.crosses(row.since):
                yield step, row


def table(steps: Sequence[Step], options: MigrationOptions) -> str:
    """Return the changes as text: below each step and its part, the old forms, the new ones, and their authority."""
    lines: list[str] = []
    for name, same in groupby(rows(steps, options), key=lambda found: found[0].name):
        found = list(same)
        step = found[0][0]
        count = f"{len(found)} change{'s' * (len(found) != 1)}"
        lines += ["", f"{step.summary}: step '{name}', part '{step.part.value}', {count}"]
        for authority, its in groupby((row for _, row in found), key=lambda row: row.authority):
            for row in its:
                since = f"  (since {row.since})" if row.since else ""
                lines += _wrapped(f"{row.old} -> {row.new or '(dropped)'}{since}", "  ")
            lines += _wrapped(authority, "    = ")
    return "".join(f"{line}\n" for line in lines[1:])


def _wrapped(text: str, lead: str) -> list[str]:
    """The lines of a text; the further ones are indented more."""
    more = " " * (len(lead) + 4)
    return wrap(text, _WIDTH, initial_indent=lead, subsequent_indent=more, break_on_hyphens=False) or [lead]
