"""UC431."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.control.parameters.readers import Reader, controllers_in, in_each_distro
from urdfctl.model.controllers import Controller, Controllers, FaultKind
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.controllers.parameters import MissingParameter, is_another, missing, slips
from urdfctl.rules.controllers.sections import meant_for

_LOSES_PARAMETERS = (FaultKind.OUTSIDE_PARAMETERS, FaultKind.NODE_NAME, FaultKind.PARAMETERS_NOT_A_MAP, FaultKind.ROOT)
"""Faults of a file that keep parameters from their nodes; other rules report them."""


@rule(
    "UC431",
    stage=StageDependsOn.PARAMETER_CHECKS,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="generate_parameter_library: 'parameter 'joints' is not initialized', 'Parameter 'joints' cannot be "
    "empty'; ros_controllers: 'No joint given', 'Could not find 'joints' parameter'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                «arm»:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
            """
        },
        {
            "options": "--distro=noetic",
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                «base»:
                  type: diff_drive_controller/DiffDriveController
                  left_wheel: left
                  right_wheel: right
                  pose_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
                  twist_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
                  linear: {x: {has_velocity_limits: true}}
            """,
        },
        {
            "options": "--distro=rolling",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    battery: {type: battery_state_broadcaster/BatteryStateBroadcaster}
                «battery»:
                  ros__parameters:
                    use_sim_time: false
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    base: {type: ackermann_steering_controller/AckermannSteeringController}
                «base»:
                  ros__parameters:
                    wheelbase: 0.6
                    traction_track_width: 0.4
                    traction_wheels_radius: 0.1
                    steering_track_width: 0.4
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    «arm»: {type: joint_trajectory_controller/JointTrajectoryController}
                    hand: {type: forward_command_controller/ForwardCommandController}
                hand:
                  ros__parameters:
                    joints: [finger]
                    interface_name: position
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                    hand: {type: forward_command_controller/ForwardCommandController}
                «hand»:
                  ros__parameters:
                    joints: [finger]
                arm:
                  joints: [shoulder]
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                    hand: {type: forward_command_controller/ForwardCommandController}
                «hand»:
                  ros__parameters:
                    joints: [finger]
                arm left:
                  ros__parameters:
                    joints: [shoulder]
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                    hand: {type: forward_command_controller/ForwardCommandController}
                «hand»:
                  ros__parameters:
                    joints: [finger]
                arm:
                  ros__parameters: [shoulder]
            """,
        },
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                    hand: {type: forward_command_controller/ForwardCommandController}
                «hand»:
                  ros__parameters:
                    joints: [finger]
                ---
                - arm
            """,
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
                    state_interfaces: [position, velocity]
            """
        },
    ],
)
def parameter_missing(project: Project) -> Iterator[Finding]:
    """Required parameter is missing.

    The controller manager cannot load or configure the controller. A default that the controller's own checks refuse
    does not count: an empty list of joints, a wheel radius of 0.
    """
    controllers = controllers_in(project)
    if not controllers.complete:
        return
    yield from in_each_distro(project, lambda reader: _incomplete(project, reader), newest=True)


def _incomplete(project: Project, reader: Reader) -> Iterator[Finding]:
    controllers, controller = controllers_in(project), reader.controller
    if controller is None and not reader.controllers and reader.name in project.own.nodes:
        yield from _incomplete_node(reader)
    if controller is None or reader.at is None or _is_reported_elsewhere(controllers, controller):
        return
    meant = slips(reader).values()
    lacks = [lack for lack in missing(reader) if lack.name not in controller.under_manager and lack.name not in meant]
    if not lacks:
        return
    kind = reader.type.type if reader.type else ""
    severity = Severity.ERROR if any(lack.refused for lack in lacks) and not is_another(reader) else Severity.WARNING
    if not controller.sections:
        if not (project.robot or any(other.sections for other in controllers.controllers)):
            return  # its section is in a file that is not linted
        message = f"section '{controller.name}:' is missing; controller type '{kind}' requires {_names(lacks)}"
    else:
        why = (
            f", which type '{kind}' requires"
            if any(lack.refused for lack in lacks)
            else "; parameters that need it are ignored"
        )
        message = f"controller '{controller.name}' is missing {_names(lacks)}{why}"
    yield Finding(reader.at, message, severity=severity)


def _incomplete_node(reader: Reader) -> Iterator[Finding]:
    """The finding on a node whose parameters the user defines."""
    meant = slips(reader).values()
    lacks = [lack for lack in missing(reader) if lack.name not in meant]
    if lacks and reader.at is not None:
        message = f"node '{reader.name}' is missing {_names(lacks)}, which its definition requires"
        yield Finding(reader.at, message, severity=Severity.ERROR)


def _names(lacks: list[MissingParameter]) -> str:
    [first, *others] = lacks
    if not others and first.words.startswith("or "):
        return f"'{first.name}' {first.words.removesuffix(' is required')}"
    return in_words([lack.name for lack in lacks])


def _is_reported_elsewhere(controllers: Controllers, controller: Controller) -> bool:
    """Whether the controller reads a file of its own, or loses its parameters by a fault that another rule reports."""
    if controller.parameter_files or meant_for(controllers, controller) or _is_template(controller):
        return True
    return not controller.sections and any(fault.kind in _LOSES_PARAMETERS for fault in controllers.faults)


def _is_template(controller: Controller) -> bool:
    """Whether other sections reuse the contents of this one through a YAML anchor: `d: &d {type: ...}`."""
    at = controller.declared_at
    return at is not None and re.match(rb"[ \t]*:\s*&", at.source.data[at.span.end : at.span.end + 80]) is not None
