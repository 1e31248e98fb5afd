"""JSON Schema of parameters: their types, ranges and descriptions, as the tree that their dotted names make."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.validators import requirement
from urdfctl.catalog.value_types import is_strict_about_doubles, type_problem

Schema = dict[str, Any]

ROS_TYPE = "x-ros-type"
"""A keyword beside JSON Schema's: the types of ROS 2 that a value can have. JSON does not tell 1 from 1.0; ROS does."""
PLAIN_VALUE = "#/$defs/value"

_TYPES: Mapping[str, Schema] = {
    "bool": {"type": "boolean"},
    "int": {"type": "integer"},
    "double": {"type": "number"},
    "string": {"type": "string"},
    "struct": {"type": "object"},
}
_VALIDATORS: Mapping[str, Callable[[Any], Schema]] = {
    "bounds": lambda limit: {"minimum": limit[0], "maximum": limit[1]},
    "lt": lambda limit: {"exclusiveMaximum": limit},
    "gt": lambda limit: {"exclusiveMinimum": limit},
    "lt_eq": lambda limit: {"maximum": limit},
    "gt_eq": lambda limit: {"minimum": limit},
    "lt_eq_or_nan": lambda limit: {"maximum": limit},
    "gt_eq_or_nan": lambda limit: {"minimum": limit},
    "nonzero": lambda _: {"not": {"const": 0}},
    "fixed_size": lambda limit: _size(limit, limit),
    "size_gt": lambda limit: _size(limit + 1, None),
    "size_lt": lambda limit: _size(None, limit - 1),
    "not_empty": lambda _: _size(1, None),
    "unique": lambda _: {"uniqueItems": True},
    "element_bounds": lambda limit: {"items": {"minimum": limit[0], "maximum": limit[1]}},
    "lower_element_bounds": lambda limit: {"items": {"minimum": limit}},
    "upper_element_bounds": lambda limit: {"items": {"maximum": limit}},
    "one_of": lambda limit: {"enum": list(limit)},
    "subset_of": lambda limit: {"items": {"enum": list(limit)}},
}
_PLACEHOLDER = re.compile(r"<[^<>]+>")


def parameter_schema(parameter: ParameterEntry, distro: str) -> Schema:
    """Return the schema of a parameter's value, with its description and its default."""
    schema = value_schema(parameter)
    if parameter.default is not None and type_problem(parameter.default, parameter, distro) is None:
        schema["default"] = parameter.default
    if parameter.deprecated:
        schema["deprecated"] = True
    schema["description"] = _description(parameter, distro)
    return schema


def value_schema(parameter: ParameterEntry) -> Schema:
    """Return the schema of a parameter's value, without what only a reader needs."""
    kinds = parameter.types
    if "none" in kinds or parameter.ignored:
        return {}
    forms = [_form(kind) for kind in kinds]
    schema: Schema = forms[0] if len(forms) == 1 else {"anyOf": forms}
    if not parameter.lenient:
        schema[ROS_TYPE] = list(kinds)
    limits = limits_schema(parameter)
    if schema.keys().isdisjoint(limits):
        return {**schema, **limits}
    return {**schema, "allOf": [limits]}


def limits_schema(parameter: ParameterEntry) -> Schema:
    """Return the schema of what a parameter's validators accept."""
    limits = [_VALIDATORS[name](limit) for name, limit in parameter.validators.items()]
    return limits[0] if len(limits) == 1 else {"allOf": limits} if limits else {}


def tree_schema(parameters: Iterable[tuple[str, Schema]], required: Iterable[str] = ()) -> Schema:
    """Return the schema of a map with dotted parameters, which can be written as nested maps or with their dots.

    required: the dotted names of the parameters that must be there; those with a placeholder are left out.
    """
    listed = list(parameters)
    schema = _level([(name.split("."), value) for name, value in listed])
    schema.pop("minProperties", None)
    dotted = {name: value for name, value in listed if "." in name and not _PLACEHOLDER.search(name)}
    schema["properties"] = {**schema.get("properties", {}), **dotted}
    needed = [name for name in required if not _PLACEHOLDER.search(name)]
    plain = [name for name in needed if "." not in name]
    if plain:
        schema["required"] = plain
    written = [{"anyOf": [{"required": [name]}, _nested(name.split("."))]} for name in needed if "." in name]
    if written:
        schema["allOf"] = written
    return schema


def _level(parts: list[tuple[list[str], Schema]]) -> Schema:
    below: dict[str, list[tuple[list[str], Schema]]] = {}
    for names, value in parts:
        below.setdefault(names[0], []).append((names[1:], value))
    schemas = {name: _one(found) for name, found in below.items()}
    named = {name: schema for name, schema in schemas.items() if not _PLACEHOLDER.search(name)}
    mapped = {_pattern(name, named): schema for name, schema in schemas.items() if _PLACEHOLDER.search(name)}
    return {
        "minProperties": 1,
        **({"properties": named} if named else {}),
        **({"patternProperties": mapped} if mapped else {}),
    }


def _one(found: list[tuple[list[str], Schema]]) -> Schema:
    """The schema of one name: that of its value, or of the map below it, or of either."""
    own = [value for names, value in found if not names]
    deeper = [(names, value) for names, value in found if names]
    if not own:
        return _level(deeper)
    return own[0] if not deeper else {"anyOf": [own[0], {"type": "object", **_level(deeper)}]}


def _pattern(name: str, others: Iterable[str]) -> str:
    """The pattern of a name with a placeholder: any text in its place, but not the name of another parameter."""
    known = "|".join(re.escape(other) for other in others)
    before, _, rest = name.partition("<")
    after = rest.partition(">")[2]
    return f"^{f'(?!(?:{known})$)' if known else ''}{re.escape(before)}.+{re.escape(after)}$"


def _nested(names: list[str]) -> Schema:
    first, *rest = names
    return {"required": [first], **({"properties": {first: _nested(rest)}} if rest else {})}


def _form(kind: str) -> Schema:
    plain = kind.removesuffix("_array")
    return dict(_TYPES[plain]) if plain == kind else {"type": "array", "items": dict(_TYPES[plain])}


def _size(least: int | None, most: int | None) -> Schema:
    """The limits of the size of a list or text; each keyword concerns only its own type."""
    limits: Schema = {} if least is None else {"minItems": least, "minLength": least}
    return limits if most is None else {**limits, "maxItems": most, "maxLength": most}


def _description(parameter: ParameterEntry, distro: str) -> str:
    words = [f"{parameter.type.replace('|', 'or')}{', required' if parameter.needed else ''}"]
    words += [requirement(name, limit) for name, limit in {**parameter.validators, **parameter.useful}.items()]
    sentences = ["; ".join(words)]
    if is_strict_about_doubles(parameter, distro) and not parameter.lenient:
        sentences.append("write 1.0 instead of 1: an integer is rejected")
    if parameter.ignored:
        sentences.append("documented, but never read")
    if parameter.deprecated or parameter.replacement:
        instead = f"; use {parameter.replacement}" if parameter.replacement else ""
        sentences.append(f"deprecated{instead}")
    if parameter.since:
        sentences.append(f"since {parameter.since}")
    if parameter.note:
        sentences.append(parameter.note)
    return ". ".join(sentences)
