"""The state of a controller manager in one distro: the hardware, the controllers, and their claims."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING

from urdfctl.catalog.distros import since
from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.claims import Claim, ClaimFacts, Claims, ExportedInterfaces, claims, exports
from urdfctl.control.hardware.interfaces import Absence, ClaimKind, OfferedHardware
from urdfctl.control.hardware.offered import hardware_of
from urdfctl.control.parameters.given import given_values
from urdfctl.model.controllers import Controller
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.model.launch import Launch

NOT_KNOWN = Claims(complete=False)
CHAINING = {ClaimKind.COMMAND: since("humble"), ClaimKind.STATE: since("jazzy")}
"""The distros in which controllers can claim interfaces of other controllers."""
_MOVABLE = ("revolute", "continuous", "prismatic")

_Name = tuple[str | None, str]


class MissingInterface(NamedTuple):
    """An interface that a controller claims and no hardware offers."""

    kind: ClaimKind
    claim: Claim
    absence: Absence


class Configured(NamedTuple):
    """A controller with its parameters in one distro."""

    controller: Controller
    type: ControllerType | None
    """None if the catalogue does not have the type; claims and exports are then unknown too."""
    values: Mapping[str, object]
    """The given parameter values by full name."""
    claims: Claims
    exports: ExportedInterfaces
    missing: tuple[MissingInterface, ...] = ()
    """Claimed interfaces that no hardware offers."""

    @property
    def name(self) -> str:
        """The controller's own name, which is also the prefix of the interfaces that it exports."""
        return self.controller.name

    def claimed(self, kind: ClaimKind) -> tuple[Claim, ...]:
        """Return its claims of one kind."""
        return self.claims.command if kind is ClaimKind.COMMAND else self.claims.state


class Session(NamedTuple):
    """The controllers and the hardware of a project in one distro."""

    distro: str
    hardware: OfferedHardware
    controllers: tuple[Configured, ...]
    started: tuple[Configured, ...] | None
    """The started controllers, in order; None if unknown."""
    in_order: bool
    """Whether they are started one after the other."""
    by_name: Mapping[_Name, Configured]
    """Controllers by namespace and name. Controllers of different namespaces have different managers."""

    later: Mapping[str, frozenset[str]] = MappingProxyType({})
    """By the name of a controller those that its spawner starts after it, one by one."""

    @property
    def candidates(self) -> tuple[Configured, ...]:
        """The started controllers; if unknown, all controllers."""
        return self.controllers if self.started is None else self.started

    def named(self, name: str, beside: Configured) -> Configured | None:
        """Return the controller with this name that has the same manager as another controller."""
        return self.by_name.get((beside.controller.namespace, name))


def sessions(project: Project) -> Iterator[Session]:
    """Return one session for each distro that a project may be for."""
    return (session_of(project, distro) for distro in project.distros)


def session_of(project: Project, distro: str) -> Session:
    """Return the session of a project in one distro."""
    hardware = hardware_of(project, distro)
    facts = _facts(project.robot, hardware)
    declared = project.controllers.controllers if project.controllers else ()
    names = {(controller.namespace, controller.name) for controller in declared}
    configured = []
    for controller in declared:
        with_claims = _configured(controller, project, distro, facts)
        missing = tuple(_missing(with_claims, hardware, distro, names))
        configured.append(with_claims._replace(missing=missing))
    by_name = {(each.controller.namespace, each.name): each for each in reversed(configured)}
    started = _started(project, configured)
    return Session(
        distro=distro,
        hardware=hardware,
        controllers=tuple(configured),
        started=started,
        in_order=project.in_order,
        by_name=by_name,
        later=_later(project.launch) if project.launch else {},
    )


def _facts(robot: Robot | None, hardware: OfferedHardware) -> ClaimFacts:
    joints = robot.joints if robot else ()
    movable = tuple(joint.name for joint in joints if joint.name and joint.type in _MOVABLE)
    offered = tuple((offer.component, offer.interface) for offers in hardware.state.values() for offer in offers)
    return ClaimFacts(movable, offered)


def _configured(controller: Controller, project: Project, distro: str, facts: ClaimFacts) -> Configured:
    kind = controller.type.value if controller.type else None
    known = project.catalog.controller(kind, distro) if isinstance(kind, str) else None
    declared = any(one["type"] == kind for one in project.additions.controllers)
    if known is None or (kind in project.own.controllers and not declared):
        return Configured(controller, None, {}, NOT_KNOWN, ExportedInterfaces(complete=False))
    values = readable(known, given_values(controller.parameters))
    claimed = claims(known, controller.name, values, facts)
    return Configured(controller, known, values, claimed or NOT_KNOWN, exports(known, controller.name, values))


def readable(kind: ControllerType, given: Mapping[str, object]) -> dict[str, object]:
    """Return the values, UNKNOWN for those of the wrong type: the controller fails before it claims anything."""

    def wrong(name: str, value: object) -> bool:
        matched = matching(name, kind.parameters)
        return matched is not None and type_problem(value, kind.parameters[matched[0]], kind.distro) is not None

    return {name: UNKNOWN if wrong(name, value) else value for name, value in given.items()}


def _missing(
    controller: Configured, hardware: OfferedHardware, distro: str, names: Collection[_Name]
) -> Iterator[MissingInterface]:
    for kind in ClaimKind:
        for claim in controller.claimed(kind):
            chained = distro in CHAINING[kind] and (controller.controller.namespace, before_slash(claim)) in names
            absence = hardware.absence(kind, claim.component, claim.interface)
            if absence is not None and not chained and not claim.best_effort:
                yield MissingInterface(kind, claim, absence)


def before_slash(claim: Claim) -> str:
    """Return the part of a claim's name before the first slash, which may be a controller's name."""
    return claim.name.partition("/")[0]


def _later(launch: Launch) -> dict[str, frozenset[str]]:
    """By the name of a controller those that are started after it: by the same spawner, or by one that waits for it."""
    later: dict[str, frozenset[str]] = {}
    for spawn in launch.spawns:
        names = [name.rpartition("/")[2] for name, _ in spawn.names]
        waiting = (other for other in launch.spawns if set(other.after) & set(names))
        after = [name.rpartition("/")[2] for other in waiting for name, _ in other.names]
        one_by_one = spawn.active and spawn.option("--activate-as-group") is None
        for index, name in enumerate(names):
            later[name] = frozenset([*after, *(names[index + 1 :] if one_by_one else ())])
    return later


def _started(project: Project, configured: Sequence[Configured]) -> tuple[Configured, ...] | None:
    if project.started is None or project.controllers is None:
        return None
    by_controller = {id(each.controller): each for each in configured}
    started = [project.controllers.controller(name) for name in project.started]
    if any(one is not None and one.declared_at is None for one in started):
        rest = {id(each.controller) for each in configured} - {id(one) for one in started}
        if rest and project.controllers.complete:
            return None  # a wrong name is spawned: another controller is meant
    keys = dict.fromkeys(id(controller) for controller in started if controller is not None)
    return tuple(by_controller[key] for key in keys)
