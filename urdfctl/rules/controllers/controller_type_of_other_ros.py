"""UC423."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.parameters.controller_types import TypedController, instead_of, may_be_installed, typed
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
        {
            "options": "--distro=noetic",
            "controllers.yaml": "base: {type: «mecanum_drive_controller/MecanumDriveController»}",
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
        *(
            {
                "options": "--distro=noetic",
                "arm.launch": """
                    <launch>
                      <rosparam command="load" file="$(find arm)/controllers.yaml"/>
                      <node name="spawner" pkg="controller_manager" type="spawner" args="base"/>
                    </launch>
                """,
                "controllers.yaml": "base: {type: mecanum_drive_controller/MecanumDriveController}",
                "package.xml": "<package><name>arm</name><depend>controller_manager</depend>"
                f"<exec_depend>{package}</exec_depend></package>",
            }
            for package in ("ridge_control", "mecanum_drive_controller", "ridge_hw", "ridge_hardware")
        ),
    ],
)
def controller_type_of_other_ros(project: Project) -> Iterator[Finding]:
    """Controller type of the other ROS generation.

    ROS 2 cannot load controllers of ROS 1, nor ROS 1 those of ROS 2. Most types have a successor with another name. Nothing
    is said of a type without one if package.xml names a package that urdfctl does not know and that may bring it.
    """
    for controller in typed(project):
        ros = controller.ros
        if not controller.known_in or any(generation(distro) == ros for distro in controller.known_in):
            continue
        replacement, advice = instead_of(project, controller.type, controller.distros[-1])
        advice = advice or _namesake(project, controller)
        if not advice and may_be_installed(project, controller.type):
            continue
        advice = advice or f"no package with a controller of this type for ROS {ros} is known to urdfctl"
        message = f"'{controller.type}' is a controller type of ROS {3 - ros}; {advice}"
        fix = Fix(f"write '{replacement.type}'") if replacement else None
        notes = (Note(replacement.note),) if replacement and replacement.note else ()
        yield Finding(controller.at.at, message, notes, fix)


def _namesake(project: Project, controller: TypedController) -> str:
    """The advice to use the only type with the same class in the other generation; empty if there is none."""
    known = project.catalog.known_types(controller.distros[-1])
    same = [name for name in known if name.rpartition("/")[2] == controller.type.rpartition("/")[2]]
    return f"use '{same[0]}' if that is meant" if len(same) == 1 else ""
