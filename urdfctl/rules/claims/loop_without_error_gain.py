"""UC479."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.parameters.gains import GainLoop, loops_of
from urdfctl.control.parameters.readers import Reader, controllers_in, in_each_distro
from urdfctl.rule import Finding, Fix, Project, Severity, rule

_ROS1 = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    arm:
      type: effort_controllers/JointPositionController
      joint: elbow
      pid: {%s}
"""
_ROS2 = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: joint_trajectory_controller/JointTrajectoryController}
    arm:
      ros__parameters:
        joints: [elbow]
        command_interfaces: [%s]
        state_interfaces: [position, velocity]
        gains:
          elbow: {%s}
"""


@rule(
    "UC479",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="control_toolbox src/pid.cpp computeCommand(): the command is p e + i ∫e + d de/dt; with p of 0, and i of 0 or "
    "clamped to 0, no error commands anything",
    options=["--distro=noetic"],
    bad=[
        {"controllers.yaml": _ROS1 % "«p»: 0.0, i: 0.0, d: 1.0"},
        {"controllers.yaml": _ROS1 % "«p»: 0.0, i: 0.0, d: 0.0"},
        {"controllers.yaml": _ROS1 % "«p»: 0.0, i: 5.0"},
        {"options": "--distro=jazzy", "controllers.yaml": _ROS2 % ("effort", "«p»: 0.0, d: 5.0")},
        {"options": "--distro=jazzy", "controllers.yaml": _ROS2 % ("effort", "«d»: 5.0")},
        {"options": "--distro=jazzy", "controllers.yaml": _ROS2 % ("effort", "«p»: 0.0, i: 5.0")},
        {"controllers.yaml": _ROS1 % "«p»: 0.0, i: 5.0, i_clamp: 10.0"},
    ],
    good=[
        {"controllers.yaml": _ROS1 % "p: 10.0"},
        {
            "controllers.yaml": (_ROS1 % "p: 0.0, i: 5.0, i_clamp: 10.0").replace(
                "JointPositionController", "JointVelocityController"
            )
        },
        {"options": "--distro=jazzy", "controllers.yaml": _ROS2 % ("effort", "p: 10.0, d: 5.0")},
        {"options": "--distro=jazzy", "controllers.yaml": _ROS2 % ("position", "p: 0.0, d: 5.0")},
        {"options": "--distro=jazzy", "controllers.yaml": _ROS2 % ("velocity", "p: 0.0, ff_velocity_scale: 1.0")},
    ],
)
def loop_without_error_gain(project: Project) -> Iterator[Finding]:
    """Closed loop whose gains do not act on the error.

    The gain d alone only damps. The gain i acts only within its clamp, and without p an effort that follows it never
    comes to rest. Without p, such a controller becomes active, but
    its joint never reaches a goal, and sags under load.
    """
    if controllers_in(project).complete:
        yield from in_each_distro(project, _without_error)


def _without_error(reader: Reader) -> Iterator[Finding]:
    if reader.type is None or reader.controller is None or not _is_closed(reader):
        return
    for loop in loops_of(reader.type, reader.given):
        swings = bool(loop.integral) and _pushes_to_positions(reader)
        if loop.p or (loop.integral and not swings) or loop.forward or not _is_mine(reader, loop):
            continue
        given = next((each for gain in "pid" if (each := reader.located.get(loop.prefix + gain)) is not None), None)
        if given is not None:
            of = f" of '{loop.element}'" if loop.element else ""
            message = f"gain p{of} is 0 and {_why(loop, swings=swings)}: controller '{reader.name}' does not bring its joint to a goal"
            fix = Fix("give a gain p above 0, and tune it")
            yield Finding(given.key, message, fix=fix, severity=Severity.WARNING)


def _why(loop: GainLoop, *, swings: bool) -> str:
    if swings:
        return "with i alone the joint swings"
    if loop.i:
        return "i is clamped to 0"
    return "d alone only damps" if loop.d else "i and d are 0"


def _pushes_to_positions(reader: Reader) -> bool:
    """Whether a controller commands efforts by the error of positions: with i and without p, that is never stable."""
    kind = reader.type.type if reader.type else ""
    is_of_effort = kind.startswith("effort_controllers/") or reader.given.get("command_interfaces") == ["effort"]
    return is_of_effort and "Velocity" not in kind


def _is_mine(reader: Reader, loop: GainLoop) -> bool:
    """Whether not all is 0 in ROS 2, which another rule reports."""
    return generation(reader.distro) == 1 or bool(loop.i or loop.d)


def _is_closed(reader: Reader) -> bool:
    """Whether the controller runs its loops: a trajectory controller does not if it writes positions or is open."""
    interfaces = reader.given.get("command_interfaces")
    is_open = bool(reader.given.get("open_loop_control")) and "open_loop_control" in reader.known
    return not is_open and not (isinstance(interfaces, list) and "position" in interfaces)
