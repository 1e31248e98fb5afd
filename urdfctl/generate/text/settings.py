"""Write parameters as nested YAML, each with its comment."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from urdfctl.generate.text.scalars import one_line, yaml_text, yaml_value
from urdfctl.startup.records import NamedTuple

_WIDE = 100


class WrittenParameter(NamedTuple):
    """A parameter: its name in the catalogue, its path in the file, its value, and a comment."""

    name: str
    path: tuple[str, ...]
    value: object
    comment: str = ""


def lines_of(settings: Iterable[WrittenParameter]) -> list[str]:
    """Return the parameters as lines of YAML, without indentation at the top level."""
    tree: dict[str, Any] = {}
    for setting in settings:
        below = tree
        for part in setting.path[:-1]:
            below = below.setdefault(part, {})
        below[setting.path[-1]] = setting
    return list(_lines(tree, ""))


def _lines(tree: dict[str, Any], indent: str) -> Iterator[str]:
    for key, below in tree.items():
        if isinstance(below, dict):
            yield f"{indent}{yaml_text(key)}:"
            yield from _lines(below, f"{indent}  ")
            continue
        comment = f"  # {one_line(below.comment)}" if below.comment else ""
        flow = f"{indent}{yaml_text(key)}: {yaml_value(below.value)}"
        if isinstance(below.value, list) and len(flow) > _WIDE:
            yield f"{indent}{yaml_text(key)}:{comment}"
            yield from (f"{indent}  - {yaml_value(part)}" for part in below.value)
        else:
            yield flow + comment
