"""The types in a project that the catalogue does not have. Apart from own_types.py, which most runs never import."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ALL
from urdfctl.model.project import Project
from urdfctl.source.opaque import is_known


def unknown_types(project: Project) -> set[str]:
    """Return the names of the controllers and the hardware of a project that the catalogue does not have."""
    catalog = project.catalog
    controllers = project.controllers.controllers if project.controllers else ()
    kinds = {one.type.text for one in controllers if one.type is not None and one.type.is_known}
    unknown = {kind for kind in kinds if "/" in kind or "::" in kind if not catalog.distros_of(kind)}
    return unknown | {name for name in _hardware(project) if not any(catalog.hardware(name, d) for d in ALL)}


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
