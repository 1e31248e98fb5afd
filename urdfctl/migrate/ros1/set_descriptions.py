"""Which of the descriptions that a launch file of ROS 1 sets is the one of a node: parameters are global there.

A parameter outlives the group that it is set in, the last one wins, and conditions decide which are set at all
(roslaunch/XML/param on wiki.ros.org). A node of ROS 2 has a description of its own.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.launch.actions import Text, parsed
from urdfctl.migrate.ros1.described import is_description, names_description
from urdfctl.migrate.ros1.description_commands import description_command
from urdfctl.migrate.ros1.roslaunch_values import around, namespace_of, root_around
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_DEFAULT = "robot_description"

Condition = tuple[str, bool]
"""The text of a condition, and whether it must be false."""


class SetDescription(NamedTuple):
    """A description that is set if its conditions hold."""

    command: Text
    conditions: tuple[Condition, ...]

    def when(self, condition: str, *, is_true: bool) -> SetDescription | None:
        """Return what is left of it if a condition is true or false; None if it is not set then."""
        if (condition, is_true) in self.conditions:
            return None
        return self._replace(conditions=tuple(one for one in self.conditions if one[0] != condition))


def descriptions_of(node: Element, names: Collection[str]) -> list[SetDescription]:
    """Return the descriptions that a robot_state_publisher may have, the last one of those that are set wins.

    names: the names of the parameters that are descriptions.
    """
    own = [one for one in node.elements() if is_description(one, names)]
    if own:
        return [SetDescription(description_command(one), ()) for one in own[-1:]]
    found = [SetDescription(description_command(one), tuple(_conditions(one, node))) for one in _in_scope(node, names)]
    for text, negated in _conditions(node, root_around(node)):
        left = [one.when(text, is_true=not negated) for one in found]
        found = [one for one in left if one is not None]
    last = max((index for index, one in enumerate(found) if not one.conditions), default=0)
    return found[last:]


def _in_scope(node: Element, names: Collection[str]) -> list[Element]:
    """The parameters that a node finds: those in its namespace, or in the nearest one above it."""
    every = [one for one in elements(root_around(node)) if is_description(one, names) and not _is_private(one)]
    wanted = read_by(node)
    every = [one for one in every if attribute(one, "name").rpartition("/")[2] == wanted] or every
    space = _parts(namespace_of(node))
    above = [(one, _parts(namespace_of(one))[:-1]) for one in every]
    above = [(one, parts) for one, parts in above if parts == space[: len(parts)]]
    if not above:
        chain = [id(one) for one in around(node)]
        return [one for one in every if id(one.parentNode) in chain]
    depth = max(len(parts) for _, parts in above)
    return [one for one, parts in above if len(parts) == depth]


def read_by(node: Element) -> str:
    """Return the name of the parameter that a robot_state_publisher reads, without its namespace."""
    return next((new for new in map(_new_name, node.elements()) if new), _DEFAULT)


def _new_name(child: Element) -> str:
    """The parameter that a node reads instead of robot_description, if a <remap> of it says so."""
    is_its = child.tagName == "remap" and names_description(parsed(attribute(child, "from")))
    return attribute(child, "to").rpartition("/")[2] if is_its else ""


def _parts(space: str) -> list[str]:
    return [part for part in space.split("/") if part]


def _is_private(element: Element) -> bool:
    return any(one.tagName == "node" for one in around(element))


def _conditions(element: Element, place: Element) -> Iterator[Condition]:
    """The conditions of an element and of the groups around it that are not around another place, too."""
    shared = {id(one) for one in (*around(place), *([] if element is place else [place]))}
    for one in (element, *around(element)):
        if id(one) not in shared:
            yield from ((one.attrs[name], name == "unless") for name in ("if", "unless") if name in one.attrs)


def is_overridden(element: Element, names: Collection[str]) -> bool:
    """Return whether a later parameter of the same name replaces a description whatever the conditions."""
    return any(not rest for rest in _later(element, names))


def overriding(element: Element, names: Collection[str]) -> list[Condition]:
    """Return the conditions under which a later parameter replaces a description, those of one condition only."""
    own = {(text, not negated) for text, negated in _conditions(element, root_around(element))}
    found = [rest[0] for rest in _later(element, names) if len(rest) == 1]
    return [one for one in dict.fromkeys(found) if one not in own]


def _later(element: Element, names: Collection[str]) -> Iterator[Sequence[Condition]]:
    every = [one for one in elements(root_around(element)) if is_description(one, names) and not _is_private(one)]
    later = every[next((index for index, one in enumerate(every) if one is element), len(every)) + 1 :]
    name = namespace_of(element)
    return (list(_conditions(one, element)) for one in later if namespace_of(one) == name)


def said(description: Sequence[SetDescription]) -> Text:
    """Return the command of the last description that is set."""
    chosen = [one for one in description if not one.conditions] or list(description)
    return chosen[-1].command if chosen else ()


def conditions_of(descriptions: Sequence[SetDescription]) -> list[str]:
    """Return the texts of the conditions of some descriptions, each once."""
    return list(dict.fromkeys(text for one in descriptions for text, _ in one.conditions))
