"""The gains of controllers: which are missing, with the consequence, and what each closed loop has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum
from math import inf

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


class GainLoop(NamedTuple):
    """The gains of one closed loop of a controller."""

    prefix: str
    """What all its parameters begin with: `gains.elbow.`."""
    element: str | None
    """The joint that the loop is for; None if the controller has only one."""
    p: float
    i: float
    d: float
    forward: float
    """The gain on the command itself, which moves the joint without an error."""
    clamp: float
    """How much the integral part may contribute at most; infinite if nothing limits it."""

    @property
    def integral(self) -> float:
        """The gain i, as far as the clamp lets it act."""
        return self.i if self.clamp else 0.0


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


def loops_of(kind: ControllerType, given: Mapping[str, object]) -> Iterator[GainLoop]:
    """Yield the closed loops of a controller of which at least one gain is given and all values are known numbers."""
    values = Values(kind, given)
    for pattern in kind.parameters:
        if pattern.endswith(".p") and f"{pattern[:-1]}i" in kind.parameters:
            for name in expanded(pattern, values):
                prefix = name[:-1]
                gains = {gain: _number(values, prefix + gain) for gain in "pid"}
                p, i, d = gains.values()
                forward, clamp = _forward(kind, values, prefix), _clamp(values, prefix)
                is_given = any(values.is_given(prefix + gain) for gain in gains)
                if is_given and None not in (p, i, d, forward, clamp):
                    yield GainLoop(prefix, _element(name, kind), p=p, i=i, d=d, forward=forward, clamp=clamp)  # type: ignore[arg-type]


def _forward(kind: ControllerType, values: Values, prefix: str) -> float | None:
    element = _element(f"{prefix}p", kind)
    names = [f"{prefix}ff_velocity_scale", f"{prefix}feedforward_gain", f"velocity_ff.{element}"]
    return next((_number(values, name) for name in names if matching(name, kind.parameters)), 0.0)


def _clamp(values: Values, prefix: str) -> float | None:
    """The larger of the two bounds, without their signs."""
    bounds = [_first(values, prefix, (name, "i_clamp")) for name in ("i_clamp_max", "i_clamp_min")]
    return None if None in bounds else max(abs(bound) for bound in bounds if bound is not None)


def _first(values: Values, prefix: str, names: tuple[str, ...]) -> float | None:
    """The first of some parameters that is given, or else the first with a default; infinite if none has one."""
    whole = [prefix + name for name in names]
    chosen = [name for name in whole if values.is_given(name)] or [
        name for name in whole if values.get(name) is not None
    ]
    return _number(values, chosen[0]) if chosen else inf


def _number(values: Values, name: str) -> float | None:
    value = values.get(name, 0.0)
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return float(value) if is_number else 0.0 if value is None else None  # type: ignore[arg-type]
