"""The interfaces that a robot's hardware offers to controllers, according to its description."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import Enum
from types import MappingProxyType

from urdfctl.model.robot import Robot
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class ClaimKind(Enum):
    """The use of an interface by a controller. In ROS 1, command claims are the exclusive ones."""

    COMMAND = "command"
    STATE = "state"


class Absence(Enum):
    """The certainty that an interface is missing."""

    SURE = "sure"
    LIKELY = "likely"
    """An unknown driver might still offer it."""


class Offer(NamedTuple):
    """An interface that hardware offers."""

    component: str
    """Name of the joint, sensor or gpio."""
    interface: str
    at: Place
    """Where the description defines it."""
    by: str | None = None
    """Name of the hardware that offers it."""


Offers = Mapping[str, tuple[Offer, ...]]
NO_OFFERS: Offers = MappingProxyType({})


class OfferedHardware(NamedTuple):
    """All interfaces that hardware offers, by component, in the order of the description."""

    command: Offers = NO_OFFERS
    state: Offers = NO_OFFERS
    exact: frozenset[str] = frozenset()
    """Components whose interfaces are completely described."""
    joints: frozenset[str] = frozenset()
    """Joints of the robot."""
    open: bool = False
    """Whether some hardware may offer more than the description lists."""
    known: bool = True
    """False if nothing is known about the hardware."""
    fixed: frozenset[str] = frozenset()
    """Joints of the robot that are fixed."""
    bare: frozenset[str] = frozenset()
    """Components of drivers that export interfaces of their own: the description lists none at all, or the catalogue
    says so."""

    def offers(self, kind: ClaimKind) -> Offers:
        """Return the command or the state interfaces."""
        return self.command if kind is ClaimKind.COMMAND else self.state

    def of(self, kind: ClaimKind, component: str) -> tuple[Offer, ...]:
        """Return the offered interfaces of one component."""
        return self.offers(kind).get(component, ())

    def has(self, component: str) -> bool:
        """Return whether the hardware has this component."""
        return component in self.exact or component in self.command or component in self.state

    def absence(self, kind: ClaimKind, component: str, interface: str) -> Absence | None:
        """Return how certain it is that an interface is missing; None if it is offered, or may be."""
        offered = any(offer.interface == interface for offer in self.of(kind, component))
        if offered or not self.known:
            return None
        if not self.open or component in self.exact:
            return Absence.SURE
        if component in self.bare:
            return None
        return Absence.LIKELY if self.has(component) or component in self.joints else None


def fixed_joints(robot: Robot) -> frozenset[str]:
    """Return the fixed joints of a robot."""
    return frozenset(joint.name for joint in robot.joints if joint.name and joint.type == "fixed")


def by_component(offers: Iterable[Offer]) -> Offers:
    """Return offers grouped by component."""
    grouped: dict[str, tuple[Offer, ...]] = {}
    for offer in offers:
        grouped[offer.component] = (*grouped.get(offer.component, ()), offer)
    return grouped


UNKNOWN_HARDWARE = OfferedHardware(known=False)
