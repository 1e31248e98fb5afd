"""The types in a project that a package of the workspace may define. Apart from own_types.py, which most runs never
import."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from urdfctl.catalog.distros import ALL
from urdfctl.model.project import Project
from urdfctl.source.opaque import is_known


def unknown_types(project: Project) -> set[str]:
    """Return the names of the controllers and the hardware of a project that the catalogue does not have."""
    catalog = project.catalog
    unknown = {kind for kind in _kinds(project) if "/" in kind or "::" in kind if not catalog.distros_of(kind)}
    return unknown | {name for name in _hardware(project) if not any(catalog.hardware(name, d) for d in ALL)}


def shared_types(project: Project, is_in_workspace: Callable[[str], bool]) -> set[str]:
    """Return the controller types of a project that the catalogue has, and that begin with the name of a package of the
    workspace: it may define another controller with that type."""
    known = {kind for kind in _kinds(project) if project.catalog.distros_of(kind)}
    return {kind for kind in known if is_in_workspace(kind.partition("/")[0])}


def _kinds(project: Project) -> set[str]:
    controllers = project.controllers.controllers if project.controllers else ()
    return {one.type.text for one in controllers if one.type is not None and one.type.is_known}


def _hardware(project: Project) -> Iterator[str]:
    robot = project.robot
    if robot is None:
        return
    for control in robot.ros2_controls:
        if control.plugin and is_known(control.plugin):
            yield control.plugin.strip()
    for plugin in robot.plugins:
        for tag in plugin.tag.named("robotSimType"):
            if tag.text and is_known(tag.text):
                yield tag.text.strip()
