"""UC435."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.parameters import known_as, replacement_of


@rule(
    "UC435",
    severity=Severity.WARNING,
    runtime="works",
    because="later distros ignore it",
    authority="ros2_controllers and ros_controllers: parameters that their sources and migration notes call deprecated",
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
                    «open_loop_control»: true
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
                    interpolate_from_desired_state: true
            """
        },
    ],
)
def parameter_deprecated(project: Project) -> Iterator[Finding]:
    """Deprecated parameter.

    This distro still reads the parameter. Later distros ignore it silently, and the controller uses the default.
    """
    return in_each_distro(project, _deprecated, newest=True)


def _deprecated(reader: Reader) -> Iterator[Finding]:
    for leaf in reader.located.leaves:
        matched = known_as(reader, leaf.name)
        parameter = reader.known[matched[0]] if matched else None
        if parameter is not None and parameter.deprecated:
            instead = replacement_of(reader, parameter)
            replacement = f"; replacement: {instead}" if instead else ""
            why = f": {parameter.note}" if parameter.note and not replacement else ""
            message = f"parameter '{leaf.name}' is deprecated{replacement}{why}"
            yield Finding(leaf.key, message, severity=Severity.WARNING)
