"""UC704."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, in_words
from urdfctl.control.parameters.controller_types import typed_upstream
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.migration.common import severity_of_old


@rule(
    "UC704",
    runtime="works",
    because="later distros do not have it",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_controllers doc/migration.rst and release_notes.rst: deprecated types and their successors",
    options=["--distro=foxy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_state_controller:
                      type: «joint_state_controller/JointStateController»
            """,
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_state_broadcaster:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
        },
    ],
)
def controller_deprecated(project: Project) -> Iterator[Finding]:
    """Deprecated controller type.

    This distro still has the type, but later distros do not. Its successor has a different name, and in some cases
    other parameters.
    """
    for use in typed_upstream(project):
        kinds = {distro: project.catalog.controller(use.type, distro) for distro in use.distros if distro in ROS2}
        there = {distro: kind for distro, kind in kinds.items() if kind}
        severity = severity_of_old(project, [distro for distro, kind in there.items() if kind.deprecated])
        if severity is None:
            continue
        instead = project.catalog.replacement(use.type, list(there)[-1])
        message = f"controller type '{use.type}' is deprecated; it exists only in {in_words(use.known_in)}"
        fix = Fix(f"write '{instead.type}'") if instead else None
        notes = (Note(instead.note),) if instead and instead.note else ()
        yield Finding(use.at.at, message, notes, fix, severity)
