"""UC601."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Controller, Controllers
from urdfctl.model.launch import Launch, Spawn
from urdfctl.names import fuller, is_only_slip, nearest
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import in_words, replaced
from urdfctl.rules.launch.common import ROS_2, is_spawner, managers
from urdfctl.rules.launch_samples import (
    ARM,
    BROADCASTER,
    CONTROLLERS,
    FILE,
    MANAGER,
    PUBLISHER,
    SOUND,
    launched,
    spawner,
)
from urdfctl.source.span import Place
from urdfctl.startup.per_object import once_for_the_last

_TYPE = "type: joint_trajectory_controller/JointTrajectoryController"
_TYPED_ITSELF = CONTROLLERS.replace(f"        arm_controller:\n          {_TYPE}\n", "").replace(
    "joints: [", f"{_TYPE}\n        joints: ["
)


@rule(
    "UC601",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager.cpp: 'The 'type' param was not defined for 'arm'.'; ros_control "
    "controller_manager.cpp: 'Could not load controller 'arm' because the type was not specified.'",
    bad=[
        launched(PUBLISHER, MANAGER, BROADCASTER, spawner(f"«arm_controler» {FILE}")),
        launched(PUBLISHER, MANAGER, BROADCASTER, spawner("«arm_controller»"), controllers=_TYPED_ITSELF),
    ],
    good=[SOUND, launched(PUBLISHER, MANAGER, BROADCASTER, ARM, controllers=_TYPED_ITSELF)],
)
def spawned_controller_unknown(project: Project) -> Iterator[Finding]:
    """Unknown controller is spawned.

    No parameter file declares the controller. The controller manager finds no type for it and does not load it, and the
    spawner exits with an error. Usually the name is misspelt, or declared in another namespace; or its type is in its own
    section, which the manager reads only from a file that the spawner gets.
    """
    launch, controllers = project.launch, project.controllers
    if launch is None or controllers is None or not controllers.complete or not launch.complete:
        return
    declared = [controller for controller in controllers.controllers if controller.declared_at is not None]
    if not _is_all_known(project, launch):
        return
    if not declared:
        yield from _of_empty_files(launch, controllers)
        return
    for spawn in launch.spawns:
        if spawn.option("-t", "--controller-type") is None:
            for name, at in spawn.names:
                meant = [controller for controller in declared if _is_meant(name, spawn, controller)]
                if not meant:
                    yield _finding(name, at, spawn, controllers, launch)
                elif launch.ros == ROS_2 and all(_is_typed_in_vain(spawn, controller) for controller in meant):
                    message = f"type of controller '{name}' is only in its own section, which the manager does not read"
                    yield Finding(at, f"{message}; give the spawner the file with --param-file")


def _is_typed_in_vain(spawn: Spawn, controller: Controller) -> bool:
    """Whether the type is only in the controller's own section, and the spawner passes no file on."""
    passes = bool(spawn.files) or spawn.option("-p", "--param-file") is not None
    known = spawn.sure and spawn.complete and is_spawner(spawn)
    return known and not passes and controller.manager is None and controller.own.value("type") is not None


def _of_empty_files(launch: Launch, controllers: Controllers) -> Iterator[Finding]:
    """Yield one finding if all parameter files that are loaded have no content."""
    spawned = [(name, at) for spawn in launch.spawns if spawn.sure for name, at in spawn.names]
    if spawned and controllers.files and all(file.empty for file in controllers.files):
        name, at = spawned[0]
        file = controllers.files[0]
        text = "has only comments" if file.at.source.data.strip() else "is empty"
        message = f"controller file {text}, but controller '{name}' is spawned"
        yield Finding(file.at, message, (Note("it is spawned here", at),))


def _is_all_known(project: Project, launch: Launch) -> bool:
    """Return whether all parameters of the running managers are known. In ROS 2, every manager and all its files must be."""
    if launch.ros != ROS_2:
        return True
    running = managers(project, launch)
    return bool(running) and all(manager.node is None or manager.node.complete for manager in running)


def _is_meant(name: str, spawn: Spawn, controller: Controller) -> bool:
    if controller.name != name.rpartition("/")[2]:
        return False
    full = spawn.full_name(name)
    return controller.namespace is None or not full.startswith("/") or full == controller.full_name


@once_for_the_last
def _declared(controllers: Controllers) -> dict[str, Controller]:
    """The first declared controller of each name."""
    return {one.name: one for one in reversed(controllers.controllers) if one.declared_at is not None}


@once_for_the_last
def _in_words(controllers: Controllers) -> str:
    return in_words(sorted(_declared(controllers)))


@once_for_the_last
def _taken(launch: Launch) -> set[str]:
    return {name.rpartition("/")[2] for spawn in launch.spawns for name, _ in spawn.names}


def _finding(name: str, at: Place, spawn: Spawn, controllers: Controllers, launch: Launch) -> Finding:
    severity = None if spawn.sure else Severity.WARNING
    declared = _declared(controllers)
    last = name.rpartition("/")[2]
    elsewhere = declared.get(last)
    if elsewhere is not None and elsewhere.declared_at is not None:
        namespace = spawn.full_name(name).rpartition("/")[0]
        message = f"controller '{last}' is spawned in namespace '{namespace or '/'}', but declared in "
        message += f"'{elsewhere.namespace or '/'}'"
        return Finding(at, message, (Note("it is declared here", elsewhere.declared_at),), severity=severity)
    free = declared.keys() - _taken(launch)
    meant = nearest(last, free) or fuller(last, free)
    if meant is None:
        names = _in_words(controllers)
        message = f"controller '{name}' is spawned, but no file declares it; declared: {names}"
        return Finding(at, message, severity=severity)
    is_sure = spawn.sure and is_only_slip(last, meant, declared)
    fix: Fix = replaced(at, name, name.removesuffix(last) + meant, safe=is_sure)
    message = f"controller '{name}' is spawned, but no file declares it; did you mean '{meant}'?"
    return Finding(at, message, (), fix, severity)
