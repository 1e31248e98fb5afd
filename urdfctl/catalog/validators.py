"""What a parameter's validators say of a value; their names are those of generate_parameter_library."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from urdfctl.catalog.values import elements, is_known, is_list
from urdfctl.hints import Any

Broken = Callable[[Any, Any], bool]


def problem(value: object, validators: Mapping[str, object]) -> str | None:
    """What the first validator that a value breaks says of it: `must be greater than 0.0`. None where all hold.

    A value of another type than a validator is for, and one that is not known, breaks none.
    """
    if not is_known(value):
        return None
    for name, limit in validators.items():
        if _broken(name, value, limit):
            return _said(name, limit)
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


def _said(name: str, limit: Any) -> str:
    if name in ("one_of", "subset_of"):
        *most, last = [f"'{choice}'" if isinstance(choice, str) else str(choice) for choice in limit]
        choices = f"{', '.join(most)} or {last}" if most else last
        return f"must be {choices}" if name == "one_of" else f"may only hold {choices}"
    if name in ("bounds", "element_bounds"):
        return _WORDS[name].format(*limit)
    return _WORDS[name].format(limit)


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
    "bounds": "must be from {} to {}",
    "lt": "must be less than {}",
    "gt": "must be greater than {}",
    "lt_eq": "must be at most {}",
    "gt_eq": "must be at least {}",
    "gt_eq_or_nan": "must be at least {}, or .nan for none",
    "lt_eq_or_nan": "must be at most {}, or .nan for none",
    "nonzero": "must not be 0",
    "fixed_size": "must have exactly {} elements",
    "size_gt": "must have more than {} elements",
    "size_lt": "must have fewer than {} elements",
    "not_empty": "must not be empty",
    "unique": "must not name anything twice",
    "element_bounds": "may only hold numbers from {} to {}",
    "lower_element_bounds": "may only hold numbers of at least {}",
    "upper_element_bounds": "may only hold numbers of at most {}",
}
NAMES = frozenset({*_WORDS, "one_of", "subset_of"})
