"""Check that a value has the type of its parameter, by the rules of ROS 1 and ROS 2."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from urdfctl.catalog.distros import generation, since
from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.values import elements, is_known, is_list

_STRICT_WITH_DOUBLES = since("galactic")
"""Distros in which a double parameter does not accept an integer: from galactic on, rclcpp types are static."""


def type_problem(value: object, parameter: ParameterEntry, distro: str) -> str | None:
    """Return the message on a value of the wrong type: `must be a list of strings, not the string 'a'`, or None.

    The type of an unknown value is not checked. ROS 1 accepts integers as doubles and, rounded, doubles as integers;
    ROS 2 accepts neither.
    """
    kinds = parameter.types
    for kind in kinds:
        if kind not in _WORDS or _fits(value, kind, parameter, distro):
            return None
    if not is_known(value):
        return None
    wanted = " or ".join(_wanted(kind, parameter, distro) for kind in kinds)
    return f"must be {wanted}, not {_with_type(value)}"


def shown(value: object) -> str:
    """Return a single value as messages show it: `2.7`, `'position'`, `true`."""
    return f"'{value}'" if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else str(value)


def _with_type(value: object) -> str:
    """A value with its type: `the integer 1`, `a list of strings`."""
    if is_list(value):
        words = dict.fromkeys(_element_word(part) for part in elements(value))
        return f"a list of {' and '.join(words)}" if words else "an empty list"
    if isinstance(value, Mapping):
        return "a map"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return f"the string '{value}'"
    return f"the {'integer' if isinstance(value, int) else 'number'} {value}" if value is not None else "empty"


def _element_word(part: object) -> str:
    for kind, word in (("string", "strings"), ("bool", "booleans"), ("int", "integers"), ("double", "numbers")):
        if _PLAIN[kind](part):
            return word
    return "lists" if is_list(part) else "maps" if isinstance(part, Mapping) else "empty elements"


def _fits(value: object, kind: str, parameter: ParameterEntry, distro: str) -> bool:
    plain = kind.removesuffix("_array")
    if kind == "struct_array":
        return is_list(value) and all(isinstance(part, Mapping) for part in elements(value))
    if kind != plain:
        return is_list(value) and all(_fits(part, plain, parameter, distro) for part in elements(value))
    if kind == "double" and not _strict(parameter, distro):
        return _PLAIN["double"](value) or _PLAIN["int"](value)
    if kind == "int" and generation(distro) == 1:
        return _PLAIN["double"](value) or _PLAIN["int"](value)
    return _PLAIN[kind](value)


def is_strict_about_doubles(parameter: ParameterEntry, distro: str) -> bool:
    """Return whether a parameter takes doubles, or lists of them, and rejects integers."""
    kinds = {kind.removesuffix("_array") for kind in parameter.types}
    return "double" in kinds and "int" not in kinds and _strict(parameter, distro)


def _strict(parameter: ParameterEntry, distro: str) -> bool:
    return parameter.floats_only or distro in _STRICT_WITH_DOUBLES


def _wanted(kind: str, parameter: ParameterEntry, distro: str) -> str:
    strict = kind.startswith("double") and _strict(parameter, distro)
    return f"{_WORDS[kind]} with a decimal point" if strict else _WORDS[kind]


_PLAIN: Mapping[str, Callable[[object], bool]] = {
    "bool": lambda value: isinstance(value, bool),
    "int": lambda value: isinstance(value, int) and not isinstance(value, bool),
    "double": lambda value: isinstance(value, float),
    "string": lambda value: isinstance(value, str),
}
_WORDS = {
    "bool": "true or false",
    "int": "an integer",
    "double": "a number",
    "string": "a string",
    "bool_array": "a list of booleans",
    "int_array": "a list of integers",
    "double_array": "a list of numbers",
    "string_array": "a list of strings",
    "struct_array": "a list of maps",
}
