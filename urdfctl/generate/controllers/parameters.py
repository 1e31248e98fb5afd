"""The parameters of one controller, each with a comment: those of its recipe, then the other required ones."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import expected
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameters.rules import breaches
from urdfctl.control.parameters.values import Values
from urdfctl.errors import UserError
from urdfctl.generate.controllers.minimal_parameters import checked, minimal_settings
from urdfctl.generate.controllers.recipes import recipe_of
from urdfctl.generate.controllers.values import Left, Task, answer, gains
from urdfctl.generate.robot.facts import JointFacts
from urdfctl.generate.text.settings import WrittenParameter
from urdfctl.startup.records import NamedTuple

_PLACEHOLDER = re.compile(r"<([^<>]+)>")


class GeneratedController(NamedTuple):
    """A generated controller. `waits`: it is loaded and not started, because another one commands its joints."""

    name: str
    type: ControllerType
    settings: tuple[WrittenParameter, ...]
    task: Task
    waits: bool = False

    @property
    def values(self) -> dict[str, object]:
        """The parameters by dotted name."""
        return {".".join(setting.path): setting.value for setting in self.settings}

    @property
    def reports(self) -> bool:
        """Whether it only publishes states and does not move anything."""
        return self.type.broadcaster or "joint_state" in self.type.type


def controller(name: str, kind: ControllerType, task: Task) -> GeneratedController:
    """Return a controller with its parameters. UserError if they do not fit what the catalogue knows of the type."""
    made = GeneratedController(name, kind, tuple(_settings(kind, task)), task)
    _check(made)
    return made


def _check(made: GeneratedController) -> None:
    """UserError if a controller's parameters break a rule of the catalogue."""
    named = expected(made.type.parameters, Values(made.type, made.values))
    for setting in made.settings:
        parameter = made.type.parameters[setting.name]
        why = type_problem(setting.value, parameter, made.type.distro) or problem(setting.value, parameter.validators)
        if why:
            raise UserError(f"'{made.type.type}': '{setting.name}' {why}. Check that all required joints are given")
    for breach in breaches(made.type, made.values):
        if breach.rule.severity == "error":
            raise UserError(f"'{made.type.type}': '{breach.parameter}' {breach.message}")
    missing = [name for name, parameter in named.items() if parameter.needed and name not in made.values]
    if missing:
        raise UserError(f"'{made.type.type}' requires '{missing[0]}', but its value is unknown")


def _settings(controller: ControllerType, task: Task) -> Iterator[WrittenParameter]:
    recipe = recipe_of(controller)
    if recipe is None:
        yield from (checked(setting, task) for setting in minimal_settings(controller, task))
        return
    given: set[str] = set()
    for name, (value, comment) in recipe.items():
        parameter = controller.parameters.get(name)
        if parameter is None or parameter.deprecated or parameter.ignored:
            continue
        given.add(name)
        for setting in _of_parameter(name, value, comment, task):
            yield _fitted(setting, parameter.type)
    for setting in minimal_settings(controller, task):
        if setting.name not in given:
            yield checked(setting, task)


def _of_parameter(name: str, value: Any, comment: str, task: Task) -> Iterator[WrittenParameter]:
    if not _PLACEHOLDER.search(name):
        yield from _setting(name=name, path=tuple(name.split(".")), value=value, comment=comment, task=task, joint=None)
        return
    for index, joint in enumerate(task.joints):
        path = tuple(joint.name if part.startswith("<") else part for part in name.split("."))
        yield from _setting(
            name=name,
            path=path,
            value=value,
            comment=comment if not index or comment == "$gains" else "",
            task=task,
            joint=joint,
        )


def _setting(
    name: str, path: tuple[str, ...], value: Any, comment: str, task: Task, joint: JointFacts | None
) -> Iterator[WrittenParameter]:
    how, filled = "", value
    if isinstance(value, str) and value.startswith("$"):
        value_found = answer(value[1:], task, joint)
        if isinstance(value_found, Left):
            return
        filled, how = value_found.value, value_found.how
    elif isinstance(value, list):
        filled = [_element(part, task, joint) for part in value]
    if comment == "$gains":
        text = gains(task, joint or task.joints[0]).how
    else:
        unit = "N or Nm" if task.interface == "effort" else "rad/s or m/s"
        plain = comment.replace("$how", how).replace("$unit", unit)
        both = "; ".join(part for part in (plain, how) if part)
        text = plain if "$how" in comment or not how or how == plain else both
    yield WrittenParameter(name, path, filled, text)


def _element(part: object, task: Task, joint: JointFacts | None) -> object:
    """An element of a list, with its `$name` replaced by the value."""
    if not (isinstance(part, str) and part.startswith("$")):
        return part
    value = answer(part[1:], task, joint)
    return part if isinstance(value, Left) else value.value


def _fitted(setting: WrittenParameter, kind: str) -> WrittenParameter:
    """The setting with its value converted to the type of the parameter. In ROS 1 a single wheel is a string."""
    value = setting.value
    if isinstance(value, list) and len(value) == 1 and "string_array" not in kind:
        return setting._replace(value=value[0])
    if isinstance(value, int) and not isinstance(value, bool) and kind == "double" and "rate" not in setting.name:
        return setting._replace(value=float(value))
    return setting
