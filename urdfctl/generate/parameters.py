"""The parameters of one controller: by its recipe, then the least that it needs, each with what is to be said of it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import expected
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameter_rules import breaches
from urdfctl.control.values import Values
from urdfctl.errors import UserError
from urdfctl.generate.facts import JointFacts
from urdfctl.generate.least import checked, least_settings
from urdfctl.generate.recipes import recipe_of
from urdfctl.generate.settings import Setting
from urdfctl.generate.values import Left, Task, answer, gains
from urdfctl.hints import Any
from urdfctl.record import NamedTuple

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

    @property
    def reports(self) -> bool:
        """Whether it tells of states, and moves nothing."""
        return self.type.broadcaster or "joint_state" in self.type.type


def controller(name: str, kind: ControllerType, task: Task) -> Controller:
    """A controller of a type with its parameters. UserError where the catalogue knows them to be wrong."""
    made = Controller(name, kind, tuple(_settings(kind, task)), task)
    _check(made)
    return made


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
        yield from (checked(setting, task) for setting in least_settings(controller, task))
        return
    given: set[str] = set()
    for name, (value, comment) in recipe.items():
        parameter = controller.parameters.get(name)
        if parameter is None or parameter.deprecated or parameter.ignored:
            continue
        given.add(name)
        for setting in _of_parameter(name, value, comment, task):
            yield _fitted(setting, parameter.type)
    for setting in least_settings(controller, task):
        if setting.name not in given:
            yield checked(setting, task)


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
