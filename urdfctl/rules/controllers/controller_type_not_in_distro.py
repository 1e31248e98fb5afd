"""UC422."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation, in_words, since
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.controllers.types import Typed, instead_of, typed

_MAINTAINED = {*since("humble"), "noetic"}


@rule(
    "UC422",
    severity=Severity.ERROR,
    authority="ros2_controllers and ros_controllers: the plugins that each distro's branches declare; ros2_control "
    "controller_manager/src/controller_manager.cpp: 'Loader for controller 'joint_states' (type "
    "'joint_state_controller/JointStateController') not found.'",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_states: {type: «joint_state_controller/JointStateController»}
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
        """
    },
)
def controller_type_not_in_distro(project: Project) -> Iterator[Finding]:
    """A type of controller is gone in this distro, or is not there yet.

    The controller manager cannot load it. Where it is not known which distro the robot is for, only types are told that
    none has which is still maintained.
    """
    for one in typed(project):
        own = [distro for distro in one.known_in if generation(distro) == one.ros]
        absent = [distro for distro in one.distros if distro not in own]
        if not own or not absent or _is_external(project, one, own[-1]):
            continue
        if len(absent) == len(one.distros) or set(absent) >= _MAINTAINED & set(one.distros):
            yield _finding(project, one, tuple(own), absent)


def _is_external(project: Project, one: Typed, distro: str) -> bool:
    """Whether another package than ros_control's and ros2_control's own brings it: nobody knows where it was built."""
    kind = project.catalog.controller(one.type, distro)
    return kind is not None and kind.external


def _finding(project: Project, one: Typed, own: tuple[str, ...], absent: list[str]) -> Finding:
    there = in_words(own)
    where = absent[-1] if len(absent) == 1 else "any distro that is maintained"
    found, words = instead_of(project, one.type, absent[-1])
    message = f"there is no '{one.type}' in {where}, only in {there}{f'; {words}' if words else ''}"
    fix = Fix(f"write '{found.type}'") if found else None
    notes = (Note(found.note),) if found and found.note else ()
    severity = Severity.ERROR if len(absent) == len(one.distros) else Severity.WARNING
    return Finding(one.at.at, message, notes, fix, severity)
