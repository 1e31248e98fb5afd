"""UC423."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.controllers.types import instead_of, typed


@rule(
    "UC423",
    severity=Severity.ERROR,
    authority="ros_controllers and ros2_controllers declare different types; ros2_control "
    "controller_manager/src/controller_manager.cpp: 'Loader for controller 'arm' (type "
    "'effort_controllers/JointPositionController') not found.'",
    options=["--distro=humble"],
    bad={
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
    good={
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
)
def controller_type_of_other_ros(project: Project) -> Iterator[Finding]:
    """A type of controller is one of the other generation of ROS.

    Controllers of ROS 1 cannot be loaded by ROS 2, and the other way round; most have a successor under another name.
    """
    for one in typed(project):
        if not one.known_in or any(generation(distro) == one.ros for distro in one.known_in):
            continue
        found, words = instead_of(project, one.type, one.distros[-1])
        message = (
            f"'{one.type}' is a type of ROS {3 - one.ros}; {words or f'there is none of this name in ROS {one.ros}'}"
        )
        fix = Fix(f"write '{found.type}'") if found else None
        yield Finding(one.at.at, message, (Note(found.note),) if found and found.note else (), fix)
