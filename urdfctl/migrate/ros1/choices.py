"""Conditions inside of a node or an include of ROS 1: launch files of ROS 2 have them on whole actions only."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from urdfctl.source.xml.dom import Element


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
