"""UC610."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.controllers import Controller
from urdfctl.model.launch import Spawn
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, is_spawner, launch_of
from urdfctl.rules.launch_samples import BROADCASTER, MANAGER, PUBLISHER, SOUND, launched, spawner

_LOSING = since("lyrical")


@rule(
    "UC610",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=_LOSING,
    options=("--distro=lyrical",),
    authority="ros2_control #1694 (jazzy): parameters of controllers are given to the spawner; jazzy and kilted still hand "
    "those of the manager on (controller_manager.cpp: determine_controller_node_options); #3016 (lyrical): the manager "
    "no longer does: 'Length of parameter 'joints' is '0' but must be greater than '0''",
    bad=[launched(PUBLISHER, MANAGER, BROADCASTER, spawner("«arm_controller»"))],
    good=[SOUND],
)
def parameters_not_given_to_controller(project: Project) -> Iterator[Finding]:
    """Controller parameters are passed to the manager, not to the spawner.

    Since lyrical, the manager no longer passes its own parameters on: they are passed with the spawner's
    `--param-file`. The controller is rejected if it has required parameters, and otherwise uses its defaults. In jazzy
    and kilted, whose guides demand the option too, the manager's parameters still arrive.
    """
    launch, controllers = launch_of(project, ROS_2), project.controllers
    if launch is None or controllers is None:
        return
    severity = None if set(project.distros) <= set(_LOSING) else Severity.INFO
    for spawn in launch.spawns:
        if not is_spawner(spawn) or not spawn.complete or spawn.files or _passes_parameters(spawn):
            continue
        for name, at in spawn.names:
            controller = controllers.controller(name.rpartition("/")[2])
            if controller is not None and _needs_file(controller):
                message = f"the spawner of controller '{name}' gets no --param-file with its parameters"
                notes = (Note("the parameters are here", controller.sections[0].at),)
                yield Finding(at, message, notes, severity=severity)


def _passes_parameters(spawn: Spawn) -> bool:
    return any(option.name in {"-p", "--param-file", "--controller-ros-args"} for option in spawn.options)


def _needs_file(controller: Controller) -> bool:
    """Return whether it has parameters in its own section, and the manager has no parameter file for it."""
    own = [parameter.name for parameter in controller.own if parameter.name != "type"]
    return bool(own and controller.sections and not controller.parameter_files)
