"""Which interfaces a robot's hardware offers to its controllers, as its description tells."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import Enum
from types import MappingProxyType

from urdfctl.catalog.distros import generation
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.source.span import Place


class Kind(Enum):
    """What a controller does with an interface. In ROS 1, commanding is what it claims for itself alone."""

    COMMAND = "command"
    STATE = "state"


class Absence(Enum):
    """How surely an interface is not there: `LIKELY` where a driver of unknown ways might still offer it."""

    SURE = "sure"
    LIKELY = "likely"


class Offer(NamedTuple):
    """An interface of a joint, sensor or gpio (`component`), and where the description says so; `by` is the name of the
    hardware that offers it."""

    component: str
    interface: str
    at: Place
    by: str | None = None


Offers = Mapping[str, tuple[Offer, ...]]
NO_OFFERS: Offers = MappingProxyType({})


class Hardware(NamedTuple):
    """All interfaces that hardware offers, by component, in the order of the description.

    `joints` are those of the robot, `fixed` those of them that do not move; `exact` components are wholly told by the
    description. Not `open`: no hardware offers anything that the description does not tell. Not `known`: nothing can be
    said of it.
    """

    command: Offers = NO_OFFERS
    state: Offers = NO_OFFERS
    exact: frozenset[str] = frozenset()
    joints: frozenset[str] = frozenset()
    open: bool = False
    known: bool = True
    fixed: frozenset[str] = frozenset()

    def offers(self, kind: Kind) -> Offers:
        """Its command interfaces, or its state interfaces."""
        return self.command if kind is Kind.COMMAND else self.state

    def of(self, kind: Kind, component: str) -> tuple[Offer, ...]:
        """What it offers of one component."""
        return self.offers(kind).get(component, ())

    def has(self, component: str) -> bool:
        """Whether it offers anything of a component."""
        return component in self.exact or component in self.command or component in self.state

    def absence(self, kind: Kind, component: str, interface: str) -> Absence | None:
        """How surely it does not offer an interface; None where it does, or may."""
        offered = any(one.interface == interface for one in self.of(kind, component))
        if offered or not self.known:
            return None
        if not self.open or component in self.exact:
            return Absence.SURE
        return Absence.LIKELY if self.has(component) or component in self.joints else None


def fixed_joints(robot: Robot) -> frozenset[str]:
    """The joints of a robot that do not move."""
    return frozenset(joint.name for joint in robot.joints if joint.name and joint.type == "fixed")


def by_component(offers: Iterable[Offer]) -> Offers:
    """Some offers by their component."""
    found: dict[str, tuple[Offer, ...]] = {}
    for offer in offers:
        found[offer.component] = (*found.get(offer.component, ()), offer)
    return found


UNKNOWN_HARDWARE = Hardware(known=False)


def hardware_of(project: Project, distro: str) -> Hardware:
    """The hardware of a robot, as one distro makes it of the description."""
    if project.robot is None:
        return UNKNOWN_HARDWARE
    if generation(distro) == 1:
        from urdfctl.control.hardware_ros1 import simulated_hardware

        return simulated_hardware(project.robot)
    from urdfctl.control.hardware_ros2 import described_hardware

    return described_hardware(project.robot, project.catalog, distro)
