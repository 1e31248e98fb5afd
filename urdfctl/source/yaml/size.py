"""Limit the size of a YAML text with its aliases expanded.

A small text can expand without limit, or crash its reader by deep nesting.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from urdfctl.source.budget import OverBudget

_MOST_DEPTH = 64
_MOST_NODES = 200_000
_CHARACTERS_A_NODE = 64
_HARMLESS_BYTES = 4096
_OPENINGS = (b"[", b"{", b"- ", b"? ")
_HARMLESS_OPENINGS = 150
"""A reader calls itself a few times for each level, and Python allows it a thousand calls."""

TOO_DEEP = "exceeded maximum nesting depth"
"""What newer libyaml says of a text that is nested a thousand deep, before any of it is an event."""
_NESTED = f"the YAML file is nested more than {_MOST_DEPTH} deep"


def check_size(text: bytes) -> None:
    """Raise OverBudget if a YAML text is nested more than 64 deep, or expands to more than 200 000 nodes.

    A short text that neither repeats anything nor can be nested very deep is not parsed for that.
    """
    if len(text) < _HARMLESS_BYTES and b"*" not in text and sum(map(text.count, _OPENINGS)) < _HARMLESS_OPENINGS:
        return
    from urdfctl.startup.lazy_yaml import SAFE_LOADER, yaml

    try:
        _count(yaml.parse(text, SAFE_LOADER))
    except yaml.MarkedYAMLError as error:
        if TOO_DEEP not in str(error):
            raise
        raise OverBudget(_NESTED) from None


def _count(events: Iterable[Any]) -> None:
    from urdfctl.startup.lazy_yaml import yaml

    total = 0
    sizes: dict[str | None, int] = {}
    opened: list[tuple[str | None, int]] = []
    for event in events:
        if isinstance(event, yaml.AliasEvent):
            total += sizes.get(event.anchor, 1)
        elif isinstance(event, yaml.ScalarEvent):
            size = 1 + len(event.value) // _CHARACTERS_A_NODE
            total += size
            sizes[event.anchor] = size
        elif isinstance(event, yaml.CollectionStartEvent):
            opened.append((event.anchor, total))
            total += 1
        elif isinstance(event, yaml.CollectionEndEvent):
            anchor, before = opened.pop()
            sizes[anchor] = total - before
        if len(opened) > _MOST_DEPTH:
            raise OverBudget(_NESTED)
        if total > _MOST_NODES:
            raise OverBudget(f"the YAML file expands to more than {_MOST_NODES} nodes")
