"""The report of a migration: what was done, what was decided, and what a person must do."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence

from urdfctl.migrate.step import EntryKind
from urdfctl.startup.records import NamedTuple

_TITLES = {
    EntryKind.DONE: "Done",
    EntryKind.DECIDED: "Decided",
    EntryKind.FOR_YOU: "For you",
}


class ReportLine(NamedTuple):
    """An entry of the report with its place after the migration.

    step: the name of the step that it comes from.
    file: the real path; empty if it is about no file.
    line: from 1; 0 if it is about the whole file.
    authority, option: as in `Entry`.
    """

    kind: EntryKind
    message: str
    step: str = ""
    file: str = ""
    line: int = 0
    authority: str = ""
    option: str = ""


def as_json(lines: Sequence[ReportLine], source: str | None, target: str, base: str) -> str:
    """Return the report as JSON, with paths relative to the folder `base`."""
    data = {
        "from": source,
        "to": target,
        **{
            kind.value.replace(" ", "_"): [
                {**one._asdict(), "kind": kind.value, "file": _relative(one.file, base)} for one in _of(kind, lines)
            ]
            for kind in EntryKind
        },
    }
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


def as_markdown(lines: Sequence[ReportLine], source: str | None, target: str, base: str) -> str:
    """Return the report as Markdown, with paths relative to the folder `base`."""
    parts = [f"# Migration {f'from {source} ' if source else ''}to {target}", ""]
    for kind, title in _TITLES.items():
        own = list(_of(kind, lines))
        parts += [f"## {title}", "", *(_item(line, base) for line in own), *([] if own else ["Nothing."]), ""]
    return "\n".join(parts)


def _of(kind: EntryKind, lines: Sequence[ReportLine]) -> Iterator[ReportLine]:
    return (line for line in sorted(lines, key=lambda one: (one.file, one.line)) if line.kind is kind)


def _item(line: ReportLine, base: str) -> str:
    where = f"{_relative(line.file, base)}{f':{line.line}' if line.line else ''}" if line.file else ""
    option = f" Alternative: `{line.option}`." if line.option else ""
    authority = f" ({line.authority})" if line.authority else ""
    return f"- {f'`{where}`: ' if where else ''}{line.message}.{option}{authority}"


def _relative(path: str, base: str) -> str:
    return os.path.relpath(path, base).replace(os.sep, "/") if path else ""
