"""UC421."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.types import Typed, meant_by, typed


@rule(
    "UC421",
    severity=Severity.ERROR,
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'Loader for controller 'arm' (type "
    "'joint_trajectory_controler/JointTrajectoryController') not found.'; ros_control controller_manager.cpp: 'Could "
    "not load controller 'arm' because controller type '...' does not exist.'",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm: {type: «forward_command_controllers/ForwardCommandController»}
            arm:
              ros__parameters:
                joints: [shoulder, elbow]
                interface_name: position
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm: {type: forward_command_controller/ForwardCommandController}
            arm:
              ros__parameters:
                joints: [shoulder, elbow]
                interface_name: position
        """
    },
)
def controller_type_unknown(project: Project) -> Iterator[Finding]:
    """A controller's type is a misspelt one.

    The controller manager compares the whole text with the types that the installed packages declare, so that each
    letter counts, and the package before the slash is the one that the types were declared for.
    """
    for one in typed(project):
        if one.known_in or not one.type.strip():
            continue
        distros = _hardware_in(project, one)
        if distros:
            message = f"'{one.type}' is a hardware plugin of <ros2_control>, and no controller"
            yield Finding(one.at.at, message)
            continue
        meant = meant_by(project, one)
        if meant is not None:
            message = f"unknown type of controller '{one.type}'; did you mean '{meant}'?"
            yield Finding(one.at.at, message, fix=replaced(one.at.at, one.type, meant))


def _hardware_in(project: Project, one: Typed) -> bool:
    return any(one.type in project.catalog.known_hardware(distro) for distro in one.distros)
