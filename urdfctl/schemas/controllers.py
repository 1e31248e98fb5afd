"""JSON Schema 2020-12 of a file with controllers, from the catalogue.

A JSON Schema cannot follow a controller's name from the controller manager's section to the controller's own section.
So a section is judged by the types that the file declares: by all rules of the type if it declares only one, by what
any of the catalogue's types accepts if it declares several. A schema for one file (`types`) knows each section's type.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Iterable, Mapping
from typing import Any

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ALL, generation
from urdfctl.catalog.entries import ControllerType, ParameterEntry, ParameterRule
from urdfctl.schemas.parameters import PLAIN_VALUE, ROS_TYPE, Schema, limits_schema, parameter_schema, tree_schema

DIALECT = "https://json-schema.org/draft/2020-12/schema"
_MANAGER = r"^(?:.*/)?controller_manager$"
_WILDCARD = r"^/?(?:.*/)?\*{1,2}$"
_PARAMETERS = "ros__parameters"
_DECLARED = "^(?:.*/)?"
_OF_EVERY_NODE = ("use_sim_time",)


def controllers_schema(distro: str, types: Mapping[str, str] | None = None) -> Schema:
    """Return the schema of controller files for a distro.

    types: the types of controllers by name, for a schema of one file.
    """
    known = [found for name in CATALOG.known_types(distro) if (found := CATALOG.controller(name, distro))]
    body = _ros2(known, distro, types or {}) if generation(distro) == 2 else _ros1(known, distro)  # noqa: PLR2004
    return {"$schema": DIALECT, "title": f"Controllers of {distro}", **body}


def _ros2(known: list[ControllerType], distro: str, types: Mapping[str, str]) -> Schema:
    of_types = {kind: _all_of("node", _key(kind)) for kind in _names(known)}
    sections = {_pattern(name): of_types[kind] for name, kind in types.items() if kind in of_types}
    node = {
        "type": "object",
        "patternProperties": {
            _MANAGER: {"$ref": "#/$defs/manager"},
            _WILDCARD: {"properties": {_PARAMETERS: {"type": "object"}}},
            **sections,
        },
        "additionalProperties": {"$ref": "#/$defs/node"},
    }
    values = {"type": "object", "additionalProperties": {"$ref": PLAIN_VALUE}}
    by_type = [*(_if_only([each.type], _key(each.type)) for each in known), _if_only(_names(known), "any")]
    return {
        **node,
        **({} if types else {"allOf": by_type}),
        "$defs": {
            "node": {**node, "minProperties": 1, "properties": {_PARAMETERS: values}},
            "value": _VALUE,
            "manager": _manager(known, distro),
            "any": _any_of(known, distro),
            **{_key(each.type): _of_type(each, distro) for each in known},
        },
    }


def _all_of(*definitions: str) -> Schema:
    return {"allOf": [{"$ref": f"#/$defs/{name}"} for name in definitions]}


def _pattern(name: str) -> str:
    return f"{_DECLARED}{re.escape(name)}$"


def _key(kind: str) -> str:
    """The name of a type's definition; a slash would part the path of a reference."""
    return kind.replace("/", ".")


def _names(known: Iterable[ControllerType]) -> list[str]:
    return [each.type for each in known]


_VALUE: Schema = {
    "description": "A value that ROS 2 can read: a scalar, a list of scalars of one type, or a map; no empty one.",
    "anyOf": [
        {"type": ["string", "number", "boolean"]},
        *({"type": "array", "minItems": 1, "items": {"type": kind}} for kind in ("string", "number", "boolean")),
        {"type": "object", "minProperties": 1, "additionalProperties": {"$ref": PLAIN_VALUE}},
    ],
}


def _manager(known: list[ControllerType], distro: str) -> Schema:
    common = CATALOG.common_parameters(distro)
    own = {**{name: common[name] for name in _OF_EVERY_NODE if name in common}, **CATALOG.manager_parameters(distro)}
    tree = tree_schema((name, parameter_schema(each, distro)) for name, each in own.items())
    keys = {name: parameter_schema(each, distro) for name, each in CATALOG.controller_keys(distro).items()}
    keys["type"] = type_schema(known, distro)
    names = "|".join(re.escape(name) for name in tree["properties"])
    return {
        "type": "object",
        "required": [_PARAMETERS],
        "properties": {
            _PARAMETERS: {
                "type": "object",
                **tree,
                "patternProperties": {
                    rf"^(?!(?:{names})$)[^.]+$": {
                        "$ref": PLAIN_VALUE,
                        "if": {"type": "object"},
                        "then": {"properties": keys},
                    },
                    r"^[^.]+\.type$": keys["type"],
                },
                "additionalProperties": {"$ref": PLAIN_VALUE},
            }
        },
    }


def type_schema(known: Iterable[ControllerType], distro: str) -> Schema:
    """Return the schema of a controller's type: one of the catalogue, or one of a package that it does not know."""
    ros = generation(distro)
    own = {kind for each in ALL if generation(each) == ros for kind, _ in CATALOG.types_of_ros_control(each)}
    other = {kind for each in ALL if generation(each) != ros for kind, _ in CATALOG.types_of_ros_control(each)}
    packages = sorted({kind.partition("/")[0] for kind in own | other if "/" in kind})
    classes = sorted({kind.partition("/")[2] for kind in own if "/" in kind})
    return {
        "type": "string",
        "minLength": 1,
        ROS_TYPE: ["string"],
        "description": f"The controller's type: a plugin that {distro} has, or one of your own packages.",
        "anyOf": [
            {"enum": sorted(_names(known))},
            {"pattern": f"^(?!(?:{'|'.join(packages)})(?:/|::|$)|(?:{'|'.join(classes)})$)"},
        ],
    }


def _of_type(controller: ControllerType, distro: str) -> Schema:
    return {
        "type": "object",
        "title": controller.type,
        "required": [_PARAMETERS],
        "properties": {_PARAMETERS: _parameters(controller, distro)},
    }


def _parameters(controller: ControllerType, distro: str) -> Schema:
    declared = {**CATALOG.common_parameters(distro), **controller.parameters}
    schemas = {name: _with_rules(each, controller, distro) for name, each in declared.items()}
    needed = {name for name, each in controller.parameters.items() if each.needed}
    needed.update(name for rule in _of_one(controller, ("not_empty",)) for name in rule.params)
    required = [name for name in declared if name in needed and not declared[name].is_map]
    return {"type": "object", **tree_schema(schemas.items(), required), "additionalProperties": {"$ref": PLAIN_VALUE}}


def _of_one(controller: ControllerType, kinds: Container[str]) -> list[ParameterRule]:
    """The constraints of these kinds that always concern each of their parameters alone."""
    always = (rule for rule in controller.rules if not (rule.when or rule.when_any or "where" in rule.details))
    return [rule for rule in always if rule.severity == "error" and rule.kind in kinds]


def _with_rules(parameter: ParameterEntry, controller: ControllerType, distro: str) -> Schema:
    """The schema of a parameter with the constraints that always concern it alone."""
    schema = parameter_schema(parameter, distro)
    more = [
        _VALUES_OF[rule.kind](rule.details)
        for rule in _of_one(controller, _VALUES_OF)
        if parameter.name in rule.params and not isinstance(rule.details.get("of", []), str)
    ]
    more = [each for each in more if each]
    return {**schema, "allOf": [*schema.get("allOf", ()), *more]} if more else schema


def _limits(details: Mapping[str, Any]) -> Schema:
    own = ParameterEntry("", "none", validators=details["validators"])
    return limits_schema(own)


def _one_of_sets(details: Mapping[str, Any]) -> Schema:
    return {
        "anyOf": [
            {"items": {"enum": choice}, "minItems": len(choice), "maxItems": len(choice), "uniqueItems": True}
            for choice in details["sets"]
        ]
    }


_VALUES_OF: Mapping[str, Callable[[Mapping[str, Any]], Schema]] = {
    "valid": _limits,
    "not_empty": lambda _: {"minItems": 1, "minLength": 1},
    "subset": lambda details: {"items": {"enum": details["of"]}} if "of" in details else {},
    "contains": lambda details: {"allOf": [{"contains": {"const": value}} for value in details["values"]]},
    "combinations": _one_of_sets,
    "length": lambda details: {"minItems": details["at_least"]} if "at_least" in details else {},
}


def _any_of(known: list[ControllerType], distro: str) -> Schema:
    """What at least one type accepts of each parameter; nothing is required."""
    forms: dict[str, list[Schema]] = {}
    for controller in known:
        for name, parameter in {**CATALOG.common_parameters(distro), **controller.parameters}.items():
            schema = _with_rules(parameter, controller, distro)
            found = forms.setdefault(name, [])
            if not any(_says(schema) == _says(other) for other in found):
                found.append(schema)
    merged = {name: found[0] if len(found) == 1 else {"anyOf": found} for name, found in forms.items()}
    parameters = {"type": "object", **tree_schema(merged.items()), "additionalProperties": {"$ref": PLAIN_VALUE}}
    return {"type": "object", "properties": {_PARAMETERS: parameters}}


def _says(schema: Schema) -> Schema:
    return {key: value for key, value in schema.items() if key not in ("description", "default", "deprecated")}


def _if_only(kinds: list[str], definition: str) -> Schema:
    """Judge all sections by a definition if the controller manager loads only controllers of these types."""
    is_one = {"type": "object", "required": ["type"], "properties": {"type": {"enum": kinds}}}
    has_type = {"type": "object", "required": ["type"]}
    entry = {"if": has_type, "then": is_one}
    without = {"additionalProperties": {"not": has_type}}
    of_manager = {
        "type": "object",
        "required": [_PARAMETERS],
        "properties": {_PARAMETERS: {"type": "object", "additionalProperties": entry, "not": without}},
    }
    return {
        "if": {"type": "object", "required": ["controller_manager"], "properties": {"controller_manager": of_manager}},
        "then": {"patternProperties": {r"^/?(?!controller_manager$)\w[\w/]*$": {"$ref": f"#/$defs/{definition}"}}},
    }


def _ros1(known: list[ControllerType], distro: str) -> Schema:
    """ROS 1: a controller's type is among its parameters, so that each map is judged by its own type."""
    judged = [
        {
            "if": {"required": ["type"], "properties": {"type": {"const": each.type}}},
            "then": {"$ref": f"#/$defs/{_key(each.type)}"},
        }
        for each in known
    ]
    controller = {"required": ["type"], "properties": {"type": {"type": "string"}}}
    of_types = {_key(each.type): _parameters_of_ros1(each, distro) for each in known}
    below = {"additionalProperties": {"$ref": "#/$defs/node"}}
    node = {"if": {"type": "object", **controller}, "then": {"allOf": judged}, "else": below}
    return {"type": "object", **below, "$defs": {"node": node, **of_types}}


def _parameters_of_ros1(controller: ControllerType, distro: str) -> Schema:
    declared = controller.parameters
    schemas = {name: _as_ros1(_with_rules(each, controller, distro)) for name, each in declared.items()}
    needed = [name for name, each in declared.items() if each.needed]
    return {"title": controller.type, **tree_schema(schemas.items(), needed)}


def _as_ros1(schema: Schema) -> Schema:
    """ROS 1 reads an integer as a number and the other way round, which is all that the ROS type adds."""
    plain = {key: value for key, value in schema.items() if key != ROS_TYPE}
    return {**plain, "type": "number"} if plain.get("type") == "integer" else plain
