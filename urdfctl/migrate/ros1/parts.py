"""Write the joints of `<ros2_control>`, and the transmissions in it, for the transmissions of ROS 1."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from urdfctl.migrate.edits.markup import attribute, child, children, content
from urdfctl.migrate.ros1.interfaces import command_names, commands_of, states_of
from urdfctl.migrate.ros1.uses import TransmissionUse
from urdfctl.model.robot import Transmission
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_SIMPLE = "transmission_interface/SimpleTransmission"
_TYPES = {
    "SimpleTransmission": _SIMPLE,
    "DifferentialTransmission": "transmission_interface/DifferentialTransmission",
    "FourBarLinkageTransmission": "transmission_interface/FourBarLinkageTransmission",
}


class Converted(NamedTuple):
    """A transmission of ROS 1 as parts of `<ros2_control>`.

    text: the elements, indented by nothing.
    joints: the joints' names as they are written.
    arguments: the xacro arguments that the text reads as properties: the names of property and argument.
    kept: whether it stays a transmission, nested.
    dropped: the reduction that is dropped because the simulator does not read it; empty if none is.
    """

    text: str
    joints: tuple[str, ...]
    arguments: tuple[tuple[str, str], ...] = ()
    kept: bool = False
    dropped: str = ""


class UnreadableTransmission(Exception):
    """A transmission that cannot be migrated; the message says why."""


def converted(
    element: Element, uses: Sequence[TransmissionUse], passive: Mapping[str, str], *, simulated: bool, step: str
) -> Converted:
    """Return what a `<transmission>` becomes.

    uses: where robots use it.
    passive: the joints that nothing commands, each with the parameters to write.
    simulated: whether only a simulator reads it, which has no reductions.
    step: the blanks to indent by.

    Raises Unreadable if its interface or its type is not one of ROS.
    """
    kind = content(child(element, "type") or element).rpartition("/")[2]
    if kind not in _TYPES:
        raise UnreadableTransmission(
            f"the type '{content(child(element, 'type') or element)}' has no known replacement"
        )
    joints = list(children(element, "joint"))
    if not joints:
        raise UnreadableTransmission("it has no joint")
    texts, arguments = [], []
    for joint in joints:
        text, its_arguments = _joint(element, joint, uses, passive, step)
        texts.append(text)
        arguments += its_arguments
    kept, dropped = _reduction(element, uses, kind, simulated=simulated)
    if kept:
        texts.append("".join(_nested(element, joints, kind, step)))
    names = tuple(attribute(joint, "name") for joint in joints)
    return Converted("".join(texts), names, tuple(dict.fromkeys(arguments)), kept=kept, dropped=dropped)


def _joint(
    element: Element, joint: Element, uses: Sequence[TransmissionUse], passive: Mapping[str, str], step: str
) -> tuple[str, list[tuple[str, str]]]:
    written = [content(one) for one in children(joint, "hardwareInterface") if content(one)]
    written = (
        written
        or [content(one) for end in children(element, "actuator") for one in children(end, "hardwareInterface")][:1]
    )
    if not written:
        raise UnreadableTransmission("it names no hardware interface")
    names: list[str] = []
    arguments: list[tuple[str, str]] = []
    for position, text in enumerate(written):
        found = command_names(text, _evaluated(joint, uses, position))
        if found is None:
            raise UnreadableTransmission(f"the interface '{text}' has no known replacement")
        names += found.names
        arguments += found.arguments
    evaluated = {name for value in _all_evaluated(joint, uses) for name in commands_of(value) or ()}
    known = [passive.get(name) for name in _names(joint, uses)]
    parameters = known[0] if known and all(each is not None for each in known) else None
    return joint_text(
        attribute(joint, "name"),
        () if parameters is not None else tuple(dict.fromkeys(names)),
        states_of(evaluated or names),
        step,
        parameters or "",
    ), arguments


def joint_text(name: str, commands: Collection[str], states: Collection[str], step: str, more: str = "") -> str:
    """Return a `<joint>` of `<ros2_control>`. `more` are further lines in it."""
    lines = [f'<joint name="{name}">']
    lines += (f'{step}<command_interface name="{command}"/>' for command in commands)
    lines += (f'{step}<state_interface name="{state}"/>' for state in states)
    lines += (f"{step}{line}" for line in more.splitlines())
    return "\n".join([*lines, "</joint>\n"])


def _index(joint: Element) -> int:
    above = joint.parentNode
    assert isinstance(above, Element)  # noqa: S101 (it was found there)
    return [one.start for one in children(above, "joint")].index(joint.start)


def _names(joint: Element, uses: Sequence[TransmissionUse]) -> list[str]:
    index = _index(joint)
    return [name for use in uses if index < len(use.value.joints) and (name := use.value.joints[index].name)]


def _all_evaluated(joint: Element, uses: Sequence[TransmissionUse]) -> set[str]:
    return {text for position in range(4) for text in _evaluated(joint, uses, position)}


def _evaluated(joint: Element, uses: Sequence[TransmissionUse], position: int) -> set[str]:
    """The values of an interface's text in the robots."""
    index = _index(joint)
    found = set()
    for use in uses:
        ends = use.value.joints
        interfaces = ends[index].named_interfaces if index < len(ends) else ()
        if not interfaces and use.value.actuators:
            interfaces = use.value.actuators[0].named_interfaces
        if position < len(interfaces):
            found.add(interfaces[position].value)
    return found


def _reduction(element: Element, uses: Sequence[TransmissionUse], kind: str, *, simulated: bool) -> tuple[bool, str]:
    """Whether the transmission is needed on its own, and the reduction that is dropped."""
    written = [content(one) for end in element.elements() for one in children(end, "mechanicalReduction")]
    values = {text for use in uses for text in _reductions(use.value)} or set(written)
    if kind != "SimpleTransmission":
        return True, ""
    if all(is_one(value) for value in values):
        return False, ""
    return not simulated, written[0] if simulated and written else ""


def _reductions(transmission: Transmission) -> Iterator[str]:
    for end in (*transmission.joints, *transmission.actuators):
        yield from (text.value for text in end.reductions)


def is_one(text: str) -> bool:
    """Return whether a reduction is none."""
    try:
        return float(text) == 1.0
    except ValueError:
        return not text


def _nested(element: Element, joints: Sequence[Element], kind: str, step: str) -> Iterator[str]:
    """The lines of the transmission in the form of ROS 2 (transmission_interface, control.ros.org)."""
    actuators = list(children(element, "actuator"))
    yield f'<transmission name="{attribute(element, "name")}">\n'
    yield f"{step}<plugin>{_TYPES[kind]}</plugin>\n"
    for ends, name in ((actuators, "actuator"), (joints, "joint")):
        for number, end in enumerate(ends, start=1):
            role = content(child(end, "role") or end) if child(end, "role") else f"{name}{number}"
            yield from _end(
                end, name, role, step, [] if kind != "SimpleTransmission" or name == "actuator" else actuators
            )
    yield "</transmission>\n"


def _end(end: Element, name: str, role: str, step: str, others: Sequence[Element]) -> Iterator[str]:
    """A joint or actuator. For a simple transmission the joint has the reduction that ROS 1 wrote in the actuator."""
    inner = []
    for old, new in (("mechanicalReduction", "mechanical_reduction"), ("offset", "offset")):
        found = [one for each in (end, *others) for one in children(each, old)]
        inner += [f"{step}{step}<{new}>{content(one)}</{new}>\n" for one in found[:1]]
    is_simple_actuator = name == "actuator" and not others and _is_simple(end)
    opened = f'{step}<{name} name="{attribute(end, "name")}" role="{role}"'
    if not inner or is_simple_actuator:
        yield f"{opened}/>\n"
    else:
        yield f"{opened}>\n{''.join(inner)}{step}</{name}>\n"


def _is_simple(end: Element) -> bool:
    above = end.parentNode
    kind = child(above, "type") if isinstance(above, Element) else None
    return kind is not None and content(kind).endswith("SimpleTransmission")
