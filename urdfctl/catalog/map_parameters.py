"""Parameters that stand for one parameter for each element of another: `gains.<joints>.p`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache

from urdfctl.catalog.entries import FormerParameter, Parameter
from urdfctl.catalog.values import elements, is_known
from urdfctl.memory import once_per_object

_PLACEHOLDER = re.compile(r"<([^<>]+)>")


def expanded(name: str, values: Mapping[str, object]) -> tuple[str, ...]:
    """The names that a parameter's name stands for, given the values: `gains.<joints>.p` for each of the joints.

    Elements that are not known, and no texts, are left out.
    """
    placeholder = _PLACEHOLDER.search(name)
    if placeholder is None:
        return (name,)
    named = (part for part in elements(values.get(placeholder[1])) if isinstance(part, str) and is_known(part))
    return tuple(
        whole
        for element in dict.fromkeys(named)
        for whole in expanded(name[: placeholder.start()] + element + name[placeholder.end() :], values)
    )


def expected(parameters: Mapping[str, Parameter], values: Mapping[str, object]) -> dict[str, Parameter]:
    """The parameters by the full names that they have with these values."""
    filled = {**{name: parameter.default for name, parameter in parameters.items()}, **values}
    return {whole: parameter for name, parameter in parameters.items() for whole in expanded(name, filled)}


def matching(
    name: str, parameters: Mapping[str, Parameter] | Mapping[str, FormerParameter]
) -> tuple[str, str | None] | None:
    """The parameter that a full name may be of, and the element that it has for the placeholder.

    `gains.elbow.p` is of `gains.<joints>.p` for `elbow`, be it one of the joints or not. A parameter of type `none`
    takes all that stands below it.
    """
    if name in parameters:
        return name, None
    for pattern, below in _patterns(parameters):
        found = _found(pattern, name, below=below)
        if found is not None:
            return pattern, found or None
    return None


@once_per_object
def _patterns(parameters: Mapping[str, Parameter] | Mapping[str, FormerParameter]) -> list[tuple[str, bool]]:
    """The names that others may be meant by, and whether all that stands below them is."""
    below = {name: getattr(parameter, "type", None) == "none" for name, parameter in parameters.items()}
    return [(name, free) for name, free in below.items() if free or "<" in name]


def _found(pattern: str, name: str, *, below: bool) -> str | None:
    """What a name has for the first placeholder of a pattern, empty where that has none; None where it is not of it."""
    before, placeholder, rest = pattern.partition("<")
    if not name.startswith(before):
        return None
    after = rest.partition(">")[2]
    if below or "<" in after:
        found = _regex(pattern, below).fullmatch(name)
        return None if found is None else found[1] if placeholder else ""
    is_of_it = name.endswith(after) and len(name) > len(before) + len(after)
    return name[len(before) : len(name) - len(after)] if is_of_it else None


def prefixes(parameters: Iterable[str]) -> frozenset[str]:
    """What stands before dots in the names: of `constraints.<joints>.goal` `constraints` and `constraints.<joints>`."""
    cut = (name.split(".") for name in parameters)
    return frozenset(".".join(parts[:size]) for parts in cut for size in range(1, len(parts)))


@lru_cache(maxsize=512)
def _regex(pattern: str, below: bool) -> re.Pattern[str]:  # noqa: FBT001
    parts = _PLACEHOLDER.split(pattern)
    text = "".join("(.+)" if index % 2 else re.escape(part) for index, part in enumerate(parts))
    return re.compile(text + (r"(?:\..*)?" if below else ""))
