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
        groups: dict[tuple[str, ...], list[ReportLine]] = {}
        for line in _of(kind, lines):
            groups.setdefault((line.message, line.option, line.authority), []).append(line)
        items = [text for group in groups.values() for text in _item(group, base)]
        parts += [f"## {title}", "", *(items or ["Nothing."]), ""]
    return "\n".join(parts)


def _of(kind: EntryKind, lines: Sequence[ReportLine]) -> Iterator[ReportLine]:
    return (line for line in sorted(lines, key=lambda one: (one.file, one.line)) if line.kind is kind)


def _item(lines: Sequence[ReportLine], base: str) -> Iterator[str]:
    """Yield the lines of an item about one or more places."""
    line = lines[0]
    option = f" Alternative: `{line.option}`." if line.option else ""
    authority = f" ({line.authority})" if line.authority else ""
    text = f"{line.message}.{option}{authority}"
    places = list(dict.fromkeys(_place(line, base) for line in lines if line.file))
    if len(places) < 2:  # noqa: PLR2004 (one place is in the same line)
        yield f"- {f'`{places[0]}`: ' if places else ''}{text}"
    else:
        yield f"- {text}"
        yield from (f"  - `{place}`" for place in places)


def _place(line: ReportLine, base: str) -> str:
    return f"{_relative(line.file, base)}{f':{line.line}' if line.line else ''}"


def _relative(path: str, base: str) -> str:
    return os.path.relpath(path, base).replace(os.sep, "/") if path else ""
