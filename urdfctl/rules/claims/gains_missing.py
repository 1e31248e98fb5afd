"""UC464."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.parameters.gains import Fate, MissingGain, missing_gains
from urdfctl.control.parameters.readers import Reader, controllers_in, in_each_distro
from urdfctl.model.controllers import Controller
from urdfctl.rule import Finding, Fix, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home
from urdfctl.rules.common import in_words
from urdfctl.source.span import Place

_SEVERITIES = {Fate.REFUSED: Severity.ERROR, Fate.CRASH: Severity.ERROR, Fate.IDLE: Severity.WARNING}


@rule(
    "UC464",
    runtime="crashes",
    stage=StageDependsOn.GAINS,
    severity=Severity.ERROR,
    authority="control_toolbox src/pid.cpp: 'No p gain specified for pid.  Namespace: /arm/pid'; in ROS 2 a missing "
    "gain is 0.0 (ros2_controllers, *_parameters.yaml)",
    options=["--distro=noetic"],
    bad=[
        {
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: «effort_controllers/JointPositionController»
                  joint: elbow
            """
        },
        {
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: effort_controllers/JointTrajectoryController
                  joints: [shoulder, elbow]
                  gains:
                    shoulder: {p: 100.0, i: 0.0, d: 1.0}
                    «elbow»: {i: 0.0}
            """,
        },
        {
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: «velocity_controllers/JointTrajectoryController»
                  joints: [shoulder, elbow]
            """,
        },
        {
            "options": "--distro=jazzy",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: «joint_trajectory_controller/JointTrajectoryController»}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [effort]
                    state_interfaces: [position, velocity]
            """,
        },
    ],
    good=[
        {
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: effort_controllers/JointPositionController
                  joint: elbow
                  pid: {p: 100.0, i: 0.0, d: 1.0}
            """
        },
    ],
)
def gains_missing(project: Project) -> Iterator[Finding]:
    """Closed-loop controller without gains.

    A controller that writes efforts to reach a position, or velocities to follow a trajectory, multiplies the error by
    its gains. In ROS 1 most such controllers are not loaded without a gain `p` for each joint. JointTrajectoryController
    of effort_controllers and velocity_controllers crashes when it is started. In ROS 2 a missing gain is 0: the
    controller becomes active, but the joint does not move. (Gazebo's similar message about
    /gazebo_ros_control/pid_gains is harmless.)
    """
    if controllers_in(project).complete:
        yield from in_each_distro(project, _ungained)


def _ungained(reader: Reader) -> Iterator[Finding]:
    kind, controller = reader.type, reader.controller
    if kind is None or controller is None or controller.parameter_files or not controller.sections:
        return
    by_fate: dict[Fate, list[MissingGain]] = {}
    for gain in missing_gains(kind, reader.given):
        by_fate.setdefault(gain.fate, []).append(gain)
    for fate, missing in by_fate.items():
        at = _place(controller, missing[0])
        if at is not None:
            fix = Fix(
                f"add {_example(missing[0])}; urdfctl gen-controllers computes values from the masses of the robot"
            )
            yield Finding(at, _message(reader, missing), fix=fix, severity=_SEVERITIES[fate])


def _message(reader: Reader, missing: list[MissingGain]) -> str:
    if generation(reader.distro) != 1:
        joints = in_words([gain.element or "" for gain in missing])
        return f"controller '{reader.name}' has only zero gains for {joints}; it becomes active but does not move"
    names = in_words([gain.name for gain in missing])
    gains = "gain" if len(missing) == 1 else "gains"
    return f"controller '{reader.name}' has no {gains} {names}; it {missing[0].fate.value}"


def _place(controller: Controller, gain: MissingGain) -> Place | None:
    """The innermost existing map around the gain, or else the controller's type."""
    name = gain.name
    while "." in name:
        name = name.rpartition(".")[0]
        parent = controller.parameters.get(name)
        if parent is not None:
            return parent.key
    return home(controller)


def _example(gain: MissingGain) -> str:
    """The missing gains as they are written: `gains: {elbow: {p: P, i: I, d: D}}`."""
    text = "{p: P, i: I, d: D}"
    parent = gain.name.rpartition(".")[0]
    if gain.element and gain.element in parent:
        before, after = parent.split(gain.element, 1)
        parts = [*before.strip(".").split("."), gain.element, *after.strip(".").split(".")]
    else:
        parts = parent.split(".")
    for part in reversed([part for part in parts if part]):
        text = f"{{{part}: {text}}}"
    return text[1:-1]
