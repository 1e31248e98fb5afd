"""What is wrong with a controller if its type or its parameters were others: tried without reading any file again."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.claims import claims
from urdfctl.control.conflicts import resource
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.parameters.gains import missing_gains
from urdfctl.control.parameters.given import given_values
from urdfctl.control.parameters.rules import breaches
from urdfctl.control.session import CHAINING, Configured, Session, readable
from urdfctl.startup.records import NamedTuple

Fault = tuple[str, str]
"""What is wrong, and the parameter or interface that it is about."""


class Trial(NamedTuple):
    """A controller in a session, to be tried with other values.

    joints: the joints of the robot that move.
    """

    session: Session
    controller: Configured
    joints: frozenset[str]

    @property
    def values(self) -> Mapping[str, object]:
        """The parameters as they are given, also those of a wrong type."""
        return given_values(self.controller.controller.parameters)

    def is_as_good(self, kind: ControllerType, values: Mapping[str, object]) -> bool:
        """Return whether nothing is wrong with a type and values that is not wrong now."""
        return self.faults(kind, values) <= self.now()

    def now(self) -> frozenset[Fault]:
        """Return what is wrong with the controller as it is written."""
        kind = self.controller.type
        return self.faults(kind, self.values) if kind else frozenset()

    def faults(self, kind: ControllerType, values: Mapping[str, object]) -> frozenset[Fault]:
        """Return what is wrong with a type and values."""
        return frozenset([*self._of_parameters(kind, values), *self._of_interfaces(kind, values)])

    def _of_parameters(self, kind: ControllerType, values: Mapping[str, object]) -> Iterator[Fault]:
        for name, value in values.items():
            matched = matching(name, kind.parameters)
            known = kind.parameters[matched[0]] if matched else None
            if known is None:
                yield "unknown", name
            elif type_problem(value, known, kind.distro) or problem(value, {**known.validators, **known.useful}):
                yield "wrong", name
        needed = (one.name for one in kind.parameters.values() if one.needed and not one.is_map)
        yield from (("missing", name) for name in needed if name not in values)
        yield from (("rule", f"{one.parameter}: {one.message}") for one in breaches(kind, values))
        yield from (("gain", one.name) for one in missing_gains(kind, values))

    def _of_interfaces(self, kind: ControllerType, values: Mapping[str, object]) -> Iterator[Fault]:
        claimed = claims(kind, self.controller.name, readable(kind, values))
        if claimed is None:
            return
        hardware, others = self.session.hardware, self._others()
        seen: set[str] = set()
        for use, found in ((ClaimKind.COMMAND, claimed.command), (ClaimKind.STATE, claimed.state)):
            for claim in found:
                name = claim.name
                is_chained = self.session.distro in CHAINING[use] and name.partition("/")[0] in self._chainable()
                if not (claim.best_effort or is_chained) and hardware.absence(use, claim.component, claim.interface):
                    yield "absent", f"{use.value} {name}"
                if claim.component in hardware.fixed or (not hardware.known and claim.component not in self.joints):
                    yield "joint", claim.component
                if use is ClaimKind.COMMAND and (resource(claim, self.session.distro) in others or name in seen):
                    yield "conflict", name
                seen |= {name} if use is ClaimKind.COMMAND else set()

    def _others(self) -> set[str]:
        own = self.controller.controller
        others = (one for one in self.session.candidates if one.controller is not own)
        same = (one for one in others if one.controller.namespace == own.namespace)
        return {resource(claim, self.session.distro) for one in same for claim in one.claims.command}

    def _chainable(self) -> set[str]:
        return {one.name for one in self.session.controllers}
