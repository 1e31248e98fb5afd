"""Builds the `<ros2_control>` components of a robot from its expanded tree."""

from __future__ import annotations

from urdfctl.model.parts import Tag, text_of, texts_of
from urdfctl.model.ros2_control import (
    ControlTransmission,
    ControlTransmissionEnd,
    Hardware,
    Interface,
    Parameter,
    Part,
    Ros2Control,
)
from urdfctl.source import dom

_PARTS = {"joint", "sensor", "gpio"}
_INTERFACES = {"command_interface": "command", "state_interface": "state"}


def ros2_control_of(element: dom.Element, parent: str) -> Ros2Control:
    """The component that an element describes, which stands in one named `parent`."""
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
        element.attrs.get("name"),
        element.attrs.get("type"),
        element.at,
        tuple(hardware),
        tuple(parts),
        tuple(transmissions),
        tuple(others),
        parent,
        Tag(element),
    )


def _parameters(element: dom.Element) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(child.attrs.get("name"), text_of(child).past_comments, child.at, Tag(child))
        for child in element.elements()
        if child.tagName == "param"
    )


def _hardware(element: dom.Element) -> Hardware:
    others = tuple(Tag(child) for child in element.elements() if child.tagName not in ("plugin", "param"))
    return Hardware(element.at, texts_of(element, "plugin"), _parameters(element), others, Tag(element))


def _part(element: dom.Element) -> Part:
    interfaces: dict[str, list[Interface]] = {"command": [], "state": []}
    others = []
    for child in element.elements():
        kind = _INTERFACES.get(child.tagName)
        if kind:
            name = child.attrs.get("name")
            interfaces[kind].append(Interface(kind, name, child.at, _parameters(child), Tag(child)))
        elif child.tagName != "param":
            others.append(Tag(child))
    return Part(
        element.tagName,
        element.attrs.get("name"),
        element.at,
        tuple(interfaces["command"]),
        tuple(interfaces["state"]),
        _parameters(element),
        tuple(others),
        Tag(element),
    )


def _transmission(element: dom.Element) -> ControlTransmission:
    ends = [_end(child) for child in element.elements() if child.tagName in ("joint", "actuator")]
    return ControlTransmission(
        element.attrs.get("name"),
        element.at,
        texts_of(element, "plugin"),
        tuple(end for end in ends if end.kind == "joint"),
        tuple(end for end in ends if end.kind == "actuator"),
        _parameters(element),
        Tag(element),
    )


def _end(element: dom.Element) -> ControlTransmissionEnd:
    return ControlTransmissionEnd(
        element.tagName,
        element.attrs.get("name"),
        element.attrs.get("role"),
        element.at,
        texts_of(element, "mechanical_reduction"),
        texts_of(element, "offset"),
        Tag(element),
    )
