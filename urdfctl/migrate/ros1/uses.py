"""Where robots use the transmissions of a file: each with the macro calls that lead to it, and its values there."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.edits.markup import MACRO, ancestors, element_at, elements, root_of
from urdfctl.migrate.edits.places import ElementKey, key_of
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.model.robot import Robot, Transmission
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Call, Place
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


class TransmissionUse(NamedTuple):
    """One transmission in one robot.

    robot: a number for the robot.
    calls: the macro calls that lead to it, innermost first, by the start tag of the call.
    value: the transmission as the robot has it.
    """

    robot: int
    calls: tuple[ElementKey, ...]
    value: Transmission


class Uses:
    """The transmissions in the files, and the robots that use them.

    robots: the robots, by the number in `Use.robot`.
    inserted: transmissions that a macro gets as a block, so that they cannot be moved.
    """

    def __init__(self, packages: MigratedPackages) -> None:
        self.packages = packages
        self.robots: list[LoadedTarget] = []
        self.by_element: dict[ElementKey, list[TransmissionUse]] = {}
        self.inserted: set[ElementKey] = set()
        for loaded in packages.loaded():
            if loaded.project.robot is not None:
                self._add(loaded, loaded.project.robot)

    def _add(self, loaded: LoadedTarget, robot: Robot) -> None:
        number = len(self.robots)
        self.robots.append(loaded)
        for transmission in robot.transmissions:
            key = key_of(transmission.at)
            if transmission.is_pr2 or self.element(key) is None:
                continue
            calls = tuple(call for call in _calls(transmission.at) if call.kind != "include")
            if any(call.kind == "block" for call in calls):
                self.inserted.add(key)
                continue
            use = TransmissionUse(
                number, tuple((os.path.realpath(c.source.path), c.offset) for c in calls), transmission
            )
            self.by_element.setdefault(key, []).append(use)

    def element(self, key: ElementKey) -> Element | None:
        """Return an element as it is written."""
        path, start = key
        return element_at(self.packages.read(path), start) if self.packages.may_change(path) else None

    def unused(self) -> Iterator[Element]:
        """Yield the transmissions of ROS 1 that no robot uses: in macros that are not called, and in other files."""
        for path in self.packages.files(*OF_XML):
            source = self.packages.read(path)
            root = root_of(source) if b"<transmission" in source.data else None
            for element in elements(root) if root is not None and root.tagName == "robot" else ():
                key = os.path.realpath(path), element.start
                known = key in self.by_element or key in self.inserted
                if element.tagName == "transmission" and not known and is_of_ros1(element):
                    yield element


def is_of_ros1(element: Element) -> bool:
    """Return whether a `<transmission>` is one of ROS 1: it is not in `<ros2_control>`, and names its type."""
    inside = any(above.tagName == "ros2_control" for above in ancestors(element))
    return not inside and any(each.tagName == "type" for each in element.elements())


def _calls(at: Place) -> Iterator[Call]:
    return at.call.chain() if at.call else iter(())


def unit_of(element: Element) -> Element:
    """Return the macro that an element is written in, or the root of its file."""
    root = element
    for above in ancestors(element):
        if above.tagName == MACRO:
            return above
        root = above
    return root


def is_known(text: str) -> bool:
    """Return whether a text of a robot is fully known."""
    return UNKNOWN not in text
