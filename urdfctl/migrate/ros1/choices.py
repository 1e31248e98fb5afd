"""Conditions inside of a node or an include of ROS 1: launch files of ROS 2 have them on whole actions only."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from urdfctl.migrate.launch.actions import Text, parsed
from urdfctl.migrate.ros1.roslaunch_values import around
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


class LoadedFile(NamedTuple):
    """A file that a <rosparam> around a node loads, and the conditions of that."""

    address: Text
    wanted: str | None = None
    unwanted: str | None = None

    @property
    def conditions(self) -> list[str]:
        """The texts of the conditions."""
        return [text for text in (self.wanted, self.unwanted) if text is not None]

    def when(self, condition: str, *, is_true: bool) -> LoadedFile | None:
        """Return what is left of it if a condition is true or false; None if it is not loaded then."""
        if condition == (self.unwanted if is_true else self.wanted):
            return None
        return self._replace(
            wanted=None if condition == self.wanted else self.wanted,
            unwanted=None if condition == self.unwanted else self.unwanted,
        )


def loaded_files(parent: Element) -> list[LoadedFile]:
    """Return the files that a launch file loads around what is in an element: also in groups beside it, which have no
    scope for parameters."""
    outside = (parent, *around(parent))
    found = []
    for one in (child for outer in outside for child in outer.elements()):
        if _loads(one):
            found.append(LoadedFile(parsed(one.attrs["file"]), one.attrs.get("if"), one.attrs.get("unless")))
        elif one.tagName == "group" and one not in outside and "ns" not in one.attrs:
            wanted, unwanted = one.attrs.get("if"), one.attrs.get("unless")
            inner = (each for each in one.elements() if _loads(each) and not {"if", "unless"} & each.attrs.keys())
            found += [LoadedFile(parsed(each.attrs["file"]), wanted, unwanted) for each in inner]
    return found


def _loads(element: Element) -> bool:
    return element.tagName == "rosparam" and "file" in element.attrs


def choices_in(element: Element) -> list[str]:
    """Return the texts of the conditions of what is in a node or an include, each once."""
    found = (child.attrs[name] for child in element.elements() for name in ("if", "unless") if name in child.attrs)
    return list(dict.fromkeys(found))


@contextmanager
def chosen(element: Element, condition: str, *, is_true: bool) -> Iterator[None]:
    """Return a context in which an element has only those children that a condition leaves, without that condition."""
    children = list(element.children())
    changed: list[tuple[Element, str]] = []
    for child in children:
        if isinstance(child, Element):
            for name, wanted in (("if", True), ("unless", False)):
                if child.attrs.get(name) == condition:
                    changed.append((child, name))
                    if is_true is not wanted:
                        element.removeChild(child)
    for child, name in changed:
        del child.attrs[name]
    try:
        yield
    finally:
        for child, name in changed:
            child.attrs[name] = condition
        for child in list(element.children()):
            element.removeChild(child)
        for child in children:
            element.appendChild(child)


@contextmanager
def without(element: Element, removed: Sequence[Element]) -> Iterator[None]:
    """Return a context in which an element lacks some of its children."""
    children = list(element.children())
    for one in removed:
        element.removeChild(one)
    try:
        yield
    finally:
        for child in list(element.children()):
            element.removeChild(child)
        for child in children:
            element.appendChild(child)
