"""The report of a migration: what was done, what was decided, and what a person must do."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Sequence

from urdfctl.migrate.step import EntryKind
from urdfctl.names import shortened
from urdfctl.startup.records import NamedTuple

_TITLES = {
    EntryKind.DONE: "Done",
    EntryKind.DECIDED: "Decided",
    EntryKind.FOR_YOU: "For you",
}


NOT_CHANGED = "not changed by step"
"""How the lines begin about a step that was left out of a file."""
NOT_READ = "the file is not migrated"
"""How the lines begin about a file that cannot be read."""
_QUOTED = re.compile(r"'([^'\n]*)'")
_FEWEST_SIMILAR = 3
_MOST_NAMES, _MOST_PLACES = 4, 6
_PLURAL = {" is not ": " are not ", " is kept ": " are kept ", " has ": " have ", " exists ": " exist "}
_SINGULAR = re.compile(rf"\A(?:{'|'.join(_PLURAL)})")
_NOUNS = frozenset({"controller", "joint", "material", "model", "node", "parameter", "plugin", "sensor"})


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


def as_json(
    lines: Sequence[ReportLine], source: str | None, target: str, base: str, commands: Sequence[str] = ()
) -> str:
    """Return the report as JSON, with paths relative to the folder `base`. commands: as in `as_markdown`."""
    data = {
        "from": source,
        "to": target,
        **{
            kind.value.replace(" ", "_"): [
                {**one._asdict(), "kind": kind.value, "file": _relative(one.file, base)}
                for one in _of(kind, _without_base(lines, base))
            ]
            for kind in EntryKind
        },
        "commands": list(commands),
    }
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


def as_markdown(
    lines: Sequence[ReportLine], source: str | None, target: str, base: str, commands: Sequence[str] = ()
) -> str:
    """Return the report as Markdown, with paths relative to the folder `base`.

    commands: those that build and start the result.
    """
    parts = [f"# Migration {f'from {source} ' if source else ''}to {target}", ""]
    for kind, title in _TITLES.items():
        groups: dict[tuple[str, ...], list[ReportLine]] = {}
        for line in _of(kind, _without_base(lines, base)):
            groups.setdefault((line.message, line.option, line.authority), []).append(line)
        items = [text for message, group in _similar(list(groups.values())) for text in _item(message, group, base)]
        parts += [f"## {title}", "", *(items or ["Nothing."]), ""]
    if commands:
        parts += ["## Build and start", "", "```", *commands, "```", ""]
    return "\n".join(parts)


def _without_base(lines: Sequence[ReportLine], base: str) -> list[ReportLine]:
    """The lines with the paths in their messages relative to the folder `base`, as their own places are."""
    return [line._replace(message=line.message.replace(f"{base}{os.sep}", "")) for line in lines]


def _similar(groups: Sequence[Sequence[ReportLine]]) -> Iterator[tuple[str, Sequence[ReportLine]]]:
    """Yield the groups of equal lines with their message; those as one that differ only in one name between quotes."""
    shapes: dict[tuple[object, ...], list[int]] = {}
    for index, group in enumerate(groups):
        for shape in _shapes(group[0]):
            shapes.setdefault(shape, []).append(index)
    used: set[int] = set()
    for index, group in enumerate(groups):
        if index in used:
            continue
        found = {shape: [one for one in shapes[shape] if one not in used] for shape in _shapes(group[0])}
        best = max(found, key=lambda shape: len(found[shape]), default=())
        same = found.get(best, [])
        if len(same) < _FEWEST_SIMILAR:
            yield group[0].message, group
            continue
        used.update(same)
        yield (
            _joined([groups[one][0] for one in same], int(str(best[0]))),
            [line for one in same for line in groups[one]],
        )


def _shapes(line: ReportLine) -> list[tuple[object, ...]]:
    """What the message is without each of the names in it, with the place of the name."""
    parts = _QUOTED.split(line.message)
    return [
        (at, *parts[:at], *parts[at + 1 :], line.option, line.authority) for at in range(1, len(parts), 2) if parts[at]
    ]


def _joined(lines: Sequence[ReportLine], at: int) -> str:
    """The message of lines that differ in the name at a place."""
    names = list(dict.fromkeys(_QUOTED.split(line.message)[at] for line in lines))
    parts = [f"'{part}'" if index % 2 else part for index, part in enumerate(_QUOTED.split(lines[0].message))]
    before = parts[at - 1].rstrip()
    if before.rpartition(" ")[2] in _NOUNS:
        parts[at - 1] = f"{before}s "
    parts[at] = shortened([f"'{name}'" for name in names], _MOST_NAMES)
    if at + 1 < len(parts):
        parts[at + 1] = _SINGULAR.sub(lambda verb: _PLURAL[verb[0]], parts[at + 1], count=1)
    return "".join(parts)


def _of(kind: EntryKind, lines: Sequence[ReportLine]) -> Iterator[ReportLine]:
    return (line for line in sorted(lines, key=lambda one: (one.file, one.line)) if line.kind is kind)


def _item(message: str, lines: Sequence[ReportLine], base: str) -> Iterator[str]:
    """Yield the lines of an item about one or more places. Of what is done, some places are enough."""
    line = lines[0]
    option = f" Alternative: `{line.option}`." if line.option else ""
    authority = f" ({line.authority})" if line.authority else ""
    text = f"{message}.{option}{authority}"
    places = list(dict.fromkeys(_place(line, base) for line in lines if line.file))
    if len(places) < 2:  # noqa: PLR2004 (one place is in the same line)
        yield f"- {f'`{places[0]}`: ' if places else ''}{text}"
        return
    is_long = line.kind is EntryKind.DONE and len(places) > _MOST_PLACES + 1
    shown = places[:_MOST_PLACES] if is_long else places
    yield f"- {text}"
    yield from (f"  - `{place}`" for place in shown)
    if is_long:
        yield f"  - and {len(places) - len(shown)} more places"


def _place(line: ReportLine, base: str) -> str:
    return f"{_relative(line.file, base)}{f':{line.line}' if line.line else ''}"


def _relative(path: str, base: str) -> str:
    return os.path.relpath(path, base).replace(os.sep, "/") if path else ""
