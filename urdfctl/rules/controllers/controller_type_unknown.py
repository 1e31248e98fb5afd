"""UC421."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.controller_types import (
    TypedController,
    is_surely_meant,
    meant_by,
    typed,
    types_beside,
)
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, replaced


@rule(
    "UC421",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'Loader for controller 'arm' (type "
    "'joint_trajectory_controler/JointTrajectoryController') not found.'; ros_control controller_manager.cpp: 'Could "
    "not load controller 'arm' because controller type '...' does not exist.'",
    options=["--distro=jazzy"],
    bad=[
        {
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
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: «transmission_interface/SimpleTransmission»}
            """
        },
        {
            "options": "--distro=noetic",
            "arm.launch": """
                <launch>
                  <rosparam command="load" file="$(find arm)/controllers.yaml"/>
                  <node name="spawner" pkg="controller_manager" type="spawner" args="wrist"/>
                </launch>
            """,
            "controllers.yaml": "wrist: {type: «position_controllers/JointForceController», joint: wrist}",
        },
    ],
    good=[
        {
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
    ],
)
def controller_type_unknown(project: Project) -> Iterator[Finding]:
    """Unknown controller type.

    The controller manager compares the whole string with the types that installed packages declare. Every letter
    counts, and the part before the slash must be the package for which the type is declared.
    """
    for controller in typed(project):
        if controller.known_in or not controller.type.strip():
            continue
        at = controller.at.at
        other = _other_kind(project, controller)
        if other is not None:
            yield Finding(at, f"'{controller.type}' is a {other} for <ros2_control>, not a controller type")
            continue
        meant = meant_by(project, controller)
        if meant is not None:
            message = f"controller type '{controller.type}' is unknown; did you mean '{meant}'?"
            yield Finding(
                at, message, fix=replaced(at, controller.type, meant, safe=is_surely_meant(project, controller, meant))
            )
        elif beside := types_beside(project, controller):
            package = controller.type.partition("/")[0]
            message = f"controller type '{controller.type}' does not exist; '{package}' has {in_words(beside, 4)}"
            yield Finding(at, message)


def _other_kind(project: Project, controller: TypedController) -> str | None:
    catalog = project.catalog
    if any(controller.type in catalog.known_hardware(distro) for distro in controller.distros):
        return "hardware plugin"
    is_gear = any(controller.type in catalog.known_transmissions(distro) for distro in controller.distros)
    return "transmission" if is_gear else None
