"""UC430."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.map_parameters import matching
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.model.controllers import Parameter
from urdfctl.rule import Finding, Fix, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.parameters import (
    is_another,
    is_ros1,
    missing,
    namesakes,
    number_slips,
    of_other_ros,
    slips,
    unread,
)

_GROUP = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: position_controllers/JointGroupPositionController}
    arm:
      ros__parameters: {joints: [elbow], %s}
"""


@rule(
    "UC430",
    stage=StageDependsOn.PARAMETER_CHECKS,
    severity=Severity.WARNING,
    runtime="ignores",
    authority="generate_parameter_library and rclcpp: a value for a parameter that no node declares is ignored; "
    "ros_control's controllers ask the parameter server for the names they know",
    options=["--distro=jazzy"],
    bad=[
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
                    «allow_partial_joint_goal»: true
            """
        },
        {
            "options": "--distro=noetic",
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: position_controllers/JointTrajectoryController
                  joints: [shoulder, elbow]
                  «stop_trajectory_durations»: 0.5
                  «goal_time»: 0.5
            """,
        },
        {
            "options": "--distro=noetic",
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                base:
                  type: diff_drive_controller/DiffDriveController
                  left_wheel: shoulder
                  right_wheel: elbow
                  wheel_separation: 0.4
                  wheel_radius: 0.1
                  pose_covariance_diagonal: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]
                  twist_covariance_diagonal: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]
                  angular: {«x»: {has_velocity_limits: true, max_velocity: 1.0}}
            """,
        },
        {
            "options": "--distro=noetic",
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: position_controllers/JointTrajectoryController
                  joints: [shoulder, elbow]
                  «constraints»: 0.1
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    base: {type: diff_drive_controller/DiffDriveController}
                base:
                  ros__parameters:
                    left_wheel_names: [left]
                    right_wheel_names: [right]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
                    «max_velocity»: 0.5
                    «left_wheel»: left
                    «zzz»: 1
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    ros__parameters: {joints: [elbow]}
                    joints: [shoulder, elbow]
                    «interface_nam»: position
            """,
        },
        {"options": "--distro=humble", "controllers.yaml": _GROUP % "«interface_name»: velocity"},
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
                    allow_partial_joints_goal: true
            """
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
                    qos_overrides: {/joint_states: {publisher: {depth: 5}}}
                    start_type_description_service: false
                    diagnostic_updater: {period: 2.0}
                    enable_logger_service: true
            """,
        },
        {
            "options": "--distro=noetic",
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: position_controllers/JointTrajectoryController
                  joints: [shoulder, elbow]
                  colour: red
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    type: forward_command_controller/ForwardCommandController
                    params_file: /opt/arm/arm.yaml
                    fallback_controllers: [states]
                    node_options_args: [--ros-args]
                    joints: [shoulder, elbow]
                    interface_name: position
            """,
        },
        {"options": "--distro=humble", "controllers.yaml": _GROUP % "interface_name: position"},
    ],
)
def parameter_unknown(project: Project) -> Iterator[Finding]:
    """Unknown parameter.

    The node ignores it silently and uses the default; most unknown parameters are misspelt. In ROS 1, other nodes may
    read them, so only names similar to a known parameter are reported, and all in a map that the controller reads. It is
    an error if the parameter that was meant is required.
    """
    return in_each_distro(project, lambda reader: _unknown(project, reader), newest=True)


def _unknown(project: Project, reader: Reader) -> Iterator[Finding]:
    meant = slips(reader)
    needed = {lack.name for lack in missing(reader) if lack.refused}
    for parameter in unread(reader):
        right = meant.get(parameter.name)
        of_other_distro = matching(parameter.name, reader.former) is not None  # UC436 reports it
        is_number_slip = right in number_slips(reader, parameter.name)  # UC444 reports it
        why = None if of_other_distro or is_number_slip else _why(project, reader, parameter, right)
        if why is not None:
            message = f"'{reader.name}' has no parameter '{parameter.name}'{why}"
            severity = Severity.ERROR if right in needed else Severity.WARNING
            yield Finding(parameter.key, message, fix=_fix(parameter, right), severity=severity)


def _why(project: Project, reader: Reader, parameter: Parameter, right: str | None) -> str | None:
    """The end of the message on a parameter that is not read; None if it may be for another node."""
    if right:
        return f"; did you mean '{right}'?"
    instead = reader.type.replacement if reader.type else None
    if instead is not None and instead.parameters.get(parameter.name) == parameter.value.value:
        return None  # the type says so by itself, as velocity_controllers/... does interface_name
    other = of_other_ros(project, reader, parameter.name)
    if other:
        return f", which exists only in ROS {other}; it is ignored"
    alike = namesakes(reader, parameter)
    if alike and not (reader.type and reader.type.open):
        return f"; did you mean {' or '.join(repr(name) for name in alike[:2])}?"
    is_open = reader.type is not None and reader.type.open
    is_map = any(name.startswith(f"{parameter.name}.") for name in reader.known)
    may_be_of_others = is_ros1(reader) and "." not in parameter.name and not is_map
    return None if is_open or may_be_of_others or is_another(reader) else "; it is ignored"


def _fix(parameter: Parameter, right: str | None) -> Fix | None:
    if right is None:
        return None
    before, _, last = right.rpartition(".")
    same = before == parameter.name.rpartition(".")[0]
    return replaced(parameter.key, parameter.last, last) if same else Fix(f"write '{right}'")
