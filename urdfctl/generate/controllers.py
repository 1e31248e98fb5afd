"""Controllers with all their parameters, each with what is to be said of it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import expected
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameter_rules import breaches
from urdfctl.control.values import Values
from urdfctl.errors import UserError
from urdfctl.generate.choice import joint_named
from urdfctl.generate.facts import NO_ROBOT, JointFacts, RobotFacts
from urdfctl.generate.least import least_settings
from urdfctl.generate.options import Options
from urdfctl.generate.recipes import BROADCASTER, Kind, interfaces_of, kind_of, recipe_of, type_of
from urdfctl.generate.settings import Setting
from urdfctl.generate.values import Left, Task, answer, gains
from urdfctl.generate.wheels import driven_and_steered, sides

_PLACEHOLDER = re.compile(r"<([^<>]+)>")


class Controller(NamedTuple):
    """A controller that is written."""

    name: str
    type: ControllerType
    settings: tuple[Setting, ...]
    task: Task

    @property
    def values(self) -> dict[str, object]:
        """The parameters by their dotted names."""
        return {".".join(setting.path): setting.value for setting in self.settings}


def controllers(
    joints: Sequence[JointFacts], options: Options, catalog: Catalog, robot: RobotFacts = NO_ROBOT
) -> tuple[Controller, ...]:
    """The controllers that are asked for, the broadcaster of the joints' states first. UserError where there is none
    of a type in the distro, or the joints do not fit."""
    wanted = [kind_of(name, catalog, options) for name in options.types]
    with_states = [kind for kind in wanted if BROADCASTER in (kind.name, kind.label) or "joint_state" in kind.name]
    if options.broadcaster and not with_states:
        wanted.insert(0, kind_of(BROADCASTER, catalog, options))
    free = list(joints)
    made: list[Controller] = []
    for kind in sorted(wanted, key=lambda kind: not kind.roles):
        tasks = list(_tasks(kind, free, options, robot))
        made += [one for task in tasks for one in _controllers(kind, task, catalog)]
        if kind.roles:
            used = {joint.name for task in tasks for joint in task.joints}
            free = [joint for joint in free if joint.name not in used]
    order = [kind.name for kind in wanted]
    made.sort(
        key=lambda one: (not one.type.broadcaster and "joint_state" not in one.type.type, order.index(one.task.kind))
    )
    return _renamed(made, options)


def _is_broadcaster(one: Controller) -> bool:
    return one.type.broadcaster or "joint_state" in one.type.type


def _tasks(kind: Kind, joints: Sequence[JointFacts], options: Options, robot: RobotFacts) -> Iterator[Task]:
    """What a kind's controllers are for: joints of different interfaces have one each."""
    if kind.roles:
        yield _drive(kind, joints, options, robot)
        return
    by_interface: dict[str, list[JointFacts]] = {}
    for joint in joints:
        by_interface.setdefault(_interface(kind, joint, options, robot), []).append(joint)
    if not by_interface:
        by_interface[kind.interface or "position"] = []
    if not kind.interface:
        by_interface = {options.interface or "position": list(joints)}
    for interface, members in by_interface.items():
        yield Task(kind.name, interface, tuple(members), (), (), (), (), robot, options)


def _interface(kind: Kind, joint: JointFacts, options: Options, robot: RobotFacts) -> str:
    asked = joint.interface or options.interface
    if asked:
        return asked
    fit = interfaces_of(kind, options)
    there = [name for name in robot.interfaces.get(joint.name, ()) if name in fit]
    return kind.interface if kind.interface in there or not there else there[0]  # type: ignore[return-value]


def _drive(kind: Kind, joints: Sequence[JointFacts], options: Options, robot: RobotFacts) -> Task:
    """The wheels by their roles: as the user says, else by where they are."""
    known = robot if robot.joints else None
    roles = [role for role, _ in kind.roles]
    found = {role: tuple(joint_named(known, name) for name in getattr(options.roles, role)) for role in roles}
    guessed = sides(joints) if "left" in roles else driven_and_steered(joints)
    for (role, count), guess in zip(kind.roles, guessed, strict=True):
        found[role] = found[role] or tuple(guess)
        _count(kind, role, count, found[role])
    if "left" in found and len(found["left"]) != len(found["right"]):
        left, right = len(found["left"]), len(found["right"])
        raise UserError(f"{left} wheels on the left and {right} on the right: name them with --left and --right")
    members = tuple(dict.fromkeys(joint for role in found.values() for joint in role))
    passive = tuple(joint for joint in joints if joint not in members and kind.name.startswith("tricycle"))
    of = [found.get(role, ()) for role in ("left", "right", "traction", "steering")]
    return Task(kind.name, "velocity", members, of[0], of[1], of[2], of[3], robot, options, passive)


def _count(kind: Kind, role: str, count: int, members: Sequence[JointFacts]) -> None:
    """UserError where a role has not as many joints as it wants."""
    if members and count in (0, len(members)):
        return
    wanted = f"{count} joint{'s' if count != 1 else ''}" if count else "joints"
    found = ", ".join(joint.name for joint in members)
    why = f"it is given {len(members)}: {found}" if members else "the robot does not tell which they are"
    raise UserError(f"'{kind.name}' needs --{role} with {wanted}: {why}")


def _controllers(kind: Kind, task: Task, catalog: Catalog) -> Iterator[Controller]:
    controller = type_of(kind, task.interface, catalog, task.options)
    if kind.each and not task.joints:
        raise UserError(f"'{kind.name}' needs a joint")
    for part in [task._replace(joints=(joint,)) for joint in task.joints] if kind.each else [task]:
        suffix = f"{kind.name}_controller" if kind.each and "/" not in kind.name else kind.label
        name = f"{part.joints[0].name}_{suffix}" if kind.each else kind.label
        made = Controller(_node_name(name), controller, tuple(_settings(controller, part)), part)
        _check(made)
        yield made


def _check(made: Controller) -> None:
    """UserError where a controller's parameters are not what the catalogue knows to be right."""
    named = expected(made.type.parameters, Values(made.type, made.values))
    for setting in made.settings:
        parameter = made.type.parameters[setting.name]
        why = type_problem(setting.value, parameter, made.type.distro) or problem(setting.value, parameter.validators)
        if why:
            raise UserError(f"'{made.type.type}': '{setting.name}' {why}; is it given the joints that it needs?")
    for breach in breaches(made.type, made.values):
        if breach.rule.severity == "error":
            raise UserError(f"'{made.type.type}': '{breach.parameter}' {breach.message}")
    missing = [name for name, parameter in named.items() if parameter.needed and name not in made.values]
    if missing:
        raise UserError(f"'{made.type.type}' needs '{missing[0]}', and nothing tells its value")


def _settings(controller: ControllerType, task: Task) -> Iterator[Setting]:
    recipe = recipe_of(controller)
    if recipe is None:
        yield from least_settings(controller, task)
        return
    given: set[str] = set()
    for name, (value, comment) in recipe.items():
        parameter = controller.parameters.get(name)
        if parameter is None or parameter.deprecated or parameter.ignored:
            continue
        for setting in _of_parameter(name, value, comment, task):
            given.add(name)
            yield _fitted(setting, parameter.type)
    for setting in least_settings(controller, task):
        if setting.name not in given:
            yield setting


def _of_parameter(name: str, value: Any, comment: str, task: Task) -> Iterator[Setting]:
    if not _PLACEHOLDER.search(name):
        yield from _setting(name, tuple(name.split(".")), value, comment, task, None)
        return
    for index, joint in enumerate(task.joints):
        path = tuple(joint.name if part.startswith("<") else part for part in name.split("."))
        yield from _setting(name, path, value, comment if not index or comment == "$gains" else "", task, joint)


def _setting(
    name: str, path: tuple[str, ...], value: Any, comment: str, task: Task, joint: JointFacts | None
) -> Iterator[Setting]:
    how, filled = "", value
    if isinstance(value, str) and value.startswith("$"):
        found = answer(value[1:], task, joint)
        if isinstance(found, Left):
            return
        filled, how = found.value, found.how
    elif isinstance(value, list):
        filled = [_element(part, task, joint) for part in value]
    if comment == "$gains":
        text = gains(task, joint or task.joints[0]).how
    else:
        unit = "N or Nm" if task.interface == "effort" else "rad/s or m/s"
        said = comment.replace("$how", how).replace("$unit", unit)
        text = said if "$how" in comment or not how or how == said else "; ".join(part for part in (said, how) if part)
    yield Setting(name, path, filled, text)


def _element(part: object, task: Task, joint: JointFacts | None) -> object:
    """An element of a list, with what its `$name` stands for."""
    if not (isinstance(part, str) and part.startswith("$")):
        return part
    found = answer(part[1:], task, joint)
    return part if isinstance(found, Left) else found.value


def _fitted(setting: Setting, kind: str) -> Setting:
    """A setting whose value has the type of its parameter: one wheel is a text in ROS 1."""
    value = setting.value
    if isinstance(value, list) and len(value) == 1 and "string_array" not in kind:
        return setting._replace(value=value[0])
    if isinstance(value, int) and not isinstance(value, bool) and kind == "double" and "rate" not in setting.name:
        return setting._replace(value=float(value))
    return setting


def _renamed(made: Sequence[Controller], options: Options) -> tuple[Controller, ...]:
    """Controllers of different names: by their interface where there are several of a kind, else by a number."""
    own = [one for one in made if one.task.kind != BROADCASTER]
    if options.name and len(own) == 1:
        made = [one._replace(name=options.name) if one is own[0] else one for one in made]
    taken: dict[str, int] = {}
    unique: list[Controller] = []
    for one in made:
        count = taken[one.name] = taken.get(one.name, 0) + 1
        unique.append(one if count == 1 else one._replace(name=f"{one.name}_{count}"))
    return tuple(unique)


def _node_name(text: str) -> str:
    """A name that a node may have: letters, digits and underscores, and no digit at its start."""
    plain = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_") or "joint_controller"
    return f"j{plain}" if plain[0].isdigit() else plain


def values_of(made: Sequence[Controller]) -> Mapping[str, Mapping[str, object]]:
    """The parameters of each controller, by its name."""
    return {one.name: one.values for one in made}
