"""Types of controllers: which are known, which of them a slip means, and where each is to be had."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1, ROS2, generation
from urdfctl.catalog.entries import Replacement
from urdfctl.memory import once_for_the_last
from urdfctl.model.controllers import Controller
from urdfctl.model.parameters import Value
from urdfctl.record import NamedTuple
from urdfctl.rule import Project
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.controllers.readers import is_of_ros2, type_of
from urdfctl.suggest import nearest

_ALIKE = 0.9


class Typed(NamedTuple):
    """A controller with the type that its file gives, and the distros that may have to load it: of its generation."""

    controller: Controller
    type: str
    at: Value
    distros: tuple[str, ...]
    known_in: tuple[str, ...]

    @property
    def ros(self) -> int:
        """1 or 2."""
        return generation(self.distros[0])


@once_for_the_last
def typed(project: Project) -> tuple[Typed, ...]:
    """The controllers whose type stands literally in their file."""
    found = []
    for controller in controllers_in(project).controllers:
        kind = type_of(controller)
        family = ROS2 if is_of_ros2(project, controller) else ROS1
        distros = tuple(distro for distro in project.distros if distro in family)
        if kind is not None and controller.type is not None and distros:
            known_in = project.catalog.distros_of(kind)
            found.append(Typed(controller, kind, controller.type, distros, known_in))
    return tuple(found)


@once_for_the_last
def _known(project: Project) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The types of each generation that come with ros_control and ros2_control themselves."""
    return tuple(tuple(_own_types(project, family)) for family in (ROS1, ROS2))  # type: ignore[return-value]


def _own_types(project: Project, family: tuple[str, ...]) -> Iterator[str]:
    catalog = project.catalog
    for distro in family:
        for name in catalog.known_types(distro):
            kind = catalog.controller(name, distro)
            if kind is not None and not kind.external:
                yield name


def meant_by(project: Project, unknown: Typed) -> str | None:
    """The known type that a type means which no catalogue has; None where it may well be a package of its own."""
    types = list(dict.fromkeys(_known(project)[unknown.ros - 1]))
    text = unknown.type.strip(" '\"").replace("::", "/")
    parts = text.split("/")
    package, name = parts[0], parts[-1]
    if f"{package}/{name}" in types:
        return f"{package}/{name}"
    same = nearest(text, types)
    if same is not None and same.casefold() == text.casefold():
        return same
    if len(parts) == 1:
        return next((one for one in types if one.partition("/")[2] == name), None) or _only_one_of(package, types)
    return _of_package(package, name, types) or _of_alike_package(package, name, types)


def _of_package(package: str, name: str, types: list[str]) -> str | None:
    """The type that is meant where the package is right, or is that of the source of some."""
    inside = [one for one in types if one.partition("/")[0] == package]
    if not inside and package != "gripper_controllers":  # the package that these come in; their types begin otherwise
        return None
    classes = {one.partition("/")[2]: one for one in types}
    if name in classes:
        return classes[name]
    close = nearest(name, [one.partition("/")[2] for one in inside])
    return f"{package}/{close}" if close else _only_one_of(package, types)


def _only_one_of(package: str, types: list[str]) -> str | None:
    """The type of a package that has no other."""
    inside = [one for one in types if one.partition("/")[0] == package]
    return inside[0] if len(inside) == 1 else None


def _of_alike_package(package: str, name: str, types: list[str]) -> str | None:
    """The type whose package and class are both nearly what is written: `controllers` for `controller`."""
    from difflib import SequenceMatcher

    for one in types:
        known_package, _, known_name = one.partition("/")
        alike = (SequenceMatcher(None, *pair).ratio() for pair in ((package, known_package), (name, known_name)))
        if all(ratio >= _ALIKE for ratio in alike):
            return one
    return None


def instead_of(project: Project, kind: str, distro: str) -> tuple[Replacement | None, str]:
    """What takes the place of a type in a distro, and that in words: `use 'x/Y' with 'interface_name: position'`."""
    found = project.catalog.replacement(kind, distro)
    if found is None:
        return None, ""
    parts = [f"{name}: {_plain(value)}" for name, value in found.parameters.items()]
    return found, f"use '{found.type}'" + (f" with '{', '.join(parts)}'" if parts else "")


def _plain(value: object) -> str:
    return f"[{', '.join(map(str, value))}]" if isinstance(value, list) else str(value)
