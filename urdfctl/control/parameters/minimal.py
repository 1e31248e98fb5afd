"""The smallest valid set of parameters of a controller type, made from its entry in the catalogue."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.catalog.entries import ControllerType, ParameterEntry, ParameterRule
from urdfctl.catalog.map_parameters import expanded
from urdfctl.catalog.validators import problem
from urdfctl.catalog.values import elements, is_set
from urdfctl.control.parameters.gains import missing_gains
from urdfctl.control.parameters.rules import applies
from urdfctl.control.parameters.values import Values

_NUMBERS = (1.0, 0.0, 0.5, 2.0, 10.0, -1.0)
"""Example numbers; the first one that the validators accept is used."""


def minimal_parameters(controller: ControllerType) -> dict[str, object]:
    """Return a value for each required parameter of a controller, by full name; joints are called joint1, joint2.

    Includes parameters that only a rule requires, such as one of two groups.
    """
    values: dict[str, object] = {}
    for parameter in controller.parameters.values():
        if not parameter.is_map and (parameter.needed or parameter.if_absent):
            values[parameter.name] = _example(parameter, controller, values)
    for rule in controller.rules:
        if rule.severity == "error" and applies(rule, Values(controller, values)):
            _obey(rule, controller, values)
    for parameter in controller.parameters.values():
        if parameter.is_map and (parameter.needed or parameter.if_absent):
            for name in expanded(parameter.name, Values(controller, values)):
                values[name] = _example(parameter, controller, values)
    for gain in list(missing_gains(controller, values)):
        values[gain.name] = _NUMBERS[0]
    return values


def _obey(rule: ParameterRule, controller: ControllerType, values: dict[str, object]) -> None:
    """Change or add the values that a rule requires."""
    read = Values(controller, values)
    if rule.kind == "not_empty":
        for name in (name for name in rule.params if not is_set(read.get(name))):
            values[name] = _example(controller.parameters[name], controller, values)
    elif rule.kind == "combinations" and is_set(read.get(rule.params[0])):
        values[rule.params[0]] = list(elements(elements(rule.details["sets"])[0]))
    elif rule.kind == "contains" and is_set(read.get(rule.params[0])):
        given = elements(read.get(rule.params[0]))
        missing = [value for value in elements(rule.details["values"]) if value not in given]
        if missing:
            values[rule.params[0]] = [*given, *missing]
    elif rule.kind == "length":
        size = _number(rule.details.get("is", rule.details.get("at_least")))
        values[rule.params[0]] = _list(controller.parameters[rule.params[0]], size, controller, values)
    elif rule.kind == "any_set":
        for name in expanded(rule.params[0], read)[:1]:
            values[name] = _example(controller.parameters[rule.params[0]], controller, values)
    elif rule.kind == "one_group_set":
        groups = [elements(group) for group in elements(rule.details["groups"])]
        plain = [str(group[0]) for group in groups if str(group[0]) in controller.parameters]
        if not any(is_set(read.get(name)) for name in plain):
            values[plain[0]] = _example(controller.parameters[plain[0]], controller, values)


def _example(parameter: ParameterEntry, controller: ControllerType, values: Mapping[str, object]) -> object:
    kind = parameter.types[-1]
    if kind.endswith("_array"):
        limits = parameter.validators
        size = _number(limits.get("fixed_size", _number(limits.get("size_gt")) + 1))
        return _list(parameter, size, controller, values)
    return next(_fitting(parameter, controller, values))


def _number(value: object) -> int:
    return value if isinstance(value, int) else 0


def _list(
    parameter: ParameterEntry, size: int, controller: ControllerType, values: Mapping[str, object]
) -> list[object]:
    items: list[object] = []
    for _ in range(size):
        choices = _fitting(parameter, controller, {**values, parameter.name: items})
        items.append(next(choices))
    return items


def _fitting(parameter: ParameterEntry, controller: ControllerType, values: Mapping[str, object]) -> Iterator[object]:
    """Values, or elements of a list, that the validators accept."""
    kind = parameter.types[-1].removesuffix("_array")
    is_list = parameter.types[-1] != kind
    limits = {
        name: limit for name, limit in parameter.validators.items() if name not in ("fixed_size", "size_gt", "size_lt")
    }
    for choice in _choices(kind, parameter, controller, values):
        if problem([choice] if is_list else choice, limits) is None:
            yield choice


def _choices(
    kind: str, parameter: ParameterEntry, controller: ControllerType, values: Mapping[str, object]
) -> Iterator[object]:
    allowed = parameter.validators.get("one_of", parameter.validators.get("subset_of"))
    taken = elements(values.get(parameter.name))
    if allowed is not None:
        yield from (value for value in elements(allowed) if value not in taken)
    elif kind == "string":
        yield from _names(parameter, controller, values)
    elif kind == "bool":
        yield True
    else:
        yield from _NUMBERS if kind == "double" else map(int, _NUMBERS)


def _names(parameter: ParameterEntry, controller: ControllerType, values: Mapping[str, object]) -> Iterator[str]:
    """Strings for a parameter: an interface, a full interface name, or a component that no other parameter names."""
    rules = [rule for part in (*(controller.claims or ()), *controller.exports) for rule in part]
    taken = {part for value in values.values() for part in elements(value)}
    if any(rule.interfaces_from and rule.interfaces_from.replace("{item}", "") in _bare(parameter) for rule in rules):
        yield from (
            name for name in ("position", "velocity", "effort") if name not in elements(values.get(parameter.name))
        )
        return
    whole = any(parameter.name == rule.names_from for rule in rules)
    for number in range(1, len(taken) + 2):
        name = f"joint{number}/position" if whole else f"joint{number}"
        if name not in taken:
            yield name


def _bare(parameter: ParameterEntry) -> tuple[str, ...]:
    """The parameter's name, and the name without its placeholder."""
    before, _, after = parameter.name.partition("<")
    return parameter.name, before + after.partition(">")[2]
