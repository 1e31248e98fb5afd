"""Rules on a controller's parameters together, from its entry in the catalogue."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from urdfctl.catalog.entries import ControllerType, ParameterCondition, ParameterRule
from urdfctl.catalog.map_parameters import expanded
from urdfctl.catalog.validators import problem
from urdfctl.catalog.values import elements, is_known, is_list, is_set
from urdfctl.control.parameters.values import Values
from urdfctl.names import enumerated
from urdfctl.startup.records import NamedTuple


class Breach(NamedTuple):
    """A rule that some values break."""

    rule: ParameterRule
    parameter: str
    """The parameter to be corrected or added."""
    message: str
    """The text that follows the parameter's name: `must have as many elements as 'left_wheel_names' (1), not 2`."""


def breaches(controller: ControllerType, given: Mapping[str, object]) -> Iterator[Breach]:
    """Yield the rules that a controller's values break. Unknown values break no rule."""
    values = Values(controller, given)
    for rule in controller.rules:
        if rule.kind in _KINDS and applies(rule, values):
            yield from _KINDS[rule.kind](rule, values)


def applies(rule: ParameterRule, values: Values) -> bool:
    """Return whether a rule's conditions hold."""
    any_met = not rule.when_any or any(_is_met(condition, values) for condition in rule.when_any)
    return any_met and all(_is_met(condition, values) for condition in rule.when)


def _is_met(condition: ParameterCondition, values: Values) -> bool:
    value = values.get(condition.param)
    if not is_known(value):
        return False
    if condition.is_set is not None:
        return is_set(value) == condition.is_set
    return _same(value, condition.value)


def _same(value: object, other: object) -> bool:
    """Whether two values are equal; the order in lists does not matter."""
    if isinstance(other, list):
        return isinstance(value, list | tuple) and sorted(map(str, value)) == sorted(map(str, other))
    return value == other


def _known(rule: ParameterRule, values: Values, *names: str) -> bool:
    return all(is_known(values.get(name)) for name in names or rule.params)


def _combinations(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    [name] = rule.params
    value, sets = values.get(name), _lists(rule, "sets")
    if is_set(value) and is_known(value) and not any(_same(value, combination) for combination in sets):
        listed = "; ".join(", ".join(combination) for combination in sets)
        yield Breach(rule, name, f"must be one of these combinations: {listed}")


def _contains(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    [name] = rule.params
    given = elements(values.get(name))
    missing = [wanted for wanted in _list(rule, "values") if wanted not in given]
    if missing and given and _known(rule, values):
        yield Breach(rule, name, f"must contain {_and(missing)}{_because(rule)}")


def _subset(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    [name] = rule.params
    of = rule.details.get("of_param")
    allowed = elements(values.get(str(of))) if of else tuple(_list(rule, "of"))
    given = elements(values.get(name))
    others = [part for part in given if part not in allowed]
    if rule.details.get("or_same_length") and len(given) == len(allowed):
        return
    if others and is_known(allowed) and _known(rule, values):
        choices = f"elements of '{of}'" if of else _and([str(part) for part in allowed])
        yield Breach(rule, name, f"can contain only {choices}, not {_and([str(part) for part in others])}")


def _same_length(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    first, *others = rule.params
    for other in others:
        sizes = len(elements(values.get(first))), len(elements(values.get(other)))
        if sizes[0] != sizes[1] and _known(rule, values, first, other):
            yield Breach(rule, other, f"must have as many elements as '{first}' ({sizes[0]}), not {sizes[1]}")


def _length(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    [name] = rule.params
    size, exact, least = len(elements(values.get(name))), rule.details.get("is"), rule.details.get("at_least")
    if not _known(rule, values):
        return
    if isinstance(exact, int) and size != exact:
        yield Breach(rule, name, f"must have exactly {_count(exact)}, not {size}")
    if isinstance(least, int) and size < least:
        yield Breach(rule, name, f"must have at least {_count(least)}, not {size}")


def _not_empty(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    for name in rule.params:
        if not is_set(values.get(name)):
            yield Breach(rule, name, "must not be empty")


def _any_set(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    names = [whole for name in rule.params for whole in (expanded(name, values) or (name,))]
    if not any(is_set(values.get(name)) for name in names):
        yield Breach(rule, names[0], f"or {_or(names[1:])} is required" if names[1:] else "is required")


def _needs(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    if not any(values.is_given(name) for name in rule.params):
        yield Breach(rule, rule.params[0], f"is required{_because(rule)}")


def _one_group_set(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    groups = _lists(rule, "groups")
    used = [group for group in groups if any(_is_used(name, values) for name in group)]
    if not used:
        yield Breach(rule, groups[0][0], f"or {_or([name for group in groups[1:] for name in group])} is required")
    if len(used) > 1:
        yield Breach(rule, used[0][0], f"cannot be combined with {_or([used[1][0]])}")


def _greater(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    than = str(rule.details["than"])
    for name, other in zip(expanded(rule.params[0], values), expanded(than, values), strict=True):
        value, limit = values.get(name), values.get(other)
        if not isinstance(value, int | float) or not isinstance(limit, int | float):
            continue
        if value <= limit and value != rule.details.get("unless"):
            yield Breach(rule, name, f"must be greater than '{other}' ({limit}), not {value}")


def _valid(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    """Each of `params`, for the elements for which `where` holds, passes the validators."""
    where, limits = rule.details.get("where"), rule.details["validators"]
    assert isinstance(limits, Mapping)  # noqa: S101 (by the schema)
    for pattern in rule.params:
        names = expanded(pattern, values)
        deciding = expanded(str(where["param"]), values) if isinstance(where, Mapping) else names
        for name, decides in zip(names, deciding, strict=True):
            if isinstance(where, Mapping) and values.get(decides) != where["is"]:
                continue
            value = values.get(name)
            broken = problem(value, limits)
            if broken is not None:
                because = f" if '{decides}' is {where['is']}" if isinstance(where, Mapping) else ""
                actual = "" if broken.startswith("must not") or is_list(value) else f", not {value}"
                yield Breach(rule, name, f"{broken}{because}{actual}")


def _is_used(name: str, values: Values) -> bool:
    return any(is_set(values.get(each)) for each in (values.given_below(name) or [name]))


def _full_interface_names(rule: ParameterRule, values: Values) -> Iterator[Breach]:
    for name in rule.params:
        value = values.get(name)
        if isinstance(value, str) and value and is_known(value) and "/" not in value:
            yield Breach(rule, name, f"must be a full name such as 'finger/{value}', not '{value}'")


def _lists(rule: ParameterRule, key: str) -> list[list[str]]:
    return [[str(part) for part in elements(inner)] for inner in elements(rule.details[key])]


def _list(rule: ParameterRule, key: str) -> list[str]:
    return [str(part) for part in elements(rule.details[key])]


def _because(rule: ParameterRule) -> str:
    reasons = [
        f"'{condition.param}' is {', '.join(map(_plain, elements(condition.value)))}"
        for condition in rule.when
        if condition.is_set is None
    ]
    return f" if {' and '.join(reasons)}" if reasons else ""


def _plain(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _and(words: list[str]) -> str:
    return enumerated(f"'{word}'" for word in words)


def _or(words: list[str]) -> str:
    return enumerated((f"'{word}'" for word in words), "or")


def _count(number: int) -> str:
    return f"{number} element{'s' if number != 1 else ''}"


_KINDS: Mapping[str, Callable[[ParameterRule, Values], Iterator[Breach]]] = {
    "combinations": _combinations,
    "contains": _contains,
    "subset": _subset,
    "same_length": _same_length,
    "length": _length,
    "not_empty": _not_empty,
    "any_set": _any_set,
    "needs": _needs,
    "one_group_set": _one_group_set,
    "greater": _greater,
    "full_interface_names": _full_interface_names,
    "valid": _valid,
}
