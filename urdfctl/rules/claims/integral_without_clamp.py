"""UC478."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.gains import GainLoop, loops_of
from urdfctl.control.parameters.readers import Reader, controllers_in, in_each_distro
from urdfctl.rule import Finding, Project, Severity, rule

_NOTICEABLE = 0.01
"""From this share of the gain p on, what the integral part would add in a second is noticed."""
_CONTROLLERS = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    arm:
      type: effort_controllers/JointPositionController
      joint: elbow
      pid: {%s}
"""


@rule(
    "UC478",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="control_toolbox (..noetic, ..iron) src/pid.cpp computeCommand(): 'i_term' is limited to i_min and i_max, and both "
    "are 0 without i_clamp, i_clamp_min and i_clamp_max",
    options=["--distro=noetic"],
    bad=[
        {"controllers.yaml": _CONTROLLERS % "p: 100.0, «i»: 5.0, d: 1.0"},
        {"controllers.yaml": _CONTROLLERS % "p: 100.0, «i»: 5.0, d: 1.0, i_clamp: 0.0"},
        {
            "options": "--distro=humble",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [elbow]
                    command_interfaces: [effort]
                    state_interfaces: [position, velocity]
                    gains:
                      elbow: {p: 100.0, «i»: 5.0, d: 1.0}
            """,
        },
    ],
    good=[
        {"controllers.yaml": _CONTROLLERS % "p: 100.0, i: 5.0, d: 1.0, i_clamp: 2.0"},
        {"controllers.yaml": _CONTROLLERS % "p: 100.0, i: 5.0, i_clamp_min: -2.0, i_clamp_max: 2.0"},
        {"controllers.yaml": _CONTROLLERS % "p: 100.0, i: 0.0, d: 1.0"},
    ],
)
def integral_without_clamp(project: Project) -> Iterator[Finding]:
    """Integral gain without a clamp, which has no effect.

    Up to noetic and iron, the integral part of a PID is limited by `i_clamp`, which is 0 by default. Without it the gain
    i adds nothing: what gravity or friction takes is not made up for. From jazzy on there is no limit by default. If
    i is tiny beside p, this is only worth knowing.
    """
    if controllers_in(project).complete:
        yield from in_each_distro(project, _unclamped)


def _unclamped(reader: Reader) -> Iterator[Finding]:
    if reader.type is None or reader.controller is None:
        return
    for loop in loops_of(reader.type, reader.given):
        given = reader.located.get(f"{loop.prefix}i")
        if given is not None and loop.i > 0 and not loop.clamp:
            message = f"'{given.name}' has no effect: i_clamp is 0; give i_clamp, or remove i"
            yield Finding(given.key, message, severity=_severity(loop))


def _severity(loop: GainLoop) -> Severity:
    return Severity.WARNING if loop.i >= _NOTICEABLE * loop.p else Severity.INFO
