"""UC601."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Controller, Controllers
from urdfctl.model.launch import Launch, Spawn
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch.common import ROS_2, manager_nodes, simulators_managers
from urdfctl.rules.launch.samples import BROADCASTER, FILE, MANAGER, PUBLISHER, SOUND, launched, spawner
from urdfctl.source.span import Place
from urdfctl.suggest import nearest


@rule(
    "UC601",
    severity=Severity.ERROR,
    authority="ros2_control controller_manager.cpp: 'The 'type' param was not defined for 'arm'.'; ros_control "
    "controller_manager.cpp: 'Could not load controller 'arm' because the type was not specified.'",
    bad=launched(PUBLISHER, MANAGER, BROADCASTER, spawner(f"«arm_controler» {FILE}")),
    good=SOUND,
)
def spawned_controller_unknown(project: Project) -> Iterator[Finding]:
    """A controller is spawned that no file declares.

    The controller manager finds no type for it and refuses to load it; the spawner ends with an error. Most often it is
    misspelt, or declared in another namespace.
    """
    launch, controllers = project.launch, project.controllers
    if launch is None or controllers is None or not controllers.complete or not launch.complete:
        return
    declared = [one for one in controllers.controllers if one.declared_at is not None]
    if not declared or not _is_all_known(project, launch):
        return
    for spawn in launch.spawns:
        if spawn.option("-t", "--controller-type") is None:
            for name, at in spawn.names:
                if not any(_is_meant(name, spawn, one) for one in declared):
                    yield _finding(name, at, spawn, controllers, launch.ros)


def _is_all_known(project: Project, launch: Launch) -> bool:
    """Whether all parameters of the managers that run are in the files: of ROS 2 each is known, and given no others."""
    if launch.ros != ROS_2:
        return True
    nodes = manager_nodes(launch)
    if not nodes and not any(True for _ in simulators_managers(project)):
        return False
    return all(node.complete and all("type" not in word.text for word in node.parameters) for node in nodes)


def _is_meant(name: str, spawn: Spawn, controller: Controller) -> bool:
    if controller.name != name.rpartition("/")[2]:
        return False
    unknown = controller.namespace is None or spawn.namespace is None
    return unknown or f"{spawn.namespace}/{name}" == controller.full_name


def _finding(name: str, at: Place, spawn: Spawn, controllers: Controllers, ros: int) -> Finding:
    severity = None if spawn.sure else Severity.WARNING
    declared = [one for one in controllers.controllers if one.declared_at is not None]
    elsewhere = next((one for one in declared if one.name == name), None)
    if elsewhere is not None and elsewhere.declared_at is not None:
        message = f"'{name}' is spawned in the namespace '{spawn.namespace or '/'}', and declared in "
        message += f"'{elsewhere.namespace or '/'}'"
        return Finding(at, message, (Note("declared here", elsewhere.declared_at),), severity=severity)
    meant = nearest(name, [one.name for one in declared])
    if meant is None:
        severity = Severity.WARNING if ros != ROS_2 else severity  # another launch file may have loaded its parameters
        names = ", ".join(sorted({f"'{one.name}'" for one in declared})[:5])
        return Finding(at, f"'{name}' is spawned, and no file declares it; declared are {names}", severity=severity)
    fix: Fix = replaced(at, name, meant)
    return Finding(at, f"'{name}' is spawned, and no file declares it; did you mean '{meant}'?", (), fix, severity)
