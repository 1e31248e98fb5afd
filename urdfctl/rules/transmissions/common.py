"""What the rules on ROS 1 transmissions share."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import since
from urdfctl.diagnostic import Edit, Severity
from urdfctl.model.parts import Tag, Text
from urdfctl.model.project import Project
from urdfctl.model.robot import Joint, Plugin
from urdfctl.model.transmission import Transmission, TransmissionEnd
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.facts import NO_PLUGIN_TYPES, PREFIX
from urdfctl.source.span import Place, SourceSpan
from urdfctl.suggest import enumerated, folded

_CONTROL_PLUGIN = "libgazebo_ros_control.so"
_DEFAULT_SIMULATION = ("", "gazebo_ros_control/DefaultRobotHWSim")


# -- what is read ----------------------------------------------------------------------------------------------------


def read_transmissions(project: Project) -> tuple[Transmission, ...]:
    """The transmissions that ros_control's parser reads: those of its own form, directly in the root element."""
    if project.robot is None:
        return ()
    return tuple(transmission for transmission in project.robot.transmissions if not transmission.is_pr2)


def named_joints(project: Project) -> Iterator[tuple[Transmission, TransmissionEnd, str]]:
    """The joints of the transmissions that are read, each with its transmission and its name."""
    for transmission in read_transmissions(project):
        for joint in transmission.joints:
            if joint.name:
                yield transmission, joint, joint.name


def known_joints(project: Project) -> Iterator[tuple[Transmission, TransmissionEnd, str]]:
    """Those of the named joints whose name could be worked out."""
    return (found for found in named_joints(project) if is_known(found[2]))


def joints_by_name(project: Project) -> dict[str, Joint]:
    """The robot's joints; of those with one name the first."""
    joints: dict[str, Joint] = {}
    for joint in project.robot.joints if project.robot else ():
        joints.setdefault(joint.name or "", joint)
    return joints


def takes_empty_names(project: Project) -> bool:
    """Whether the parser takes an empty name: hydro's does."""
    return project.distro == "hydro"


def is_of_another_package(transmission: Transmission) -> bool:
    """Whether its type may be a plugin of another package, which reads what it likes."""
    kind = transmission.type.value if transmission.type else ""
    return "/" in kind and not kind.startswith(NO_PLUGIN_TYPES)


def misspelt(tags: Iterable[Tag], name: str) -> Tag | None:
    """The first of some elements that is spelt like a name but for case, underscores and hyphens."""
    return next((tag for tag in tags if tag.name != name and folded(tag.name) == folded(name)), None)


# -- how bad it is ---------------------------------------------------------------------------------------------------


def control_plugins(project: Project) -> tuple[Plugin, ...]:
    """The gazebo_ros_control plugins that the robot loads."""
    plugins = project.robot.plugins if project.robot else ()
    return tuple(p for p in plugins if (p.filename or "").strip().rsplit("/")[-1] == _CONTROL_PLUGIN)


def in_gazebo(project: Project) -> Severity | None:
    """How bad it is what Gazebo's default hardware simulation refuses; None where that does not run the robot.

    An error where it is known to run it: the user says so, or the robot loads its plugin and no hardware is named.
    """
    plugins = control_plugins(project)
    default = [plugin for plugin in plugins if _simulation(plugin) in _DEFAULT_SIMULATION]
    if project.named_simulator not in (None, "gazebo-classic") or (plugins and not default):
        return None
    return Severity.ERROR if default or project.named_simulator else Severity.WARNING


def _simulation(plugin: Plugin) -> str:
    setting = plugin.setting("robotSimType")
    return setting.text.strip() if setting else ""


def on_hardware(project: Project) -> Severity:
    """How bad it is what only real hardware's loader refuses: an error where nothing but hardware runs it."""
    return Severity.ERROR if project.named_simulator == "none" else Severity.WARNING


# -- what would be right ---------------------------------------------------------------------------------------------


def takes_prefix(project: Project) -> bool:
    """Whether Gazebo's hardware simulation takes `hardware_interface/...`: from kinetic on."""
    return bool(set(project.distros) & set(since("kinetic")))


def with_prefix(interface: str, project: Project) -> str:
    """An interface's name in the form that the project's distro takes."""
    bare = interface.removeprefix(PREFIX)
    return PREFIX + bare if takes_prefix(project) else bare


def in_place_of(text: Text, right: str) -> tuple[Edit, ...]:
    """The edit that replaces an element's text; none where the source does not write it literally."""
    span = text.at.content.span
    return (Edit(span, right),) if span.text == text.value else ()


def inserted(at: Place, element: str) -> tuple[Edit, ...]:
    """The edit that puts an element in front of all others in the one at a place."""
    tag = at.source.start_tag(at.start)
    if tag is None:
        return ()
    if tag.self_closed:
        return (Edit(SourceSpan(at.source, tag.end - len("/>"), tag.end), f">{element}</{tag.name}>"),)
    inside = at.source.data[tag.end : at.closing]
    blanks = inside[: len(inside) - len(inside.lstrip())].decode() if inside.strip() else ""
    return (Edit(SourceSpan(at.source, tag.end, tag.end), blanks + element),)


def in_place_of_name(at: Place, name: str, right: str) -> tuple[Edit, ...]:
    """The edit that replaces an element's name; none where the source does not write it literally."""
    span = at["name"].span
    return (Edit(span, right),) if span.text == name else ()


def listed(words: Iterable[str]) -> str:
    """`'a', 'b' and 'c'`."""
    return enumerated(f"'{word}'" for word in words)
