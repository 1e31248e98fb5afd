"""Helpers shared by the rules on ROS 1 transmissions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.hardware.gazebo_ros1 import has_own_simulation
from urdfctl.diagnostic import Edit, Severity
from urdfctl.model.project import Project
from urdfctl.model.robot import ElementText, Joint, Tag, Transmission, TransmissionEnd
from urdfctl.names import enumerated, folded
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.facts import NO_PLUGIN_TYPES, PREFIX
from urdfctl.source.span import Place

# -- transmissions and joints ------------------------------------------------------------------------------------------


def read_transmissions(project: Project) -> tuple[Transmission, ...]:
    """Return the transmissions that ros_control's parser reads: directly under <robot>, and not in the PR2 form.

    None if a simulation of another package reads them, as only it knows what it needs.
    """
    if project.robot is None or has_own_simulation(project):
        return ()
    return tuple(transmission for transmission in project.robot.transmissions if not transmission.is_pr2)


def named_joints(project: Project) -> Iterator[tuple[Transmission, TransmissionEnd, str]]:
    """Yield each named joint of the transmissions that are read, as (transmission, joint, name)."""
    for transmission in read_transmissions(project):
        for joint in transmission.joints:
            if joint.name:
                yield transmission, joint, joint.name


def known_joints(project: Project) -> Iterator[tuple[Transmission, TransmissionEnd, str]]:
    """Yield the named joints whose name is fully expanded."""
    return (named for named in named_joints(project) if is_known(named[2]))


def joints_by_name(project: Project) -> dict[str, Joint]:
    """Return the robot's joints by name; for a duplicate name, the first joint."""
    joints: dict[str, Joint] = {}
    for joint in project.robot.joints if project.robot else ():
        joints.setdefault(joint.name or "", joint)
    return joints


def takes_empty_names(project: Project) -> bool:
    """Return whether the parser accepts an empty name, as in hydro."""
    return project.distro == "hydro"


def is_of_another_package(transmission: Transmission) -> bool:
    """Return whether the type may be a plugin of another package, which has its own format."""
    kind = transmission.type.value if transmission.type else ""
    return "/" in kind and not kind.startswith(NO_PLUGIN_TYPES)


def misspelt(tags: Iterable[Tag], name: str) -> Tag | None:
    """Return the first element whose name differs only in case, underscores or hyphens; None if there is none."""
    return next((tag for tag in tags if tag.name != name and folded(tag.name) == folded(name)), None)


# -- severity ----------------------------------------------------------------------------------------------------------


def on_hardware(project: Project) -> Severity:
    """Return the severity of what only the loader of real hardware rejects: an error if there is no simulator."""
    return Severity.ERROR if project.named_simulator == "none" else Severity.WARNING


# -- corrections -------------------------------------------------------------------------------------------------------


def takes_prefix(project: Project) -> bool:
    """Return whether Gazebo's hardware simulation accepts `hardware_interface/...`: from kinetic on."""
    return bool(set(project.distros) & set(since("kinetic")))


def with_prefix(interface: str, project: Project) -> str:
    """Return an interface's name in the form that the project's distro accepts."""
    bare = interface.removeprefix(PREFIX)
    return PREFIX + bare if takes_prefix(project) else bare


def in_place_of(text: ElementText, right: str) -> tuple[Edit, ...]:
    """Return the edit that replaces an element's text; none if the source does not contain it literally."""
    span = text.at.content.span
    return (Edit(span, right),) if span.text == text.value else ()


def in_place_of_name(at: Place, name: str, right: str) -> tuple[Edit, ...]:
    """Return the edit that replaces an element's `name`; none if the source does not contain it literally."""
    span = at["name"].span
    return (Edit(span, right),) if span.text == name else ()


def listed(words: Iterable[str]) -> str:
    """Return names in quotes: `'a', 'b' and 'c'`."""
    return enumerated(f"'{word}'" for word in words)
