"""Build the model of a `<ros2_control>` component from its element."""

from __future__ import annotations

from urdfctl.model.robot.parts import Tag, text_of, texts_of
from urdfctl.model.robot.ros2_control import (
    ComponentPart,
    ControlTransmission,
    ControlTransmissionEnd,
    Hardware,
    HardwareParameter,
    Interface,
    Ros2Control,
)
from urdfctl.source.xml import dom

_PARTS = {"joint", "sensor", "gpio"}
_INTERFACES = {"command_interface": "command", "state_interface": "state"}


def ros2_control_of(element: dom.Element, parent: str) -> Ros2Control:
    """Return the component that an element describes; `parent` is the name of its parent element."""
    hardware, parts, transmissions, others = [], [], [], []
    for child in element.elements():
        if child.tagName == "hardware":
            hardware.append(_hardware(child))
        elif child.tagName in _PARTS:
            parts.append(_part(child))
        elif child.tagName == "transmission":
            transmissions.append(_transmission(child))
        else:
            others.append(Tag(child))
    return Ros2Control(
        name=element.attrs.get("name"),
        type=element.attrs.get("type"),
        at=element.at,
        hardware=tuple(hardware),
        parts=tuple(parts),
        transmissions=tuple(transmissions),
        others=tuple(others),
        parent=parent,
        tag=Tag(element),
    )


def _parameters(element: dom.Element) -> tuple[HardwareParameter, ...]:
    return tuple(
        HardwareParameter(child.attrs.get("name"), text_of(child).past_comments, child.at, Tag(child))
        for child in element.elements()
        if child.tagName == "param"
    )


def _hardware(element: dom.Element) -> Hardware:
    others = tuple(Tag(child) for child in element.elements() if child.tagName not in ("plugin", "param"))
    return Hardware(element.at, texts_of(element, "plugin"), _parameters(element), others, Tag(element))


def _part(element: dom.Element) -> ComponentPart:
    interfaces: dict[str, list[Interface]] = {"command": [], "state": []}
    others = []
    for child in element.elements():
        kind = _INTERFACES.get(child.tagName)
        if kind:
            name = child.attrs.get("name")
            interfaces[kind].append(Interface(kind, name, child.at, _parameters(child), Tag(child)))
        elif child.tagName != "param":
            others.append(Tag(child))
    return ComponentPart(
        kind=element.tagName,
        name=element.attrs.get("name"),
        at=element.at,
        commands=tuple(interfaces["command"]),
        states=tuple(interfaces["state"]),
        parameters=_parameters(element),
        others=tuple(others),
        tag=Tag(element),
    )


def _transmission(element: dom.Element) -> ControlTransmission:
    ends = [_end(child) for child in element.elements() if child.tagName in ("joint", "actuator")]
    return ControlTransmission(
        name=element.attrs.get("name"),
        at=element.at,
        plugins=texts_of(element, "plugin"),
        joints=tuple(end for end in ends if end.kind == "joint"),
        actuators=tuple(end for end in ends if end.kind == "actuator"),
        parameters=_parameters(element),
        tag=Tag(element),
    )


def _end(element: dom.Element) -> ControlTransmissionEnd:
    return ControlTransmissionEnd(
        kind=element.tagName,
        name=element.attrs.get("name"),
        role=element.attrs.get("role"),
        at=element.at,
        reductions=texts_of(element, "mechanical_reduction"),
        offsets=texts_of(element, "offset"),
        tag=Tag(element),
    )
