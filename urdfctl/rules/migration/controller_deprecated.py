"""UC704."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, in_words
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.controllers.types import typed
from urdfctl.rules.migration.common import severity_of_old


@rule(
    "UC704",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_controllers doc/migration.rst and release_notes.rst: what is deprecated in favour of what",
    options=["--distro=foxy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_state_controller:
                  type: «joint_state_controller/JointStateController»
        """,
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_state_broadcaster:
                  type: joint_state_broadcaster/JointStateBroadcaster
        """,
    },
)
def controller_deprecated(project: Project) -> Iterator[Finding]:
    """A type of controller is deprecated: this distro has it, and soon none will.

    Its successor takes other parameters in places, and another name.
    """
    for one in typed(project):
        kinds = {distro: project.catalog.controller(one.type, distro) for distro in one.distros if distro in ROS2}
        there = {distro: kind for distro, kind in kinds.items() if kind}
        severity = severity_of_old(project, [distro for distro, kind in there.items() if kind.deprecated])
        if severity is None:
            continue
        instead = project.catalog.replacement(one.type, list(there)[-1])
        message = f"'{one.type}' is deprecated, and gone from all but {in_words(one.known_in)}"
        fix = Fix(f"write '{instead.type}'") if instead else None
        notes = (Note(instead.note),) if instead and instead.note else ()
        yield Finding(one.at.at, message, notes, fix, severity)
