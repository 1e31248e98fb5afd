"""Create the requested controllers: in parallel on the hardware, or connected in a chain."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import since
from urdfctl.control.claims import claims, exports
from urdfctl.errors import UserError
from urdfctl.generate.controllers.assignment import Wish, assigned, without_conflicts
from urdfctl.generate.controllers.parameters import GeneratedController, controller
from urdfctl.generate.controllers.recipes import BROADCASTER, NamedType, kind_of, only_deprecated, type_of
from urdfctl.generate.controllers.tasks import tasks_of
from urdfctl.generate.controllers.values import Task
from urdfctl.generate.options import GeneratorOptions, Request
from urdfctl.generate.robot.facts import NO_ROBOT, JointFacts, RobotFacts

_CHAINING = since("humble")


def controllers(
    joints: Sequence[JointFacts], options: GeneratorOptions, catalog: Catalog, robot: RobotFacts = NO_ROBOT
) -> tuple[GeneratedController, ...]:
    """Return the requested controllers in the order in which they are started, the joint state broadcaster first.

    UserError if the distro does not have a type, or if the joints do not fit.
    """
    asked = [*(Request("", name) for name in options.types), *options.requests]
    wanted = [Wish(request, kind_of(request.type, catalog, options)) for request in asked]
    reporting = [kind for _, kind in wanted if BROADCASTER in (kind.name, kind.label) or "joint_state" in kind.name]
    first = [Wish(Request("", BROADCASTER), kind_of(BROADCASTER, catalog, options))]
    first = first if options.broadcaster and not reporting else []
    if options.chain:
        parallel = [wish for wish in wanted if wish.request in options.requests]
        made = _side_by_side([*first, *parallel], joints, options, catalog, robot)
        kinds = [wish.kind for wish in wanted if wish not in parallel]
        return _renamed([*made, *_chained(kinds, joints, options, catalog, robot)], options)
    return _renamed(_side_by_side([*first, *wanted], joints, options, catalog, robot), options)


def _side_by_side(
    wishes: Sequence[Wish], joints: Sequence[JointFacts], options: GeneratorOptions, catalog: Catalog, robot: RobotFacts
) -> list[GeneratedController]:
    """Controllers that command the hardware, each for its own joints."""
    made: list[tuple[int, GeneratedController]] = []
    named: set[str] = set()
    for index, job in assigned(wishes, joints, options, robot):
        kind, request, its = job.kind, job.request, job.options
        asked = bool(request.interfaces)
        if len(wishes) > 1 and its.interface and not asked and only_deprecated(kind, its.interface, catalog, its):
            its = its._replace(interfaces=())
        tasks = list(tasks_of(kind, job.joints, its, job.robot))
        created = [one for task in tasks for one in _of_task(kind, task, catalog)]
        if request.name and len(created) == 1:
            created = [created[0]._replace(name=request.name)]
        elif request.name and kind.each:
            created = [one._replace(name=_node_name(f"{request.name}_{one.task.joints[0].name}")) for one in created]
        elif request.name:
            created = [one._replace(name=request.name) for one in created]
        named |= {one.name for one in created if request.patterns}
        made += [(index, one) for one in created]
    made.sort(key=lambda one: (not one[1].reports, one[0]))
    return without_conflicts([one for _, one in made], named)


def _chained(
    wanted: Sequence[NamedType],
    joints: Sequence[JointFacts],
    options: GeneratorOptions,
    catalog: Catalog,
    robot: RobotFacts,
) -> list[GeneratedController]:
    """Controllers in a chain: each commands the one that is created, and started, before it."""
    if options.distro not in _CHAINING:
        raise UserError(f"{options.distro} does not support chained controllers; they require humble or later")
    drives = [kind for kind in wanted if kind.roles]
    for kind in drives:
        joints = next(tasks_of(kind, joints, options, robot)).joints
    made: list[GeneratedController] = []
    for kind in reversed(wanted):
        tasks = list(tasks_of(kind, joints, options, robot))
        if len(tasks) > 1 or kind.each:
            raise UserError(
                f"'{kind.name}' needs several controllers for these joints, so it cannot be part of a chain"
            )
        task = tasks[0]._replace(states=("velocity",)) if drives and not kind.roles else tasks[0]
        made += _of_task(kind, _before(made[-1], task) if made else task, catalog)
        if len(made) > 1:
            _check_chain(made[-1], made[-2])
    return made


def _before(below: GeneratedController, task: Task) -> Task:
    """The task of a controller that commands the interfaces exported by another one."""
    offered = exports(below.type, below.name, below.values)
    interfaces = tuple(dict.fromkeys(claim.interface for claim in offered.reference)) or task.interfaces
    states = tuple(dict.fromkeys(claim.interface for claim in offered.state)) if task.is_drive else ()
    return task._replace(interfaces=interfaces, states=states or task.states, below=f"{below.name}/")


def _check_chain(upper: GeneratedController, below: GeneratedController) -> None:
    """UserError if a controller commands an interface that the one below it does not export."""
    offered = {claim.name for claim in exports(below.type, below.name, below.values).reference}
    claimed = claims(upper.type, upper.name, upper.values)
    for claim in claimed.command if claimed else ():
        if claim.name not in offered:
            accepted = ", ".join(sorted(offered)) or "nothing"
            raise UserError(f"'{upper.name}' commands '{claim.name}', but '{below.name}' accepts {accepted}")


def _of_task(kind: NamedType, task: Task, catalog: Catalog) -> Iterator[GeneratedController]:
    of_type = type_of(kind, task.interfaces, catalog, task.options)
    if kind.each and not task.joints:
        raise UserError(f"'{kind.name}' requires a joint")
    for part in [task._replace(joints=(joint,)) for joint in task.joints] if kind.each else [task]:
        suffix = f"{kind.name}_controller" if kind.each and "/" not in kind.name else kind.label
        name = _node_name(f"{part.joints[0].name}_{suffix}" if kind.each else kind.label)
        made = controller(name, of_type, part)
        fitting = (controller(name, of_type, of_sensor) for of_sensor in _sensors(part))
        yield next((candidate for candidate in fitting if _is_offered(candidate)), made)


def _sensors(task: Task) -> Iterator[Task]:
    """A task for each of the robot's sensors, unless the user named one."""
    for part in task.robot.of_kind("sensor") if task.options.sensor is None else ():
        yield task._replace(options=task.options._replace(sensor=part.name))


def _is_offered(made: GeneratedController) -> bool:
    """Whether a sensor of the robot offers every state that a controller reads from it."""
    offered = {part.name: part.states for part in made.task.robot.of_kind("sensor")}
    claimed = claims(made.type, made.name, made.values)
    read = [claim for claim in claimed.state if claim.component in offered] if claimed else []
    return bool(read) and all(claim.interface in offered[claim.component] for claim in read)


def _renamed(made: Sequence[GeneratedController], options: GeneratorOptions) -> tuple[GeneratedController, ...]:
    """Controllers with unique names: the name given by the user for a single one, and a number for duplicates."""
    own = [created for created in made if "joint_state" not in created.type.type]
    if options.name and len(own) == 1:
        made = [created._replace(name=options.name) if created is own[0] else created for created in made]
    taken: dict[str, int] = {}
    unique: list[GeneratedController] = []
    for created in made:
        count = taken[created.name] = taken.get(created.name, 0) + 1
        unique.append(created if count == 1 else created._replace(name=f"{created.name}_{count}"))
    return tuple(unique)


def _node_name(text: str) -> str:
    """A valid node name: letters, digits and underscores, not starting with a digit."""
    plain = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_") or "joint_controller"
    return f"j{plain}" if plain[0].isdigit() else plain
