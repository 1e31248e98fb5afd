"""UC481."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.file_names import file_renamed, meant_file
from urdfctl.rules.launch_samples import ARM, BROADCASTER, CONTROLLERS, FILE, MANAGER, PUBLISHER, launched

_TYPE = "type: joint_trajectory_controller/JointTrajectoryController"
_NAMED = CONTROLLERS.replace(_TYPE, f"{_TYPE}\n          params_file: %s", 1)
_ALONE = ARM.replace(f" {FILE}", "")


@rule(
    "UC481",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("humble"),
    options=["--distro=jazzy"],
    authority="ros2_control controller_manager.cpp load_controller() gives the files of <controller>.params_file to the controller's "
    "node; rcl: 'Couldn't parse params file: '--params-file arm.yaml'. Error: Error opening YAML file' (measured in jazzy)",
    bad=[launched(PUBLISHER, MANAGER, BROADCASTER, _ALONE, controllers=_NAMED % "«arm.yaml»")],
    good=[
        launched(PUBLISHER, MANAGER, BROADCASTER, _ALONE, controllers=_NAMED % "controllers.yaml"),
        launched(PUBLISHER, MANAGER, BROADCASTER, ARM, controllers=_NAMED % "arm.yaml"),
    ],
)
def parameters_file_missing(project: Project) -> Iterator[Finding]:
    """Parameter file of a controller does not exist.

    The controller manager passes the file to the controller's node, which cannot be made: the controller is not loaded.
    A relative path starts in the folder that the manager is started in. A spawner with `--param-file` replaces the file.
    """
    launch, controllers = project.launch, project.controllers
    given = {name for spawn in (launch.spawns if launch else ()) for name, _ in spawn.names if spawn.files}
    for name, file in controllers.absent if controllers else ():
        if name not in given:
            message = f"'params_file' of controller '{name}' does not exist: '{file.text}'{meant_file(file)}"
            yield Finding(file.at, message, fix=file_renamed(file))
