"""Shared by the rules on `<ros2_control>`: the elements that its parser reads, and checks of their texts."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator
from typing import TYPE_CHECKING

from urdfctl.catalog.distros import ROS2, since, until
from urdfctl.model.robot import ComponentPart, ElementText, HardwareParameter, Interface, Ros2Control, Tag
from urdfctl.rule import Edit, Fix, Note, Project
from urdfctl.rules.common import is_known, label, robot_in
from urdfctl.rules.ros2_control.facts import INTERFACES_OF_ROS1
from urdfctl.source.span import Place, SourceSpan

if TYPE_CHECKING:
    from urdfctl.catalog.hardware import HardwareType

JAZZY = since("jazzy")
"""The distros whose parser compares the tag with the URDF, and reads limits, data types and rates."""
OLD = until("iron")
"""The distros whose parser reads only the tag."""

_NUMBER = r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?"


def components(project: Project) -> tuple[Ros2Control, ...]:
    """Return the components that the parser reads: those directly in the root element."""
    robot = robot_in(project)
    return tuple(control for control in robot.ros2_controls if control.parent == robot.element) if robot else ()


def parts(project: Project, *kinds: str) -> Iterator[tuple[Ros2Control, ComponentPart]]:
    """Yield the joints, sensors and gpios of all components, or only some kinds, each with its component."""
    for control in components(project):
        for part in control.parts:
            if not kinds or part.kind in kinds:
                yield control, part


def interfaces(project: Project) -> Iterator[tuple[ComponentPart, Interface]]:
    """Yield all interfaces, each with its joint, sensor or gpio."""
    for _, part in parts(project):
        for interface in part.interfaces:
            yield part, interface


def parameters(project: Project) -> Iterator[tuple[str, tuple[HardwareParameter, ...]]]:
    """Yield the parameters of each element that has some, after the label of the element."""
    for control in components(project):
        for hardware in control.hardware:
            yield f"the hardware of {component(control)}", hardware.parameters
        for part in control.parts:
            yield label(part.kind, part.name), part.parameters
            for interface in part.interfaces:
                yield f"{called(interface)} of {label(part.kind, part.name)}", interface.parameters
        for transmission in control.transmissions:
            yield label("transmission", transmission.name), transmission.parameters


def component(control: Ros2Control) -> str:
    """Return the label of a component in a message."""
    return label("component", control.name)


def called(interface: Interface) -> str:
    """Return the label of an interface in a message: `command interface 'position'`."""
    return label(f"{interface.kind} interface", interface.name)


def of_part(control: Ros2Control, part: ComponentPart) -> str:
    """Return the label of a part in its component, for a message."""
    return f"{label(part.kind, part.name)} in {component(control)}"


def is_boolean(text: str) -> bool:
    """Return whether jazzy's parser reads a text as a boolean: `true` or `false`, in any case."""
    return text.strip().lower() in ("true", "false")


def whole_element(at: Place) -> SourceSpan | None:
    """Return the span of an element with its start and end tag; None if the source does not write it literally."""
    start = at.span
    if at.closing is None:
        return start if start.text.endswith("/>") else None
    end = at.source.data.find(b">", at.closing)
    return SourceSpan(at.source, start.start, end + 1) if end >= 0 else None


def followers(project: Project) -> Iterator[tuple[ComponentPart, tuple[Ros2Control, str]]]:
    """Yield the mimic joints, each with its component and the name of the mimicked joint.

    As in jazzy's parser, a joint is a mimic joint if the URDF has a `<mimic>` and its attribute `mimic` is not false.
    """
    robot = robot_in(project)
    mimics = {joint.name: joint.mimic.joint for joint in robot.joints if joint.mimic} if robot else {}
    for control, joint in parts(project, "joint") if mimics else ():
        mimicked = mimics.get((joint.name or "").strip())
        if mimicked and joint.tag.attributes.get("mimic", "").strip().lower() != "false" and is_known(joint.name):
            yield joint, (control, mimicked)


def first_of(tag: Tag, name: str) -> tuple[Tag, ...]:
    """Return the first child of a name, the only one that is read; empty if there is none."""
    return tuple(tag.named(name))[:1]


def leading_integer(text: str) -> int | None:
    """Return what C++'s std::stoi reads: the integer at the start of a text; None if it throws."""
    integer = re.match(r"\s*[+-]?[0-9]{1,30}", text)
    return int(integer.group()) if integer else None


def is_positive_integer(text: str) -> bool:
    """Return whether a text is a positive integer that fits into an int, without sign or point."""
    return bool(re.fullmatch(r"[1-9][0-9]{0,9}", text.strip())) and int(text) < 2**31


def hardware_interfaces(tag: Tag) -> list[str]:
    """Return the hardware interfaces of ROS 1 that a transmission's joint names."""
    return [child.text for child in tag.named("hardwareInterface")]


def replacement(joints: Iterable[tuple[str | None, list[str]]], controlled: Container[str | None]) -> Iterator[Note]:
    """Yield what to write in `<ros2_control>` for joints of ROS 1 transmissions.

    joints: names with their hardware interfaces of ROS 1. controlled: the joints that `<ros2_control>` already has.
    """
    for name, of_ros1 in joints:
        if not name or name in controlled:
            continue
        yield Note(f"in <ros2_control>, write {joint_element(name, of_ros1)}")


def joint_element(name: str, of_ros1: Iterable[str]) -> str:
    """Return the `<joint>` of a component for a joint with hardware interfaces of ROS 1; position if none is known."""
    of_ros2 = [INTERFACES_OF_ROS1.get(interface.rsplit("/")[-1]) for interface in of_ros1]
    commands = [interface for interface in of_ros2 if interface] or ["position"]
    states = dict.fromkeys(("position", "velocity", *commands))
    inside = [f'<command_interface name="{interface}"/>' for interface in commands]
    inside += [f'<state_interface name="{interface}"/>' for interface in states]
    return f'<joint name="{name}">{"".join(inside)}</joint>'


def is_number(text: str) -> bool:
    """Return whether ros2_control reads a text as a number: a finite decimal with nothing after it."""
    return bool(re.fullmatch(_NUMBER, text.strip())) and abs(float(text)) != float("inf")


def known_hardware(project: Project, control: Ros2Control) -> tuple[HardwareType, ...]:
    """Return the catalogue entries of a component's plugin, one for each of the project's distros that has it."""
    name = control.plugin or ""
    entries = (project.catalog.hardware(name, distro) for distro in project.distros if distro in ROS2) if name else ()
    return tuple(entry for entry in entries if entry is not None)


def interfaces_exported(hardware: HardwareType, kind: str) -> tuple[str, ...] | None:
    """Return the interfaces that hardware exports for a joint, of the kind `command` or `state`; None if it exports any,
    or if this is not known."""
    return hardware.command_interfaces if kind == "command" else hardware.state_interfaces


def is_deaf(project: Project, control: Ros2Control, name: str) -> bool:
    """Return whether a component's plugin is known to ignore a joint parameter in one of the project's distros."""
    return any(
        each.joint_parameters is not None and name not in each.joint_parameters
        for each in known_hardware(project, control)
    )


def folded(name: str) -> str:
    """Return a plugin's name without the usual slips: case, separators and quotes."""
    return name.strip("\"' ").lower().replace("::", "/").replace("-", "_")


def corrected(text: ElementText, new: str) -> Fix:
    """Return the fix that replaces the text of an element; without edits if the source does not write it literally."""
    content = text.at.content.span
    edits = (Edit(content, new),) if content.text == text.past_comments else ()
    return Fix(f"write '{new}'", edits)


def side_by_side(project: Project, first: Place, second: Place) -> bool:
    """Return whether both elements exist at once: in a library, no undecided condition may be between them."""
    if not project.library:
        return True
    between = first.source.data[first.start : second.start]
    return first.source is second.source and first.start < second.start and b"xacro:" not in between
