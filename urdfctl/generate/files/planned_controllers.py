"""The controllers of a robot that its simulator's plugin loads itself, from a file that is not generated."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.entries import ControllerType
from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.controllers.values import Task
from urdfctl.generate.files.moveit import ACTIONS
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import JointFacts, OwnController, RobotFacts

_REPORTS = "JointStateBroadcaster"


def has_planned(robot: RobotFacts) -> bool:
    """Return whether a planner can use one of the controllers that a robot's plugin loads."""
    return any(_last(own.type) in ACTIONS for own in robot.own)


def planned_controllers(
    robot: RobotFacts, options: GeneratorOptions, catalog: Catalog
) -> tuple[GeneratedController, ...]:
    """Return those of a robot's own controllers that are started for a planner, the broadcaster of its joints first.

    Of several for one joint, the first one is started. UserError if one names a joint that the robot does not have, or
    if the distro has none of their types.
    """
    known = {own.type: catalog.controller(own.type, options.distro) for own in robot.own}
    planned = [own for own in robot.own if _last(own.type) in ACTIONS]
    if not any(known[own.type] for own in planned):
        lost = planned[0]
        raise UserError(f"{options.distro} has no '{lost.type}', the type of the robot's own controller '{lost.name}'")
    chosen = _chosen([own for own in robot.own if known[own.type]])
    return tuple(_made(own, kind, robot, options) for own in chosen if (kind := known[own.type]))


def _chosen(known: Sequence[OwnController]) -> Iterator[OwnController]:
    yield from (own for own in known if _last(own.type) == _REPORTS)
    taken: set[str] = set()
    for own in known:
        if _last(own.type) in ACTIONS and own.joints and taken.isdisjoint(own.joints):
            taken.update(own.joints)
            yield own


def _made(
    own: OwnController, kind: ControllerType, robot: RobotFacts, options: GeneratorOptions
) -> GeneratedController:
    known = {joint.name: joint for joint in robot.joints}
    unknown = [name for name in own.joints if name not in known]
    if unknown:
        raise UserError(f"the robot's own controller '{own.name}' names joint '{unknown[0]}', which the robot lacks")
    joints: tuple[JointFacts, ...] = tuple(known[name] for name in own.joints)
    commanded = own.interfaces or ("position",)
    task = Task(kind="", interfaces=commanded, joints=joints, robot=robot, options=options, states=())
    return GeneratedController(own.name, kind, (), task)


def _last(name: str) -> str:
    return name.rpartition("/")[2]
