"""Tags without the prefix `xacro:`: which they are, and how they were read from indigo to melodic.

Until melodic, xacro's check_deprecated_tag() accepted its tags without the prefix and warned, and handle_macro_call()
looked up every tag among the macros. Since noetic the prefix is required.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Cloning, Element
from urdfctl.source.xml.parsing import parse

_DIRECTIVES = frozenset("arg attribute call element if include insert_block macro property unless".split())
_NEEDED = {"include": "filename", "if": "value", "unless": "value"}
"""Attributes without which a tag is not xacro's, but for example SDFormat's."""
_OF_URDF = frozenset(
    "actuator axis box calibration capsule child collision color command_interface contact cylinder dynamics gazebo "
    "geometry gpio group hardware hardwareInterface inertia inertial joint limit link mass material "
    "mechanicalReduction mesh mimic offset origin param parent plugin robot role ros2_control safety_controller sensor "
    "sphere state_interface texture transmission type verbose visual".split()
)
_OF_ROBOT = frozenset(
    "gazebo gpio group hardware joint link material param plugin robot ros2_control sensor transmission verbose".split()
)
"""Elements that belong into <robot>, or that some program reads there."""
ANYTHING_GOES = frozenset({"gazebo", "sensor", "plugin"})


def is_call(element: Element, macros: Collection[str]) -> bool:
    """Return whether a tag without the prefix calls a macro.

    A tag with the name of one of URDF's elements does so where that element does not belong: `<axis>` in <robot>.
    """
    name = element.tagName
    if name not in macros or name in _DIRECTIVES:
        return False
    parent = element.parentNode
    is_in_root = isinstance(parent, Element) and parent.tagName == "robot"
    return name not in _OF_URDF or (is_in_root and name not in _OF_ROBOT)


def lacks_prefix(element: Element, macros: Collection[str]) -> bool:
    """Return whether an element is a xacro tag, or a macro call, without the prefix."""
    name = element.tagName
    if name in _DIRECTIVES:
        return _NEEDED.get(name, "") in ("", *element.attrs)
    return is_call(element, macros)


def add_prefixes(root: Element) -> None:
    """Give all xacro tags below an element the prefix, but not macro calls, whose names are not known yet."""
    for element in list(_all_unprefixed(root, ())):
        element.tagName = element.nodeName = f"xacro:{element.tagName}"


def missing_prefixes(sources: Iterable[SourceText], macros: Collection[str]) -> Iterator[Problem]:
    """Yield one problem for each file with tags that lack the prefix."""
    for source in sources:
        try:
            root = parse(source, Cloning()).documentElement
        except ReadError:
            continue
        found = sorted(_all_unprefixed(root, macros), key=lambda element: element.start) if root is not None else []
        if found:
            yield without_prefix(found[0], found[1:], macros)


def without_prefix(element: Element, others: Collection[Element], macros: Collection[str]) -> Problem:
    """Return the problem of a tag without the prefix, and of others in the same file."""
    name = element.tagName
    what = f"macro call <{name}>" if name in macros else f"<{name}>"
    more = f"; {len(others)} more in this file" if others else ""
    message = f"{what} needs the prefix: <xacro:{name}>. Without it xacro copies it unchanged{more}"
    hint = f"add the prefix 'xacro:' to {len(others) + 1} tags" if others else f"write <xacro:{name}>"
    also = tuple(other.at for other in others)
    return Problem(ProblemKind.PREFIX_MISSING, element.at, message, name, hint, also=also)


def _all_unprefixed(root: Element, macros: Collection[str]) -> Iterator[Element]:
    pending = root.elements()
    while pending:
        element = pending.pop()
        if lacks_prefix(element, macros):
            yield element
        if element.tagName not in ANYTHING_GOES:
            pending += element.elements()
