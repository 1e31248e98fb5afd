"""The interfaces that a controller claims and exports, by the rules of its entry in the catalogue.

A claim that depends on an unknown value is left out, and the result is marked as not complete.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from urdfctl.catalog.entries import ClaimRule, ControllerType, ParameterCondition
from urdfctl.catalog.values import elements, is_known, is_list, is_set
from urdfctl.control.parameters.values import Values
from urdfctl.startup.records import NamedTuple

_PLACEHOLDER = re.compile(r"\{(\w+)\}")


class Claim(NamedTuple):
    """An interface that a controller claims or exports: `component`/`interface`."""

    component: str
    interface: str
    parameter: str | None = None
    """The parameter that names the component, or the full name; None if no parameter does."""
    element: int | None = None
    """Index of the element in that parameter, if it is a list."""
    interface_parameter: str | None = None
    """The parameter that names the interface; None if no parameter does."""
    interface_element: int | None = None
    """Index of the element in that parameter, if it is a list."""
    best_effort: bool = False
    """Whether the controller silently ignores that nothing offers the interface."""

    @property
    def name(self) -> str:
        """The full name."""
        return f"{self.component}/{self.interface}" if self.interface else self.component


class ClaimFacts(NamedTuple):
    """Facts about the robot that claims may depend on."""

    movable_joints: tuple[str, ...] = ()
    state_interfaces: tuple[tuple[str, str], ...] = ()
    """The offered state interfaces, as (component, interface)."""


NO_FACTS = ClaimFacts()


class Claims(NamedTuple):
    """The interfaces that a controller claims."""

    command: tuple[Claim, ...] = ()
    state: tuple[Claim, ...] = ()
    complete: bool = True
    """False if the controller may claim more."""


class ExportedInterfaces(NamedTuple):
    """The interfaces that a controller exports for other controllers."""

    reference: tuple[Claim, ...] = ()
    """Interfaces to be commanded."""
    state: tuple[Claim, ...] = ()
    complete: bool = True
    """False if the controller may export more."""


def claims(
    controller: ControllerType, name: str, values: Mapping[str, object], robot: ClaimFacts = NO_FACTS
) -> Claims | None:
    """Return the claims of a controller with this name and these values; None if the catalogue does not know them."""
    if controller.claims is None:
        return None
    evaluation = _Evaluation(controller, name, values, robot)
    command, state = evaluation.of(controller.claims.command), evaluation.of(controller.claims.state)
    return Claims(command, state, evaluation.complete)


def exports(controller: ControllerType, name: str, values: Mapping[str, object]) -> ExportedInterfaces:
    """Return the interfaces that a controller with this name and these parameter values exports."""
    evaluation = _Evaluation(controller, name, values, NO_FACTS)
    reference, state = evaluation.of(controller.exports.reference), evaluation.of(controller.exports.state)
    return ExportedInterfaces(reference, state, evaluation.complete)


class _Named(NamedTuple):
    """A name, and the parameter and list element that gave it."""

    text: str
    parameter: str | None = None
    element: int | None = None


class _Evaluation:
    """Evaluates the claim rules of one controller for its parameter values."""

    def __init__(self, controller: ControllerType, name: str, values: Mapping[str, object], robot: ClaimFacts) -> None:
        self._name = name
        self._values = Values(controller, values)
        self._robot = robot
        self.complete = True

    def of(self, rules: Iterable[ClaimRule]) -> tuple[Claim, ...]:
        """Return the claims that rules yield."""
        return tuple(claim for rule in rules for claim in self._of_rule(rule))

    def _of_rule(self, rule: ClaimRule) -> Iterator[Claim]:
        if not _names_item(rule) and not self._holds(rule, None):
            return
        is_best_effort = rule.best_effort or rule.all
        if not rule.prefix and not is_best_effort:
            yield from self._claims(rule)
            return
        prefix = self._filled(rule.prefix, None)
        for claim in self._claims(rule):
            yield claim._replace(component=prefix + claim.component, best_effort=is_best_effort)

    def _claims(self, rule: ClaimRule) -> Iterator[Claim]:
        if rule.all:
            wanted = rule.interfaces
            offered = (Claim(*pair) for pair in self._robot.state_interfaces)
            yield from (claim for claim in offered if not wanted or claim.interface in wanted)
        for named in self._texts(rule.names_from) if rule.names_from else ():
            yield _whole(named)
        for name in rule.names:
            yield from map(_whole, self._known(_Named(self._filled(name, None))))
        if rule.all_if_none and not any(self._interfaces(rule, item) for item in self._components(rule)):
            yield from self._offered_by(tuple(self._components(rule)))
        for component in self._components(rule):
            if not _names_item(rule) or self._holds(rule, component.text):
                for interface in self._interfaces(rule, component):
                    yield Claim(
                        component=component.text,
                        interface=interface.text,
                        parameter=component.parameter,
                        element=component.element,
                        interface_parameter=interface.parameter,
                        interface_element=interface.element,
                    )

    def _components(self, rule: ClaimRule) -> Iterator[_Named]:
        if rule.for_each:
            chosen = rule.for_each
            if rule.or_else and not is_set(self._values.get(chosen)):
                chosen = rule.or_else
            yield from self._texts(chosen)
        for component in rule.components:
            yield from self._known(_Named(self._filled(component, None)))
        if rule.movable_joints:
            yield from (_Named(joint) for joint in self._robot.movable_joints)

    def _interfaces(self, rule: ClaimRule, component: _Named) -> tuple[_Named, ...]:
        interfaces = [_Named(interface) for interface in rule.interfaces]
        if rule.interfaces_from:
            interfaces += self._texts(self._filled(rule.interfaces_from, component.text))
        if rule.interfaces_in:
            prefix = rule.interfaces_in.rstrip("*")
            for name in (name for name in self._values if name.startswith(prefix)):
                interfaces += [named for named in self._texts(name) if named.text not in rule.interfaces]
        return tuple(interfaces)

    def _offered_by(self, components: tuple[_Named, ...]) -> Iterator[Claim]:
        for component in components:
            for offering, interface in self._robot.state_interfaces:
                if offering == component.text:
                    yield Claim(offering, interface, component.parameter, component.element)

    def _holds(self, rule: ClaimRule, item: str | None) -> bool:
        every = all(self._is_met(condition, item) for condition in rule.when)
        return every and (not rule.when_any or any(self._is_met(condition, item) for condition in rule.when_any))

    def _is_met(self, condition: ParameterCondition, item: str | None) -> bool:
        value = self._values.get(self._filled(condition.param, item))
        if not is_known(value):
            self.complete = False
            return False
        if condition.is_set is not None:
            return is_set(value) == condition.is_set
        return value == condition.value

    def _texts(self, parameter: str) -> list[_Named]:
        """The strings in a parameter: the elements of a list, or the string itself. Other values are left out."""
        value = self._values.get(parameter)
        given = parameter if self._values.is_given(parameter) else None
        strings = [
            _Named(part, given, index if given and is_list(value) else None)
            for index, part in enumerate(elements(value))
            if isinstance(part, str) and part
        ]
        return [named for each in strings for named in self._known(each)]

    def _known(self, named: _Named) -> Iterator[_Named]:
        """The name if it is known; else nothing, and the result is not complete."""
        if is_known(named.text):
            yield named
        else:
            self.complete = False

    def _filled(self, text: str, item: str | None) -> str:
        """A string with placeholders replaced: the controller's name, the current element, or a parameter's value."""
        if "{" not in text:
            return text

        def filling(placeholder: re.Match[str]) -> str:
            if placeholder[1] == "controller":
                return self._name
            if placeholder[1] == "item":
                return item or ""
            return str(self._values.get(placeholder[1]) or "")

        return _PLACEHOLDER.sub(filling, text)


def _whole(named: _Named) -> Claim:
    component, _, interface = named.text.rpartition("/")
    return Claim(component or interface, interface if component else "", named.parameter, named.element)


def _names_item(rule: ClaimRule) -> bool:
    return any("{item}" in condition.param for condition in (*rule.when, *rule.when_any))
