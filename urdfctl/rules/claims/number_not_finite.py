"""UC480."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.catalog.values import elements
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.rule import Finding, Project, Severity, rule

_BOUNDS = ("max", "clamp", "tolerance", "timeout", "goal", "trajectory", "threshold")
"""Parts of names of parameters in which infinity means that there is no bound."""
_BASE = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        base: {type: diff_drive_controller/DiffDriveController}
    base:
      ros__parameters:
        left_wheel_names: [shoulder]
        right_wheel_names: [elbow]
        wheel_separation: %s
        wheel_radius: 0.1
        linear.x.max_velocity: %s
"""
_TRAJECTORIES = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        arm: {type: joint_trajectory_controller/JointTrajectoryController}
        hand: {type: parallel_gripper_action_controller/GripperActionController}
    arm:
      ros__parameters:
        joints: [shoulder]
        command_interfaces: [effort]
        state_interfaces: [position, velocity]
        gains: {shoulder: {p: 1.0, i: 0.1, i_clamp_min: -.inf, i_clamp_max: .inf}}
        constraints: {stopped_velocity_tolerance: .inf, shoulder: {trajectory: .inf, goal: .inf}}
    hand:
      ros__parameters: {joint: elbow, stall_velocity_threshold: .inf, max_effort: .inf}
"""
_ARM = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    arm:
      type: effort_controllers/JointPositionController
      joint: elbow
      pid: {p: %s, d: 1.0}
"""


@rule(
    "UC480",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="yaml-cpp and PyYAML read .inf and .nan as numbers; rclcpp, roscpp and the controllers compute with them",
    options=["--distro=jazzy"],
    bad=[
        {"controllers.yaml": _BASE % ("«.inf»", "1.0")},
        {"options": "--distro=noetic", "controllers.yaml": _ARM % "«.inf»"},
        {"options": "--distro=noetic", "controllers.yaml": _ARM % "«1.0e+999»"},
    ],
    good=[
        {"controllers.yaml": _BASE % ("0.4", ".nan")},
        {"controllers.yaml": _BASE % ("0.4", ".inf")},
        {
            "controllers.yaml": _BASE
            % ("0.4", "1.0\n        linear.x.min_velocity: -.inf\n        cmd_vel_timeout: .inf")
        },
        {"controllers.yaml": _TRAJECTORIES},
        {"options": "--distro=noetic", "controllers.yaml": _ARM % "1.0e+9"},
        {"options": "--distro=noetic", "controllers.yaml": _ARM % "1.0, i: 0.1, i_clamp: .inf"},
    ],
)
def number_not_finite(project: Project) -> Iterator[Finding]:
    """Number of a controller that is infinite or not a number.

    YAML accepts `.inf` and `.nan`, and reads a number that is too large as infinite. The controller computes with it:
    its commands are 0, infinite or not a number. It is sound only where it means that there is no limit.
    """
    return in_each_distro(project, _not_finite)


def _not_finite(reader: Reader) -> Iterator[Finding]:
    for given in reader.located:
        matched = matching(given.name, reader.known)
        if matched is None or not _odd(reader.given.get(given.name)):
            continue
        parameter, value = reader.known[matched[0]], reader.given[given.name]
        checks = {**parameter.validators, **parameter.useful}
        is_refused = type_problem(value, parameter, reader.distro) or problem(value, checks)
        if not is_refused and not _is_bound(given.name, parameter):
            what = "is not a number" if any(map(math.isnan, _odd(value))) else "is infinite"
            message = f"'{given.name}' {what}; the controller computes with it. Give a finite number"
            yield Finding(given.value.at, message, severity=Severity.WARNING)


def _odd(value: object) -> list[float]:
    """The numbers of a value that are not finite."""
    parts = elements(value) if isinstance(value, list | tuple) else (value,)
    return [part for part in parts if isinstance(part, float) and not math.isfinite(part)]


def _is_bound(name: str, parameter: ParameterEntry) -> bool:
    """Whether a parameter is a bound, which may be infinite: by its name, its default or its validators."""
    last = name.rpartition(".")[2].split("_")
    checks: Mapping[str, object] = {**parameter.validators, **parameter.useful}
    return (
        bool(_odd(parameter.default))
        or any(check.endswith("_or_nan") for check in checks)
        or any(part in _BOUNDS for part in (*last, name.rpartition(".")[2]))
    )
