"""Gains that a controller cannot do without: which of them are not given, and what becomes of it then."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum

from urdfctl.catalog.distros import generation
from urdfctl.catalog.entries import ControllerType, Parameter
from urdfctl.catalog.map_parameters import expanded, matching
from urdfctl.catalog.values import is_known
from urdfctl.control.parameter_rules import applies
from urdfctl.control.values import Values
from urdfctl.record import NamedTuple

NONZERO = "any_nonzero"
"""The kind of the catalogue's rules that ask for a gain of each element."""


class Fate(Enum):
    """What becomes of a controller without gains."""

    REFUSED = "is not loaded"
    CRASH = "crashes when it is started"
    IDLE = "does not move"


class MissingGain(NamedTuple):
    """A gain that is not given, or is 0 with all that could stand for it. `element` is the joint that it is for; None
    where the controller has but one."""

    name: str
    element: str | None
    fate: Fate


def missing_gains(kind: ControllerType, given: Mapping[str, object]) -> Iterator[MissingGain]:
    """The gains that a controller of some parameters needs and does not have.

    In ROS 1 it is `p` that the PID classes ask for; in ROS 2 all gains are 0 where none is given.
    """
    values = Values(kind, given)
    if generation(kind.distro) == 1:
        yield from _proportional(kind, values)
        return
    for rule in kind.rules:
        if rule.kind == NONZERO and applies(rule, values):
            for names in zip(*(expanded(param, values) for param in rule.params), strict=True):
                element = _element(names[0], kind)
                if element and all(is_known(values.get(name)) and not values.get(name) for name in names):
                    yield MissingGain(names[0], element, Fate.IDLE)


def _proportional(kind: ControllerType, values: Values) -> Iterator[MissingGain]:
    for parameter in kind.parameters.values():
        fate = _fate(parameter)
        if fate is None or parameter.name.rpartition(".")[2] != "p":
            continue
        for name in expanded(parameter.name, values):
            if not values.is_given(name):
                yield MissingGain(name, _element(name, kind), fate)


def _fate(parameter: Parameter) -> Fate | None:
    if parameter.required:
        return Fate.REFUSED
    return {"crash": Fate.CRASH, "idle": Fate.IDLE}.get(parameter.if_absent or "")


def _element(name: str, kind: ControllerType) -> str | None:
    found = matching(name, kind.parameters)
    return found[1] if found else None
