"""UC436."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ALL, in_words
from urdfctl.catalog.entries import FormerParameter
from urdfctl.catalog.map_parameters import matching
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.parameters import known_as, replacement_of


@rule(
    "UC436",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="ros2_controllers and ros_controllers: the parameters that each distro's branches declare",
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
                    «state_publish_rate»: 50.0
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
            """
        },
    ],
)
def parameter_of_other_distro(project: Project) -> Iterator[Finding]:
    """Parameter of another ROS distro.

    The parameter was removed or renamed in this distro, or added later. The controller ignores it silently and uses the
    default. If the distro is unknown and most of the maintained ones read the parameter, it is only worth knowing.
    """
    return in_each_distro(project, _of_others, newest=True)


def _of_others(reader: Reader) -> Iterator[Finding]:
    for leaf in reader.own.leaves:
        matched = None if known_as(reader, leaf.name) else matching(leaf.name, reader.former)
        if matched is not None:
            former = reader.former[matched[0]]
            why = _why(former._replace(replacement=replacement_of(reader, former)), reader.distro)
            message = f"controller '{reader.name}' does not read '{leaf.name}'{why}"
            yield Finding(leaf.key, message, severity=Severity.WARNING)


def _why(former: FormerParameter, distro: str) -> str:
    advice = f": {former.note}" if former.note else ""
    if former.replacement:
        advice = f"; replacement: {former.replacement}"
    if former.last_version:
        return f" since {distro} {former.last_version}{advice}"
    if former.distros and ALL.index(former.distros[0]) > ALL.index(distro):
        return f" in {distro}, only in {former.distros[0]} and later{advice}"
    return f" in {distro}" + (f", only in {in_words(former.distros)}" if former.distros else "") + advice
