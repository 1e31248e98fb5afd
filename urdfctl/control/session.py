"""What a controller manager of one distro has before it: the hardware, the controllers, and what each claims."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.claims import Claims, Exports, RobotFacts, claims, exports
from urdfctl.control.given import given_values
from urdfctl.control.hardware import Hardware, hardware_of
from urdfctl.model.controllers import Controller
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.source.opaque import UNKNOWN

NOT_KNOWN = Claims(complete=False)
_MOVABLE = ("revolute", "continuous", "prismatic")


class Configured(NamedTuple):
    """A controller with its parameters, as one distro reads them. `type` is None where the catalogue does not know it;
    then nothing is known of what it claims and exports either."""

    controller: Controller
    type: ControllerType | None
    values: Mapping[str, object]
    claims: Claims
    exports: Exports

    @property
    def name(self) -> str:
        """The controller's own name, which stands before what it exports."""
        return self.controller.name


class Session(NamedTuple):
    """What one distro makes of a project. `started` are the controllers that are started, None where it is not known
    which are; `in_order` where they are started one after the other. Controllers of different namespaces have different
    managers."""

    distro: str
    hardware: Hardware
    controllers: tuple[Configured, ...]
    started: tuple[Configured, ...] | None
    in_order: bool = False

    @property
    def candidates(self) -> tuple[Configured, ...]:
        """The controllers that are started, or else all: each of them may be."""
        return self.controllers if self.started is None else self.started

    def named(self, name: str, beside: Configured) -> Configured | None:
        """The controller of a name in the manager of another one."""
        namespace = beside.controller.namespace
        return next((c for c in self.controllers if c.name == name and c.controller.namespace == namespace), None)


def sessions(project: Project) -> Iterator[Session]:
    """What each distro that a project may be for makes of it."""
    return (session_of(project, distro) for distro in project.distros)


def session_of(project: Project, distro: str) -> Session:
    """What one distro makes of a project."""
    hardware = hardware_of(project, distro)
    facts = _facts(project.robot, hardware)
    declared = project.controllers.controllers if project.controllers else ()
    configured = tuple(_configured(controller, project, distro, facts) for controller in declared)
    return Session(distro, hardware, configured, _started(project, configured), project.in_order)


def _facts(robot: Robot | None, hardware: Hardware) -> RobotFacts:
    joints = robot.joints if robot else ()
    movable = tuple(joint.name for joint in joints if joint.name and joint.type in _MOVABLE)
    return RobotFacts(movable, tuple((offer.component, offer.interface) for offer in hardware.state))


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


def _started(project: Project, configured: tuple[Configured, ...]) -> tuple[Configured, ...] | None:
    if project.started is None or project.controllers is None:
        return None
    by_controller = {id(one.controller): one for one in configured}
    found = (project.controllers.controller(name) for name in project.started)
    names = dict.fromkeys(id(controller) for controller in found if controller is not None)
    return tuple(by_controller[name] for name in names)
