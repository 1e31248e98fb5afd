"""What the rules on `<ros2_control>` share: what its parser reads, and what is surely there."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator

from urdfctl.catalog.distros import ROS2, since, until
from urdfctl.hints import TYPE_CHECKING
from urdfctl.model.parts import Tag, Text
from urdfctl.model.ros2_control import Interface, Parameter, Part, Ros2Control
from urdfctl.rule import Edit, Fix, Note, Project
from urdfctl.rules.common import is_known, label, robot_in
from urdfctl.rules.ros2_control.facts import INTERFACES_OF_ROS1
from urdfctl.source.span import Place, SourceSpan

if TYPE_CHECKING:
    from urdfctl.catalog.hardware import HardwareType

JAZZY = since("jazzy")
"""The distros whose parser compares the tag with the URDF, and reads limits, data types and rates."""
OLD = until("iron")
"""Those whose parser reads the tag alone."""

_NUMBER = r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?"


def components(project: Project) -> tuple[Ros2Control, ...]:
    """The components that the parser reads: those directly in the root element."""
    robot = robot_in(project)
    return tuple(control for control in robot.ros2_controls if control.parent == robot.element) if robot else ()


def parts(project: Project, *kinds: str) -> Iterator[tuple[Ros2Control, Part]]:
    """The joints, sensors and gpios of all components, or those of some kinds, each with its component."""
    for control in components(project):
        for part in control.parts:
            if not kinds or part.kind in kinds:
                yield control, part


def interfaces(project: Project) -> Iterator[tuple[Part, Interface]]:
    """All interfaces, each with the joint, sensor or gpio it is of."""
    for _, part in parts(project):
        for interface in part.interfaces:
            yield part, interface


def parameters(project: Project) -> Iterator[tuple[str, tuple[Parameter, ...]]]:
    """The parameters that stand together, each time with what they are of."""
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
    """What a message calls a component."""
    return label("component", control.name)


def called(interface: Interface) -> str:
    """What a message calls an interface: `command interface 'position'`."""
    return label(f"{interface.kind} interface", interface.name)


def of_part(control: Ros2Control, part: Part) -> str:
    """What a message calls a part in its component."""
    return f"{label(part.kind, part.name)} in {component(control)}"


def is_boolean(text: str) -> bool:
    """Whether jazzy's parser reads a text as a boolean: `true` or `false`, in letters of any case."""
    return text.strip().lower() in ("true", "false")


def whole_element(at: Place) -> SourceSpan | None:
    """All of an element from its start tag to its end tag; None where the source does not write it literally."""
    start = at.span
    if at.closing is None:
        return start if start.text.endswith("/>") else None
    end = at.source.data.find(b">", at.closing)
    return SourceSpan(at.source, start.start, end + 1) if end >= 0 else None


def followers(project: Project) -> Iterator[tuple[Part, tuple[Ros2Control, str]]]:
    """The joints that mimic another as jazzy's parser has it, each with its component and the other's name: the URDF's
    `<mimic>` makes them so, where the attribute `mimic` does not say false."""
    robot = robot_in(project)
    mimics = {joint.name: joint.mimic.joint for joint in robot.joints if joint.mimic} if robot else {}
    for control, joint in parts(project, "joint") if mimics else ():
        mimicked = mimics.get((joint.name or "").strip())
        if mimicked and joint.tag.attributes.get("mimic", "").strip().lower() != "false" and is_known(joint.name):
            yield joint, (control, mimicked)


def first_of(tag: Tag, name: str) -> tuple[Tag, ...]:
    """The first child of a name, which is all that is read of them; none where there is none."""
    return tuple(tag.named(name))[:1]


def leading_integer(text: str) -> int | None:
    """What C++'s std::stoi reads: the whole number at the start of a text, whatever follows; None where it throws."""
    found = re.match(r"\s*[+-]?[0-9]{1,30}", text)
    return int(found.group()) if found else None


def is_positive_integer(text: str) -> bool:
    """Whether a text is a whole number above 0 that an int holds, without sign or point."""
    return bool(re.fullmatch(r"[1-9][0-9]{0,9}", text.strip())) and int(text) < 2**31


def hardware_interfaces(tag: Tag) -> list[str]:
    """The hardware interfaces of ROS 1 that a transmission's joint names."""
    return [child.text for child in tag.named("hardwareInterface")]


def replacement(joints: Iterable[tuple[str | None, list[str]]], there: Container[str | None]) -> Iterator[Note]:
    """What to write in `<ros2_control>` for joints of ROS 1's transmissions that it does not have, by their names and
    hardware interfaces."""
    for name, found in joints:
        if not name or name in there:
            continue
        words = [INTERFACES_OF_ROS1.get(each.rsplit("/")[-1]) for each in found]
        commands = [word for word in words if word] or ["position"]
        inside = [f'<command_interface name="{word}"/>' for word in commands]
        inside += [f'<state_interface name="{word}"/>' for word in dict.fromkeys(("position", "velocity", *commands))]
        yield Note(f'in <ros2_control> it is <joint name="{name}">{"".join(inside)}</joint>')


def is_number(text: str) -> bool:
    """Whether ros2_control reads a text as a number: a finite decimal with nothing behind it."""
    return bool(re.fullmatch(_NUMBER, text.strip())) and abs(float(text)) != float("inf")


def known_hardware(project: Project, control: Ros2Control) -> tuple[HardwareType, ...]:
    """What the catalogue knows of a component's plugin, for each distro that the project may be for and that has it."""
    name = control.plugin or ""
    found = (project.catalog.hardware(name, distro) for distro in project.distros if distro in ROS2) if name else ()
    return tuple(each for each in found if each is not None)


def is_deaf(project: Project, control: Ros2Control, name: str) -> bool:
    """Whether a component's plugin is one that does not read a joint's parameter, in a distro that it may be for."""
    return any(
        each.joint_parameters is not None and name not in each.joint_parameters
        for each in known_hardware(project, control)
    )


def folded(name: str) -> str:
    """A plugin's name without what people get wrong in it: letters' case, separators and quotes."""
    return name.strip("\"' ").lower().replace("::", "/").replace("-", "_")


def mended(text: Text, right: str) -> Fix:
    """The repair that writes another text into an element; for a person to make where the source does not write it so."""
    content = text.at.content.span
    edits = (Edit(content, right),) if content.text == text.past_comments else ()
    return Fix(f"write '{right}'", edits)


def side_by_side(project: Project, first: Place, second: Place) -> bool:
    """Whether two elements stand there both: in a library, where conditions are not decided, none may be between them."""
    if not project.library:
        return True
    between = first.source.data[first.start : second.start]
    return first.source is second.source and first.start < second.start and b"xacro:" not in between
