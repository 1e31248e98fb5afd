"""UC422."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation, in_words, since
from urdfctl.control.parameters.controller_types import TypedController, instead_of, typed
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule

_MAINTAINED = {*since("humble"), "noetic"}


@rule(
    "UC422",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_controllers and ros_controllers: the plugins that each distro's branches declare; ros2_control "
    "controller_manager/src/controller_manager.cpp: 'Loader for controller 'joint_states' (type "
    "'joint_state_controller/JointStateController') not found.'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: «joint_state_controller/JointStateController»}
            """
        },
        {
            "options": "",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: «joint_state_controller/JointStateController»}
            """,
        },
        {
            "options": "",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: «joint_state_controller/JointStateController»}
                    base: {type: mecanum_drive_controller/MecanumDriveController}
                base:
                  ros__parameters:
                    front_left_wheel_command_joint_name: fl
                    front_right_wheel_command_joint_name: fr
                    rear_left_wheel_command_joint_name: rl
                    rear_right_wheel_command_joint_name: rr
                    base_frame_id: base_link
                    kinematics:
                      base_frame_offset: {x: 0.0, y: 0.0, theta: 0.0}
                      wheels_radius: 0.1
                      sum_of_robot_center_projection_on_X_Y_axis: 0.4
            """,
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
        {
            "options": "",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    base: {type: mecanum_drive_controller/MecanumDriveController}
                base:
                  ros__parameters:
                    front_left_wheel_command_joint_name: fl
                    front_right_wheel_command_joint_name: fr
                    rear_left_wheel_command_joint_name: rl
                    rear_right_wheel_command_joint_name: rr
                    base_frame_id: base_link
                    kinematics:
                      base_frame_offset: {x: 0.0, y: 0.0, theta: 0.0}
                      wheels_radius: 0.1
                      sum_of_robot_center_projection_on_X_Y_axis: 0.4
            """,
        },
        {
            "options": "",
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                base:
                  type: four_wheel_steering_controller/FourWheelSteeringController
                  front_wheel: [fl, fr]
                  rear_wheel: [rl, rr]
                  front_steering: [fls, frs]
                  rear_steering: [rls, rrs]
                  pose_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
                  twist_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
            """,
        },
    ],
)
def controller_type_not_in_distro(project: Project) -> Iterator[Finding]:
    """Controller type does not exist in this ROS distro.

    It was removed from this distro, or was added later; the controller manager cannot load it. If the ROS distro is
    unknown, only types that no maintained distro has are reported.
    """
    for controller in typed(project):
        having = [distro for distro in controller.known_in if generation(distro) == controller.ros]
        absent = [distro for distro in controller.distros if distro not in having]
        if not having or not absent or _is_external(project, controller, having[-1]):
            continue
        if len(absent) == len(controller.distros) or set(absent) >= _MAINTAINED & set(controller.distros):
            yield _finding(project, controller, tuple(having), absent)


def _is_external(project: Project, controller: TypedController, distro: str) -> bool:
    """Whether a package outside ros_control and ros2_control has the type: it may be built for other distros too."""
    kind = project.catalog.controller(controller.type, distro)
    return kind is not None and kind.external


def _finding(project: Project, controller: TypedController, having: tuple[str, ...], absent: list[str]) -> Finding:
    where = absent[-1] if len(absent) == 1 else "any maintained distro"
    replacement, advice = instead_of(project, controller.type, absent[-1])
    message = f"controller type '{controller.type}' does not exist in {where}, only in {in_words(having)}"
    fix = Fix(f"write '{replacement.type}'") if replacement else None
    notes = (Note(replacement.note),) if replacement and replacement.note else ()
    severity = Severity.ERROR if len(absent) == len(controller.distros) else Severity.WARNING
    return Finding(controller.at.at, f"{message}; {advice}" if advice else message, notes, fix, severity)
