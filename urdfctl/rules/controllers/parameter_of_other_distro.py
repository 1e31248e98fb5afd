"""UC436."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ALL, in_words
from urdfctl.catalog.entries import FormerParameter
from urdfctl.catalog.map_parameters import matching
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.parameters import known_as
from urdfctl.rules.controllers.readers import Reader, in_each_distro


@rule(
    "UC436",
    severity=Severity.WARNING,
    authority="ros2_controllers and ros_controllers: the parameters that each distro's branches declare",
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
                «state_publish_rate»: 50.0
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
        """
    },
)
def parameter_of_other_distro(project: Project) -> Iterator[Finding]:
    """A parameter is one that a controller reads in other distros, and not in this one.

    It was removed or renamed, or came later. The value is ignored without a word, and the default used.
    """
    return in_each_distro(project, _of_others, newest=True)


def _of_others(reader: Reader) -> Iterator[Finding]:
    for leaf in reader.own.leaves:
        found = None if known_as(reader, leaf.name) else matching(leaf.name, reader.former)
        if found is not None:
            message = f"'{reader.name}' does not read '{leaf.name}'{_why(reader.former[found[0]], reader.distro)}"
            yield Finding(leaf.key, message, severity=Severity.WARNING)


def _why(former: FormerParameter, distro: str) -> str:
    instead = f"; instead: {former.replacement}" if former.replacement else f": {former.note}" if former.note else ""
    if former.last_version:
        return f" since {distro} {former.last_version}{instead}"
    if former.distros and ALL.index(former.distros[0]) > ALL.index(distro):
        return f" in {distro}, only from {former.distros[0]} on{instead}"
    return f" in {distro}" + (f", only in {in_words(former.distros)}" if former.distros else "") + instead
