"""The controllers that an error of lint stops: those that it is about, or all of a file or manager that it breaks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.control.session import Configured, Session
from urdfctl.diagnostic import Diagnostic, Location
from urdfctl.model.controllers import Controller, Manager
from urdfctl.model.parameters import Parameters
from urdfctl.model.project import Project
from urdfctl.rules.controllers.controllers_file_not_a_map import controllers_file_not_a_map
from urdfctl.rules.controllers.manager_name_misspelt import manager_name_misspelt
from urdfctl.smoke.lost_joints import without_their_joints
from urdfctl.smoke.stages import loses_joints, stops_parameters
from urdfctl.source.span import Place


def labels_of(session: Session) -> dict[int, str]:
    """Return the name of each controller by identity, with its namespace if another controller has the same name."""
    names = [configured.name for configured in session.controllers]
    return {
        id(each): each.name if names.count(each.name) == 1 else f"/{each.controller.full_name.lstrip('/')}"
        for each in session.controllers
    }


def place_of(controller: Controller, project: Project) -> Place | None:
    """Return the place that declares a controller; if none does, that which starts it."""
    if controller.declared_at is not None:
        return controller.declared_at
    for spawn in project.launch.spawns if project.launch else ():
        for name, at in spawn.names:
            full = name if name.startswith("/") or spawn.namespace is None else f"{spawn.namespace}/{name}"
            if f"/{full.lstrip('/')}".endswith(f"/{controller.full_name.lstrip('/')}"):
                return at
    return controller.sections[0].at if controller.sections else None


def stops_whole_file(code: str) -> bool:
    """Return whether an error of a rule keeps a whole controller file from being read."""
    return stops_parameters(code) or code == controllers_file_not_a_map.code


def is_common(error: Diagnostic, project: Project, everyone: Sequence[Configured]) -> bool:
    """Return whether an error is not about single controllers, but about their file or their manager."""
    return stops_whole_file(error.code) or not (loses_joints(error) or concerned(error, project, everyone))


def stopped(error: Diagnostic, project: Project, everyone: Sequence[Configured], ros: int) -> list[Configured]:
    """Return the controllers that an error stops."""
    if stops_whole_file(error.code):
        whole = project.launch is not None if ros == 1 else _configures_manager(error.at.file, project)
        return [each for each in everyone if whole or _is_in_file(error.at.file, each.controller)]
    if loses_joints(error):
        return without_their_joints(error, project, everyone)
    about = concerned(error, project, everyone)
    if about or project.controllers is None:
        return about
    if error.code == manager_name_misspelt.code:
        return list(everyone)
    managers = [each for each in project.controllers.managers if _lies_in(error.at, _places_of_manager(each))]
    return [each for each in everyone if any(_is_managed(each.controller, manager) for manager in managers)]


def concerned(error: Diagnostic, project: Project, everyone: Sequence[Configured]) -> list[Configured]:
    """Return the controllers that an error is about: it lies in their parameters, or names them."""
    here = [each for each in everyone if _lies_in(error.at, _places(each.controller, project))]
    if here:
        return here
    full = [each for each in everyone if f"'/{each.controller.full_name.lstrip('/')}'" in error.message]
    return full or [each for each in everyone if f"'{each.name}'" in error.message]


def _is_managed(controller: Controller, manager: Manager) -> bool:
    return controller.manager is None or controller.manager.namespace == manager.namespace


def _lies_in(at: Location, places: Iterator[Place]) -> bool:
    spans = ((place.source.path, place.span) for place in places)
    return any(path == at.file and span.start <= at.start <= span.end for path, span in spans)


def _is_in_file(path: str, controller: Controller) -> bool:
    at = controller.declared_at
    places = [*(section.at for section in controller.sections), *([at] if at else [])]
    return any(place.source.path == path for place in places)


def _configures_manager(path: str, project: Project) -> bool:
    """Whether a controller manager reads a file, and ends if it cannot: its own parameters are in it."""
    managers = project.controllers.managers if project.controllers else ()
    return any(section.at.source.path == path for manager in managers for section in manager.sections)


def _places_of_manager(manager: Manager) -> Iterator[Place]:
    yield from (section.at for section in manager.sections)
    yield from _places_of_parameters(manager.parameters)


def _places(controller: Controller, project: Project) -> Iterator[Place]:
    at = place_of(controller, project)
    if at is not None:
        yield at
    if controller.type is not None:
        yield controller.type.at
    yield from (section.at for section in controller.sections)
    for parameters in (controller.parameters, controller.under_manager):
        yield from _places_of_parameters(parameters)


def _places_of_parameters(parameters: Parameters) -> Iterator[Place]:
    for parameter in parameters:
        yield parameter.key
        yield parameter.value.at
