"""What a controller manager of one distro has before it: the hardware, the controllers, and what each claims."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from urdfctl.catalog.distros import since
from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.claims import Claim, Claims, Exports, RobotFacts, claims, exports
from urdfctl.control.given import given_values
from urdfctl.control.hardware import Absence, Hardware, Kind, hardware_of
from urdfctl.model.controllers import Controller
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.source.opaque import UNKNOWN

NOT_KNOWN = Claims(complete=False)
CHAINING = {Kind.COMMAND: since("humble"), Kind.STATE: since("jazzy")}
"""The distros whose controllers may claim what other controllers export."""
_MOVABLE = ("revolute", "continuous", "prismatic")

_Name = tuple[str | None, str]


class Missing(NamedTuple):
    """An interface that a controller claims and no hardware offers."""

    kind: Kind
    claim: Claim
    absence: Absence


class Configured(NamedTuple):
    """A controller with its parameters, as one distro reads them. `type` is None where the catalogue does not know it;
    then nothing is known of what it claims and exports either. `missing` is what it claims of hardware in vain."""

    controller: Controller
    type: ControllerType | None
    values: Mapping[str, object]
    claims: Claims
    exports: Exports
    missing: tuple[Missing, ...] = ()

    @property
    def name(self) -> str:
        """The controller's own name, which stands before what it exports."""
        return self.controller.name

    def claimed(self, kind: Kind) -> tuple[Claim, ...]:
        """Its claims of a kind."""
        return self.claims.command if kind is Kind.COMMAND else self.claims.state


class Session(NamedTuple):
    """What one distro makes of a project. `started` are the controllers that are started, None where it is not known
    which are; `in_order` where they are started one after the other. Controllers of different namespaces have different
    managers."""

    distro: str
    hardware: Hardware
    controllers: tuple[Configured, ...]
    started: tuple[Configured, ...] | None
    in_order: bool
    by_name: Mapping[_Name, Configured]

    @property
    def candidates(self) -> tuple[Configured, ...]:
        """The controllers that are started, or else all: each of them may be."""
        return self.controllers if self.started is None else self.started

    def named(self, name: str, beside: Configured) -> Configured | None:
        """The controller of a name in the manager of another one."""
        return self.by_name.get((beside.controller.namespace, name))


def sessions(project: Project) -> Iterator[Session]:
    """What each distro that a project may be for makes of it."""
    return (session_of(project, distro) for distro in project.distros)


def session_of(project: Project, distro: str) -> Session:
    """What one distro makes of a project."""
    hardware = hardware_of(project, distro)
    facts = _facts(project.robot, hardware)
    declared = project.controllers.controllers if project.controllers else ()
    names = {(controller.namespace, controller.name) for controller in declared}
    configured = []
    for controller in declared:
        one = _configured(controller, project, distro, facts)
        configured.append(one._replace(missing=tuple(_missing(one, hardware, distro, names))))
    by_name = {(one.controller.namespace, one.name): one for one in reversed(configured)}
    started = _started(project, configured)
    return Session(distro, hardware, tuple(configured), started, project.in_order, by_name)


def _facts(robot: Robot | None, hardware: Hardware) -> RobotFacts:
    joints = robot.joints if robot else ()
    movable = tuple(joint.name for joint in joints if joint.name and joint.type in _MOVABLE)
    offered = tuple((offer.component, offer.interface) for offers in hardware.state.values() for offer in offers)
    return RobotFacts(movable, offered)


def _configured(controller: Controller, project: Project, distro: str, facts: RobotFacts) -> Configured:
    kind = controller.type.value if controller.type else None
    known = project.catalog.controller(kind, distro) if isinstance(kind, str) else None
    if known is None:
        return Configured(controller, None, {}, NOT_KNOWN, Exports(complete=False))
    values = _readable(known, given_values(controller.parameters))
    claimed = claims(known, controller.name, values, facts)
    return Configured(controller, known, values, claimed or NOT_KNOWN, exports(known, controller.name, values))


def _readable(kind: ControllerType, given: Mapping[str, object]) -> dict[str, object]:
    """The values with those not known that are of a wrong type: the controller does not get so far as to claim."""

    def wrong(name: str, value: object) -> bool:
        found = matching(name, kind.parameters)
        return found is not None and type_problem(value, kind.parameters[found[0]], kind.distro) is not None

    return {name: UNKNOWN if wrong(name, value) else value for name, value in given.items()}


def _missing(one: Configured, hardware: Hardware, distro: str, names: Collection[_Name]) -> Iterator[Missing]:
    for kind in Kind:
        for claim in one.claimed(kind):
            chained = distro in CHAINING[kind] and (one.controller.namespace, before_slash(claim)) in names
            absence = hardware.absence(kind, claim.component, claim.interface)
            if absence is not None and not chained and not claim.best_effort:
                yield Missing(kind, claim, absence)


def before_slash(claim: Claim) -> str:
    """What may be a controller's name in a claim: what stands before the first slash."""
    return claim.name.partition("/")[0]


def _started(project: Project, configured: Iterable[Configured]) -> tuple[Configured, ...] | None:
    if project.started is None or project.controllers is None:
        return None
    by_controller = {id(one.controller): one for one in configured}
    found = (project.controllers.controller(name) for name in project.started)
    names = dict.fromkeys(id(controller) for controller in found if controller is not None)
    return tuple(by_controller[name] for name in names)
