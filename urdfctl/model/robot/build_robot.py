"""Build the model of a robot from its expanded tree."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from urdfctl.model.robot.build_ros2_control import ros2_control_of
from urdfctl.model.robot.parts import Number, PartReference, Tag, text_of, texts_of
from urdfctl.model.robot.robot import (
    Gazebo,
    Geometry,
    Inertial,
    Joint,
    Limit,
    Link,
    Mesh,
    MeshFile,
    Mimic,
    Plugin,
    Robot,
)
from urdfctl.model.robot.transmission import Transmission, TransmissionEnd
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.xml import dom

_READ_OF_AN_END = {"role", "hardwareInterface", "mechanicalReduction", "offset"}
TOP_LEVEL = {"link", "joint", "transmission", "gazebo", "ros2_control"}

MeshFinder = Callable[[str], MeshFile | None]
"""Looks up the file of a mesh by its address in the description; None if nothing is known about it."""


def robot_of(root: dom.Element, find_mesh: MeshFinder | None = None, *, whole: bool = True) -> Robot:
    """Return the robot that a root element describes.

    find_mesh: looks up the files of meshes.
    whole: False if part of the robot could not be expanded. Then top-level elements with unknown content are left out,
        so that no rule reports anything about them.
    """
    by_name: dict[str, list[dom.Element]] = {name: [] for name in TOP_LEVEL}
    others = []
    for child in root.elements():
        if not whole and _has_unknown_content(child):
            continue
        if child.tagName in by_name:
            by_name[child.tagName].append(child)
        else:
            others.append(Tag(child))
    nested = list(_nested(root, {"transmission", "ros2_control"}))
    links = tuple(_link(child) for child in by_name["link"])
    return Robot(
        name=root.attrs.get("name"),
        at=root.at,
        links=links,
        joints=tuple(_joint(child) for child in by_name["joint"]),
        transmissions=tuple(_transmission(child, root.tagName) for child in by_name["transmission"]),
        nested_transmissions=tuple(
            _transmission(child, parent) for child, parent in nested if child.tagName == "transmission"
        ),
        ros2_controls=(
            *(ros2_control_of(child, root.tagName) for child in by_name["ros2_control"]),
            *(ros2_control_of(child, parent) for child, parent in nested if child.tagName == "ros2_control"),
        ),
        gazebos=tuple(_gazebo(child) for child in by_name["gazebo"]),
        others=tuple(others),
        element=root.tagName,
        version=root.attrs.get("version"),
        meshes=tuple(_meshes(links, find_mesh)),
        tag=Tag(root),
    )


def _has_unknown_content(element: dom.Element) -> bool:
    return element.tagName == UNKNOWN or any(_has_unknown_content(child) for child in element.elements())


def _nested(root: dom.Element, names: set[str]) -> Iterator[tuple[dom.Element, str]]:
    """The elements with these names below the children of the root, each with the name of its parent."""
    pending = [child for child in root.elements() if child.tagName != "ros2_control"]
    while pending:
        parent = pending.pop()
        for child in parent.elements():
            if child.tagName in names:
                yield child, parent.tagName
            elif child.firstChild is not None:
                pending.append(child)


# -- small parts -----------------------------------------------------------------------------------------------------


def _first(element: dom.Element, name: str) -> dom.Element | None:
    return next((child for child in element.elements() if child.tagName == name), None)


def _number(element: dom.Element | None, attribute: str) -> Number | None:
    if element is None or attribute not in element.attrs:
        return None
    return Number(element.attrs[attribute], element.at, attribute)


# -- links and joints ------------------------------------------------------------------------------------------------


def _link(element: dom.Element) -> Link:
    inertials, geometries = [], []
    for child in element.elements():
        if child.tagName == "inertial":
            inertials.append(_inertial(child))
        elif child.tagName in ("visual", "collision"):
            geometry = _first(child, "geometry")
            shape = next(iter(geometry.elements()), None) if geometry is not None else None
            geometries.append(Geometry(child.tagName, child.at, Tag(shape) if shape is not None else None))
    return Link(element.attrs.get("name"), element.at, tuple(inertials), tuple(geometries), Tag(element))


def _meshes(links: tuple[Link, ...], find: MeshFinder | None) -> Iterator[Mesh]:
    files: dict[str, MeshFile | None] = {}
    for link in links:
        for geometry in link.geometries:
            filename = geometry.shape.attributes.get("filename") if geometry.shape else None
            if geometry.shape is None or geometry.shape.name != "mesh" or filename is None:
                continue
            if filename not in files:
                files[filename] = find(filename) if find else None
            yield Mesh(filename, geometry.shape.at, link.name, files[filename])


def _inertial(element: dom.Element) -> Inertial:
    inertia = _first(element, "inertia")
    moments = None
    if inertia is not None:
        moments = {name: Number(text, inertia.at, name) for name, text in inertia.attrs.items()}
    return Inertial(element.at, _number(_first(element, "mass"), "value"), moments, inertia.at if inertia else None)


def _joint(element: dom.Element) -> Joint:
    return Joint(
        name=element.attrs.get("name"),
        type=element.attrs.get("type"),
        at=element.at,
        parent=_reference(element, "parent"),
        child=_reference(element, "child"),
        axis=_number(_first(element, "axis"), "xyz"),
        limit=_limit(_first(element, "limit")),
        mimic=_mimic(_first(element, "mimic")),
        tag=Tag(element),
    )


def _reference(element: dom.Element, name: str) -> PartReference | None:
    child = _first(element, name)
    return PartReference(child.attrs.get("link"), child.at, "link") if child is not None else None


def _limit(element: dom.Element | None) -> Limit | None:
    if element is None:
        return None
    lower, upper, effort, velocity = (_number(element, name) for name in ("lower", "upper", "effort", "velocity"))
    return Limit(element.at, lower, upper, effort, velocity)


def _mimic(element: dom.Element | None) -> Mimic | None:
    if element is None:
        return None
    return Mimic(element.attrs.get("joint"), element.at, _number(element, "multiplier"), _number(element, "offset"))


# -- transmissions ---------------------------------------------------------------------------------------------------


def _transmission(element: dom.Element, parent: str) -> Transmission:
    joints, actuators, others = [], [], []
    kind = None
    for child in element.elements():
        if child.tagName == "joint":
            joints.append(_end(child))
        elif child.tagName == "actuator":
            actuators.append(_end(child))
        elif child.tagName == "type" and kind is None:
            kind = text_of(child)
        else:
            others.append(Tag(child))
    return Transmission(
        name=element.attrs.get("name"),
        at=element.at,
        type=kind,
        type_attribute=element.attrs.get("type"),
        joints=tuple(joints),
        actuators=tuple(actuators),
        others=tuple(others),
        parent=parent,
        tag=Tag(element),
    )


def _end(element: dom.Element) -> TransmissionEnd:
    role = _first(element, "role")
    return TransmissionEnd(
        name=element.attrs.get("name"),
        at=element.at,
        role=text_of(role) if role is not None else None,
        interfaces=texts_of(element, "hardwareInterface"),
        reductions=texts_of(element, "mechanicalReduction"),
        offsets=texts_of(element, "offset"),
        others=tuple(Tag(child) for child in element.elements() if child.tagName not in _READ_OF_AN_END),
        tag=Tag(element),
    )


# -- Gazebo ---------------------------------------------------------------------------------------------------------


def _gazebo(element: dom.Element) -> Gazebo:
    plugins = tuple(
        Plugin(child.attrs.get("name"), child.attrs.get("filename"), child.at, Tag(child))
        for child in element.elements()
        if child.tagName == "plugin"
    )
    return Gazebo(element.attrs.get("reference"), element.at, plugins, Tag(element))
