"""UC650."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hosts import hosts_no_manager
from urdfctl.model.controllers import Manager
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch.common import ROS_2, Running, launch_of, manager_nodes, managers
from urdfctl.rules.launch_samples import CONTROLLERS, FILE, MANAGER, PUBLISHER, launched, spawner

_NAMED = MANAGER.replace('exec="ros2_control_node"', 'exec="ros2_control_node" name="manager"')
_SPAWNERS = spawner("joint_state_broadcaster -c /manager"), spawner(f"arm_controller -c /manager {FILE}")


@rule(
    "UC650",
    severity=Severity.ERROR,
    runtime="refuses",
    stage=StageDependsOn.SPAWNER,
    distros=ROS2,
    authority="rclcpp: a node reads the sections with its own name and with wildcards; ros2_control controller_manager.cpp: "
    "'The 'type' param was not defined for 'arm_controller'.'",
    options=["--distro=jazzy"],
    bad=[
        launched(
            PUBLISHER,
            _NAMED,
            *_SPAWNERS,
            controllers=CONTROLLERS.replace("controller_manager:", "«controller_manager»:"),
        )
    ],
    good=[launched(PUBLISHER, _NAMED, *_SPAWNERS, controllers=CONTROLLERS.replace("controller_manager:", "manager:"))],
)
def manager_section_not_read(project: Project) -> Iterator[Finding]:
    """Section of a controller manager is for a node of another name.

    The controller manager has another name than the section, so it gets neither the update rate nor the types of its
    controllers: they are not loaded. Name the section like the node, or leave the node its name.
    """
    launch, controllers = launch_of(project, ROS_2), project.controllers
    if launch is None or controllers is None or not controllers.complete or not launch.complete:
        return
    running = managers(project, launch)
    nodes = manager_nodes(launch)
    if not running or any(each.name is None for each in running) or not all(node.complete for node in nodes):
        return
    if not all(node in nodes or hosts_no_manager(node) for node in launch.nodes):
        return
    declared = {manager.name for manager in controllers.managers if manager.own}
    for manager in controllers.managers:
        lonely = [each for each in running if each.name not in declared]
        if manager.own and manager.name not in {each.name for each in running} and lonely and _declares(manager):
            yield _finding(manager, lonely[0])


def _declares(manager: Manager) -> bool:
    """Whether a section names controllers, and no other of its file is for every node."""
    return any(name.endswith(".type") for name in (parameter.name for parameter in manager.own))


def _finding(manager: Manager, running: Running) -> Finding:
    message = f"section '{manager.name}' is of no running node; the controller manager is called '{running.name}'"
    fix = replaced(manager.at, manager.name, running.name or "")
    return Finding(manager.at, message, (Note("it gets its name here", running.at),), fix)
