"""UC423."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.parameters.controller_types import TypedController, instead_of, typed
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule


@rule(
    "UC423",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros_controllers and ros2_controllers declare different types; ros2_control "
    "controller_manager/src/controller_manager.cpp: 'Loader for controller 'arm' (type "
    "'effort_controllers/JointPositionController') not found.'",
    options=["--distro=humble"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: «position_controllers/JointTrajectoryController»}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
            """
        },
    ],
)
def controller_type_of_other_ros(project: Project) -> Iterator[Finding]:
    """Controller type of the other ROS generation.

    ROS 2 cannot load controllers of ROS 1, nor ROS 1 those of ROS 2. Most types have a successor with another name.
    """
    for controller in typed(project):
        ros = controller.ros
        if not controller.known_in or any(generation(distro) == ros for distro in controller.known_in):
            continue
        replacement, advice = instead_of(project, controller.type, controller.distros[-1])
        advice = advice or _namesake(project, controller) or f"no ROS {ros} package provides a controller of this type"
        message = f"'{controller.type}' is a controller type of ROS {3 - ros}; {advice}"
        fix = Fix(f"write '{replacement.type}'") if replacement else None
        notes = (Note(replacement.note),) if replacement and replacement.note else ()
        yield Finding(controller.at.at, message, notes, fix)


def _namesake(project: Project, controller: TypedController) -> str:
    """The advice to use the only type with the same class in the other generation; empty if there is none."""
    known = project.catalog.known_types(controller.distros[-1])
    same = [name for name in known if name.rpartition("/")[2] == controller.type.rpartition("/")[2]]
    return f"use '{same[0]}' if that is meant" if len(same) == 1 else ""
