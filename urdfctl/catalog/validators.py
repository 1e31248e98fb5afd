"""Validators of parameter values; their names are those of generate_parameter_library."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from urdfctl.catalog.values import elements, is_known, is_list

Broken = Callable[[Any, Any], bool]


def problem(value: object, validators: Mapping[str, object]) -> str | None:
    """Return the message of the first validator that a value breaks, e.g. `must be > 0.0`; None if all accept it.

    An unknown value breaks no validator, nor does a value of a type that the validator is not for.
    """
    if not is_known(value):
        return None
    for name, limit in validators.items():
        if _broken(name, value, limit):
            return requirement(name, limit)
    return None


def _broken(name: str, value: object, limit: Any) -> bool:
    if name in _OF_NUMBER:
        return _is_number(value) and _OF_NUMBER[name](value, limit)
    if name in _OF_SIZE:
        return (is_list(value) or isinstance(value, str)) and _OF_SIZE[name](len(value), limit)  # type: ignore[arg-type]
    if name in _OF_ELEMENT:
        return is_list(value) and any(_is_number(e) and _OF_ELEMENT[name](e, limit) for e in elements(value))
    if name == "one_of":
        return not is_list(value) and value not in limit
    if name == "subset_of":
        return is_list(value) and any(element not in limit for element in elements(value))
    if name == "unique":
        return is_list(value) and _has_twice(elements(value))
    raise ValueError(f"no such validator: '{name}'")


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _has_twice(parts: tuple[object, ...]) -> bool:
    return any(part in parts[:index] for index, part in enumerate(parts))


def requirement(name: str, limit: Any) -> str:
    """Return what a validator asks for, e.g. `must be > 0.0`."""
    if name in ("one_of", "subset_of"):
        *most, last = [f"'{choice}'" if isinstance(choice, str) else str(choice) for choice in limit]
        choices = f"{', '.join(most)} or {last}" if most else last
        return f"must be {choices}" if name == "one_of" else f"can contain only {choices}"
    if name in ("bounds", "element_bounds"):
        return _WORDS[name].format(*limit)
    message = _WORDS[name].format(limit)
    return message.removesuffix("s") if name in _OF_SIZE and limit == 1 else message


_OF_NUMBER: Mapping[str, Broken] = {
    "bounds": lambda value, limit: not limit[0] <= value <= limit[1],
    "lt": lambda value, limit: not value < limit,
    "gt": lambda value, limit: not value > limit,
    "lt_eq": lambda value, limit: not value <= limit,
    "gt_eq": lambda value, limit: not value >= limit,
    "gt_eq_or_nan": lambda value, limit: not (math.isnan(value) or value >= limit),
    "lt_eq_or_nan": lambda value, limit: not (math.isnan(value) or value <= limit),
    "nonzero": lambda value, _: value == 0,
}
_OF_SIZE: Mapping[str, Broken] = {
    "fixed_size": lambda size, limit: size != limit,
    "size_gt": lambda size, limit: not size > limit,
    "size_lt": lambda size, limit: not size < limit,
    "not_empty": lambda size, _: size == 0,
}
_OF_ELEMENT: Mapping[str, Broken] = {
    "element_bounds": lambda value, limit: not limit[0] <= value <= limit[1],
    "lower_element_bounds": lambda value, limit: not value >= limit,
    "upper_element_bounds": lambda value, limit: not value <= limit,
}
_WORDS: Mapping[str, str] = {
    "bounds": "must be between {} and {}",
    "lt": "must be < {}",
    "gt": "must be > {}",
    "lt_eq": "must be ≤ {}",
    "gt_eq": "must be ≥ {}",
    "gt_eq_or_nan": "must be ≥ {} (or .nan for no limit)",
    "lt_eq_or_nan": "must be ≤ {} (or .nan for no limit)",
    "nonzero": "must not be 0",
    "fixed_size": "must have exactly {} elements",
    "size_gt": "must have more than {} elements",
    "size_lt": "must have fewer than {} elements",
    "not_empty": "must not be empty",
    "unique": "must not contain duplicates",
    "element_bounds": "can contain only numbers between {} and {}",
    "lower_element_bounds": "can contain only numbers ≥ {}",
    "upper_element_bounds": "can contain only numbers ≤ {}",
}
NAMES = frozenset({*_WORDS, "one_of", "subset_of"})
