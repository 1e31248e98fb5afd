"""Map parameters: one name for a parameter per element of another parameter, such as `gains.<joints>.p`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache

from urdfctl.catalog.entries import FormerParameter, ParameterEntry
from urdfctl.catalog.values import elements, is_known
from urdfctl.startup.per_object import once_per_object

_PLACEHOLDER = re.compile(r"<([^<>]+)>")


def expanded(name: str, values: Mapping[str, object]) -> tuple[str, ...]:
    """Return the full names of a map parameter for these values: `gains.<joints>.p` with each of the joints.

    Elements that are unknown or not strings are left out.
    """
    placeholder = _PLACEHOLDER.search(name)
    if placeholder is None:
        return (name,)
    names = (item for item in elements(values.get(placeholder[1])) if isinstance(item, str) and is_known(item))
    return tuple(
        full_name
        for element in dict.fromkeys(names)
        for full_name in expanded(name[: placeholder.start()] + element + name[placeholder.end() :], values)
    )


def expected(parameters: Mapping[str, ParameterEntry], values: Mapping[str, object]) -> dict[str, ParameterEntry]:
    """Return the parameters by the full names that they have with these values, or with the defaults."""
    effective = {**{name: parameter.default for name, parameter in parameters.items()}, **values}
    return {full: parameter for name, parameter in parameters.items() for full in expanded(name, effective)}


def matching(
    name: str, parameters: Mapping[str, ParameterEntry] | Mapping[str, FormerParameter]
) -> tuple[str, str | None] | None:
    """Return the parameter that a full name belongs to, and the element in place of its placeholder; None if no match.

    `gains.elbow.p` belongs to `gains.<joints>.p` with `elbow`, whether that is one of the joints or not. A parameter of
    type `none` matches every name below it.
    """
    if name in parameters:
        return name, None
    for pattern, below in _patterns(parameters):
        element = _element_in(pattern, name, below=below)
        if element is not None:
            return pattern, element or None
    return None


@once_per_object
def _patterns(parameters: Mapping[str, ParameterEntry] | Mapping[str, FormerParameter]) -> list[tuple[str, bool]]:
    """The parameters that match more than their own name, and whether each matches every name below it."""
    below = {name: getattr(parameter, "type", None) == "none" for name, parameter in parameters.items()}
    return [(name, free_form) for name, free_form in below.items() if free_form or "<" in name]


def _element_in(pattern: str, name: str, *, below: bool) -> str | None:
    """The part of a name that matches a pattern's first placeholder; empty without a placeholder, None if no match."""
    before, placeholder, rest = pattern.partition("<")
    if not name.startswith(before):
        return None
    after = rest.partition(">")[2]
    if below or "<" in after:
        match = _regex(pattern, below).fullmatch(name)
        return None if match is None else match[1] if placeholder else ""
    matches = name.endswith(after) and len(name) > len(before) + len(after)
    return name[len(before) : len(name) - len(after)] if matches else None


def prefixes(parameters: Iterable[str]) -> frozenset[str]:
    """Return all prefixes of dotted names: `constraints` and `constraints.<joints>` for `constraints.<joints>.goal`."""
    split = (name.split(".") for name in parameters)
    return frozenset(".".join(parts[:size]) for parts in split for size in range(1, len(parts)))


@lru_cache(maxsize=512)
def _regex(pattern: str, below: bool) -> re.Pattern[str]:  # noqa: FBT001
    parts = _PLACEHOLDER.split(pattern)
    text = "".join("(.+)" if index % 2 else re.escape(part) for index, part in enumerate(parts))
    return re.compile(text + (r"(?:\..*)?" if below else ""))
