"""The errors of lint that stop controllers: which controllers each of them stops, and at which stage."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

from urdfctl.catalog.values import is_set
from urdfctl.control.lifecycle import STAGES, stage_of_breach
from urdfctl.control.parameters.gains import Fate, missing_gains
from urdfctl.control.parameters.rules import breaches
from urdfctl.control.session import Configured
from urdfctl.diagnostic import Diagnostic, Location
from urdfctl.model.controllers import Controller, Manager, Parameters
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.model.stage import CONTROLLER_STAGES, Stage, StageDependsOn
from urdfctl.rules import stage_of
from urdfctl.rules.controllers.controllers_file_not_a_map import controllers_file_not_a_map
from urdfctl.rules.controllers.manager_name_misspelt import manager_name_misspelt
from urdfctl.rules.urdf.bodies import vanishing
from urdfctl.rules.urdf.tree import Tree
from urdfctl.source.span import Place

_stage_of = cache(stage_of)
LINT_REPORTS_IT = "urdfctl lint reports it as "
"""How the note of a finding of smoke begins that has the code of the error of lint."""


def stops_robot(error: Diagnostic) -> bool:
    """Return whether the robot cannot be spawned with an error of lint."""
    return _stage_of(error.code) is Stage.SPAWN


def stops_hardware(error: Diagnostic) -> bool:
    """Return whether the hardware cannot be started with an error of lint."""
    return _stage_of(error.code) is Stage.HARDWARE


def stops_parameters(code: str) -> bool:
    """Return whether an error of a fault keeps a controller file from being read, for all of its controllers."""
    return _stage_of(code) is Stage.PARAMETERS


def found_by_manager(error: Diagnostic) -> bool:
    """Return whether `urdfctl.control.lifecycle` finds an error of lint by itself, in the order of starting."""
    return _stage_of(error.code) is StageDependsOn.MANAGER


def loses_joints(error: Diagnostic) -> bool:
    """Return whether an error of lint is about links that Gazebo drops."""
    return _stage_of(error.code) is StageDependsOn.LOST_JOINTS


def stops_controller(error: Diagnostic) -> bool:
    """Return whether an error of lint stops controllers: by itself, and not by what a controller manager works out."""
    return _stage_of(error.code) not in {None, Stage.SPAWN, Stage.HARDWARE, StageDependsOn.MANAGER}


def stage_stopped(error: Diagnostic, configured: Configured, ros: int) -> Stage:
    """Return the stage at which an error of lint stops a controller, in ROS 1 or 2."""
    stage = _stage_of(error.code)
    if ros == 1:
        return _stage_without_gains(configured) if stage is StageDependsOn.GAINS else Stage.LOAD
    if stage is StageDependsOn.PARAMETER_CHECKS:
        return _stage_of_parameter_checks(configured)
    if stage is StageDependsOn.LOST_JOINTS:
        return Stage.ACTIVATE
    return stage if isinstance(stage, Stage) and stage in CONTROLLER_STAGES else Stage.LOAD


def _stage_without_gains(configured: Configured) -> Stage:
    """Without gains some controllers of ROS 1 are not loaded, others crash when they are started."""
    if configured.type is None:
        return Stage.LOAD
    fates = {missing.fate for missing in missing_gains(configured.type, configured.values)}
    return Stage.ACTIVATE if Fate.CRASH in fates and Fate.REFUSED not in fates else Stage.LOAD


def _stage_of_parameter_checks(configured: Configured) -> Stage:
    """A missing parameter with a check of its own fails when it is declared, on load; others when configuring."""
    kind = configured.type
    if kind is None:
        return Stage.LOAD
    required = (name for name, parameter in kind.parameters.items() if parameter.needed and not parameter.is_map)
    if any(not is_set(configured.values.get(name)) for name in required):
        return Stage.LOAD
    broken = [breach.rule for breach in breaches(kind, configured.values) if breach.rule.severity == "error"]
    return min(map(stage_of_breach, broken), key=STAGES.index, default=Stage.CONFIGURE)


# -- the controllers that an error stops -----------------------------------------------------------------------------


def place_of(controller: Controller, project: Project) -> Place | None:
    """Return the place that declares a controller; if none does, that which starts it."""
    if controller.declared_at is not None:
        return controller.declared_at
    for spawn in project.launch.spawns if project.launch else ():
        for name, at in spawn.names:
            full = spawn.full_name(name)
            if f"/{full.lstrip('/')}".endswith(f"/{controller.full_name.lstrip('/')}"):
                return at
    return controller.sections[0].at if controller.sections else None


def stops_whole_file(code: str) -> bool:
    """Return whether an error of a rule keeps a whole controller file from being read."""
    return stops_parameters(code) or code == controllers_file_not_a_map.code


def is_common(error: Diagnostic, project: Project, everyone: Sequence[Configured]) -> bool:
    """Return whether an error is not about single controllers, but about their file or their manager."""
    if _of_spawner(error) or stops_whole_file(error.code):
        return True
    return not (loses_joints(error) or concerned_controllers(error, project, everyone))


def stopped_controllers(
    error: Diagnostic, project: Project, everyone: Sequence[Configured], ros: int
) -> list[Configured]:
    """Return the controllers that an error stops."""
    if _of_spawner(error):
        return _spawned_at(error.at, project, everyone)
    if stops_whole_file(error.code):
        whole = project.launch is not None if ros == 1 else _configures_manager(error.at.file, project)
        return [each for each in everyone if whole or _is_in_file(error.at.file, each.controller)]
    if loses_joints(error):
        return _controllers_without_joints(error, project, everyone)
    about = concerned_controllers(error, project, everyone)
    if about or project.controllers is None:
        return about
    if error.code == manager_name_misspelt.code:
        return list(everyone)
    managers = [each for each in project.controllers.managers if _lies_in(error.at, _places_of_manager(each))]
    return [each for each in everyone if any(_is_managed(each.controller, manager) for manager in managers)]


def _of_spawner(error: Diagnostic) -> bool:
    return _stage_of(error.code) is StageDependsOn.SPAWNER


def _spawned_at(at: Location, project: Project, everyone: Sequence[Configured]) -> list[Configured]:
    """The controllers of the spawner at a place; all that are spawned if none is there."""
    spawns = project.launch.spawns if project.launch else ()
    here = [spawn for spawn in spawns if _lies_in(at, iter((spawn.at, *(place for _, place in spawn.names))))]
    full = {f"/{spawn.full_name(name).lstrip('/')}" for spawn in here or spawns for name, _ in spawn.names}
    named = [each for each in everyone if f"/{each.controller.full_name.lstrip('/')}" in full]
    last = {name.rpartition("/")[2] for name in full}
    return named or [each for each in everyone if each.name in last]


def concerned_controllers(error: Diagnostic, project: Project, everyone: Sequence[Configured]) -> list[Configured]:
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


# -- the joints that Gazebo drops with a link ------------------------------------------------------------------------
#
# gz_ros2_control and gazebo_ros2_control skip a joint that is not in the model; gazebo_ros_control does not start if a
# joint of a transmission is not there (default_robot_hw_sim.cpp).


def dropped_joints(error: Diagnostic, project: Project) -> frozenset[str]:
    """Return the names of the joints that Gazebo drops because of an error of lint.

    None are returned if the error is about something else, or if no moving joint is left: the robot is lost then.
    """
    robot = project.robot
    if robot is None or not loses_joints(error):
        return frozenset()
    lost = _dropped(error, robot)
    left = (joint.name for joint in robot.joints if joint.moves)
    return lost if any(name not in lost for name in left) else frozenset()


def _dropped(error: Diagnostic, robot: Robot) -> frozenset[str]:
    """The joints of the links that an error names, and of all links below them."""
    tree = Tree(robot)
    named = (body for body in vanishing(robot) if any(f"'{link.name}'" in error.message for link in body.links))
    links = {name for body in named for name in tree.below(body.head.name or "")}
    joints = (tree.parents[name] for name in links if name in tree.parents)
    return frozenset(joint.name for joint in joints if joint.name)


def stops_every_controller(error: Diagnostic, project: Project) -> bool:
    """Return whether gazebo_ros_control does not start, because a transmission has a joint that is dropped."""
    lost, robot = dropped_joints(error, project), project.robot
    transmissions = robot.transmissions if robot else ()
    return any(joint.name in lost for transmission in transmissions for joint in transmission.kept_joints)


def _controllers_without_joints(
    error: Diagnostic, project: Project, everyone: Sequence[Configured]
) -> list[Configured]:
    """Return the controllers that claim a joint which is dropped."""
    lost = dropped_joints(error, project)

    def needs_one(each: Configured) -> bool:
        claims = (*each.claims.command, *each.claims.state)
        return any(claim.component in lost and not claim.best_effort for claim in claims)

    return [each for each in everyone if needs_one(each)]
