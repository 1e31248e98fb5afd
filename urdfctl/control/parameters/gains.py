"""Required gains of a controller that are missing, and the consequence."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum

from urdfctl.catalog.distros import generation
from urdfctl.catalog.entries import ControllerType, ParameterEntry
from urdfctl.catalog.map_parameters import expanded, matching
from urdfctl.catalog.values import is_known
from urdfctl.control.parameters.rules import applies
from urdfctl.control.parameters.values import Values
from urdfctl.startup.records import NamedTuple

NONZERO = "any_nonzero"
"""The kind of catalogue rules that require a gain for each element."""


class Fate(Enum):
    """The effect of missing gains on a controller."""

    REFUSED = "is not loaded"
    CRASH = "crashes when it is started"
    IDLE = "does not move"


class MissingGain(NamedTuple):
    """A gain that is not given, or is 0 together with its alternatives."""

    name: str
    """Full parameter name."""
    element: str | None
    """The joint that the gain is for; None if the controller has only one."""
    fate: Fate


def missing_gains(kind: ControllerType, given: Mapping[str, object]) -> Iterator[MissingGain]:
    """Yield the required gains that a controller with these parameter values does not have.

    In ROS 1 the PID classes require `p`. In ROS 2 missing gains are 0.
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


def _fate(parameter: ParameterEntry) -> Fate | None:
    if parameter.required:
        return Fate.REFUSED
    return {"crash": Fate.CRASH, "idle": Fate.IDLE}.get(parameter.if_absent or "")


def _element(name: str, kind: ControllerType) -> str | None:
    matched = matching(name, kind.parameters)
    return matched[1] if matched else None
