"""UC430."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.map_parameters import matching
from urdfctl.model.parameters import Parameter
from urdfctl.rule import Finding, Fix, Project, Severity, rule
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
from urdfctl.rules.controllers.readers import Reader, in_each_distro


@rule(
    "UC430",
    severity=Severity.WARNING,
    authority="generate_parameter_library and rclcpp: a value for a parameter that no node declares is ignored; "
    "ros_control's controllers ask the parameter server for the names they know",
    options=["--distro=jazzy"],
    bad={
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
                allow_partial_joints_goal: true
        """
    },
)
def parameter_unknown(project: Project) -> Iterator[Finding]:
    """A parameter is none that its node reads, most often a misspelt one.

    Nobody tells: the value is ignored and the default used. Of ROS 1's controllers only those are told that are much
    like one that is read, for others may read what stands beside. It is an error where the one that is meant is needed.
    """
    return in_each_distro(project, lambda reader: _unknown(project, reader), newest=True)


def _unknown(project: Project, reader: Reader) -> Iterator[Finding]:
    meant = slips(reader)
    needed = {lack.name for lack in missing(reader) if lack.refused}
    for parameter in unread(reader):
        right = meant.get(parameter.name)
        told = matching(parameter.name, reader.former) is not None or right in number_slips(reader, parameter.name)
        why = None if told else _why(project, reader, parameter, right)
        if why is not None:
            message = f"'{reader.name}' reads no '{parameter.name}'{why}"
            severity = Severity.ERROR if right in needed else Severity.WARNING
            yield Finding(parameter.key, message, fix=_fix(parameter, right), severity=severity)


def _why(project: Project, reader: Reader, parameter: Parameter, right: str | None) -> str | None:
    """What to say of a parameter that is not read; None where it may be meant for somebody else."""
    if right:
        return f"; did you mean '{right}'?"
    other = of_other_ros(project, reader, parameter.name)
    if other:
        return f", which is one of ROS {other} and is ignored"
    alike = namesakes(reader, parameter)
    if alike:
        return f"; did you mean {' or '.join(repr(name) for name in alike[:2])}?"
    return None if is_ros1(reader) or is_another(reader) else ", which is ignored"


def _fix(parameter: Parameter, right: str | None) -> Fix | None:
    if right is None:
        return None
    before, _, last = right.rpartition(".")
    same = before == parameter.name.rpartition(".")[0]
    return replaced(parameter.key, parameter.last, last) if same else Fix(f"write '{right}'")
