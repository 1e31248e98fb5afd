"""Controller types: which are known, which one a misspelt type means, and which distros have each."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import chain

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import ROS1, ROS2, generation
from urdfctl.catalog.entries import Replacement
from urdfctl.control.parameters.readers import builds_fork, controllers_in, is_of_ros2, type_of
from urdfctl.model.controllers import Controller, Value
from urdfctl.model.project import Project
from urdfctl.names import is_alike, is_slip, nearest
from urdfctl.startup.per_object import once_for_the_last
from urdfctl.startup.records import NamedTuple

_ALIKE = 0.9


class TypedController(NamedTuple):
    """A controller with the type given in its file."""

    controller: Controller
    type: str
    at: Value
    """The value that gives the type."""
    distros: tuple[str, ...]
    """The distros that may load it: those of the project, of the controller's ROS generation."""
    known_in: tuple[str, ...]
    """The distros that have the type, of both generations."""

    @property
    def ros(self) -> int:
        """The ROS generation of the controller, 1 or 2."""
        return generation(self.distros[0])


@once_for_the_last
def typed(project: Project) -> tuple[TypedController, ...]:
    """Return the controllers with a literal type in their file."""
    controllers = []
    for controller in controllers_in(project).controllers:
        kind = type_of(controller)
        family = ROS2 if is_of_ros2(project, controller) else ROS1
        distros = tuple(distro for distro in project.distros if distro in family)
        if kind is not None and controller.type is not None and distros:
            known_in = distros if kind in project.own.controllers else project.catalog.distros_of(kind)
            controllers.append(TypedController(controller, kind, controller.type, distros, known_in))
    return tuple(controllers)


def typed_upstream(project: Project) -> Iterator[TypedController]:
    """Yield the controllers with a literal type that no package of the workspace defines."""
    return (each for each in typed(project) if each.type not in project.own.controllers)


@once_for_the_last
def _known(catalog: Catalog) -> tuple[dict[str, str], dict[str, str]]:
    """The types that come with ros_control and with ros2_control themselves, by generation, with their ROS packages."""
    by_generation = (map(catalog.types_of_ros_control, family) for family in (ROS1, ROS2))
    return tuple(dict(chain.from_iterable(types)) for types in by_generation)  # type: ignore[return-value]


def meant_by(project: Project, unknown: TypedController) -> str | None:
    """Return the known type that an unknown type means; None if it may be from another package."""
    own = nearest(unknown.type.strip(), project.own.controllers)
    if own is not None:
        return _of_same_class(project.catalog, unknown, own) or own
    return _meant_in(project.catalog, unknown.ros, unknown.type.strip(" '\"").replace("::", "/"))


def types_beside(project: Project, unknown: TypedController) -> list[str]:
    """Return the types called after the package of an unknown type, if it comes with ros_control or ros2_control.

    Then all are known. Empty if the workspace may be built with another version of the package.
    """
    package, catalog = unknown.type.partition("/")[0], project.catalog
    known = [each for distro in unknown.distros for each in catalog.types_of_ros_control(distro)]
    is_own = any(name.startswith(f"{package}/") for name in project.own.controllers)
    if is_own or all(owner != package for _, owner in known) or builds_fork(project, unknown.distros[-1]):
        return []
    return sorted({name for name, _ in known if name.startswith(f"{package}/")})


def is_surely_meant(project: Project, unknown: TypedController, meant: str) -> bool:
    """Return whether an unknown type surely means a known one: a slip, or the only type of the package it names."""
    package = unknown.type.partition("/")[0]
    only = _only_one_of(package, list(_known(project.catalog)[unknown.ros - 1]))
    named_alike = any(own.partition("/")[0] == package for own in project.own.controllers)
    return is_slip(unknown.type, meant) or (only == meant and not named_alike)


def _of_same_class(catalog: Catalog, unknown: TypedController, own: str) -> str | None:
    """The known type with the class that is written, which no package of the workspace has: a copy of its section."""
    wanted = unknown.type.strip().rpartition("/")[2]
    if own.rpartition("/")[2] == wanted:
        return None
    known = (name for distro in unknown.distros for name in catalog.known_types(distro))
    return next((name for name in known if name.rpartition("/")[2] == wanted), None)


@lru_cache(64)
def _meant_in(catalog: Catalog, ros: int, text: str) -> str | None:
    """The type of a catalogue that a text means. Two rules ask for each unknown type."""
    packages = _known(catalog)[ros - 1]
    types = list(packages)
    parts = text.split("/")
    package, name = parts[0], parts[-1]
    if f"{package}/{name}" in types:
        return f"{package}/{name}"
    same = nearest(text, types)
    if same is not None and same.casefold() == text.casefold():
        return same
    if len(parts) == 1:
        return next((each for each in types if each.partition("/")[2] == name), None) or _only_one_of(package, types)
    named_after = [each for each, ros_package in packages.items() if ros_package == package]
    return _of_package(package, name, types, named_after) or _of_alike_package(package, name, types)


def _of_package(package: str, name: str, types: list[str], named_after: list[str]) -> str | None:
    """The type that is meant if the package is right, or is the ROS package of types that start with another name."""
    inside = [each for each in types if each.partition("/")[0] == package]
    if not inside:
        return next((each for each in named_after if each.partition("/")[2] == name), None)
    classes = {each.partition("/")[2]: each for each in types}
    if name in classes:
        return classes[name]
    close = nearest(name, [each.partition("/")[2] for each in inside])
    return f"{package}/{close}" if close else _only_one_of(package, types)


def _only_one_of(package: str, types: list[str]) -> str | None:
    """The type of a package if it has only one."""
    inside = [each for each in types if each.partition("/")[0] == package]
    return inside[0] if len(inside) == 1 else None


def _of_alike_package(package: str, name: str, types: list[str]) -> str | None:
    """The type whose package and class both resemble the given ones: `controllers` for `controller`."""
    for known in types:
        known_package, _, known_name = known.partition("/")
        if is_alike(package, known_package, _ALIKE) and is_alike(name, known_name, _ALIKE):
            return known
    return None


def may_be_installed(project: Project, kind: str) -> bool | None:
    """Return whether a package that package.xml names may bring a type: the one that the type is called after, or one
    about control that the catalogue does not have. None without a package.xml.
    """
    package = project.launch.package if project.launch else None
    if package is None:
        return None
    named = kind.replace("::", "/").partition("/")[0]
    others = {name for name in package.dependencies if "control" in name or name.endswith(("_hw", "_hardware"))}
    return named == package.name or package.reaches(named) or not others <= _upstream(project.catalog)


@once_for_the_last
def _upstream(catalog: Catalog) -> frozenset[str]:
    """The packages about control of which the catalogue knows all controllers."""
    return frozenset(package for packages in _known(catalog) for package in packages.values()) | _WITHOUT_CONTROLLERS


_WITHOUT_CONTROLLERS = frozenset(
    "controller_manager controller_manager_msgs controller_interface control_msgs control_toolbox ros_control "
    "ros_controllers ros2_control ros2_controllers ros2controlcli gazebo_ros_control gazebo_ros2_control "
    "gz_ros2_control ign_ros2_control mujoco_ros2_control rqt_controller_manager rqt_joint_trajectory_controller "
    "moveit_ros_control_interface moveit_simple_controller_manager moveit_controller_manager_example".split()
)


def instead_of(project: Project, kind: str, distro: str) -> tuple[Replacement | None, str]:
    """Return the replacement of a type in a distro, and the advice: `use 'x/Y' with 'interface_name: position'`."""
    replacement = project.catalog.replacement(kind, distro)
    if replacement is None:
        return None, ""
    parts = [f"{name}: {_plain(value)}" for name, value in replacement.parameters.items()]
    return replacement, f"use '{replacement.type}'" + (f" with '{', '.join(parts)}'" if parts else "")


def _plain(value: object) -> str:
    return f"[{', '.join(map(str, value))}]" if isinstance(value, list) else str(value)
