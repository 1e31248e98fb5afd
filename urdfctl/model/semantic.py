"""The model of an SRDF file, which says which joints MoveIt plans for: groups, their states, and allowed collisions."""

from __future__ import annotations

from urdfctl.model.controllers import Key
from urdfctl.model.parts import Tag
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class Chain(NamedTuple):
    """A `<chain>` of a group: the joints between two links. A missing name is None."""

    base: Key | None
    tip: Key | None
    at: Place


class Group(NamedTuple):
    """A planning group.

    links, joints: those that it lists.
    groups: the names of the groups that it contains.
    """

    name: Key
    links: tuple[Key, ...] = ()
    joints: tuple[Key, ...] = ()
    chains: tuple[Chain, ...] = ()
    groups: tuple[Key, ...] = ()

    @property
    def is_empty(self) -> bool:
        """Whether it lists nothing."""
        return not (self.links or self.joints or self.chains or self.groups)


class GroupState(NamedTuple):
    """A named state of a group, with its joints."""

    name: str
    group: Key | None
    joints: tuple[Key, ...]


class EndEffector(NamedTuple):
    """An end effector: its group, the link that it is attached to, and the group of that link."""

    name: str
    group: Key | None
    parent_link: Key | None
    parent_group: Key | None


class VirtualJoint(NamedTuple):
    """A joint between the robot and the world.

    name: None if missing.
    child: the link of the robot that it moves.
    type: `fixed`, `planar` or `floating`.
    """

    name: Key | None
    child: Key | None
    type: str


class Semantic(NamedTuple):
    """An SRDF file.

    name: the robot's name; None if missing.
    at: the root element.
    pairs: the links of each `<disable_collisions>`.
    passive: the joints that no controller moves.
    complete: False if part of it could not be expanded.
    tag: the root element.
    """

    path: str
    name: Key | None
    at: Place
    groups: tuple[Group, ...] = ()
    states: tuple[GroupState, ...] = ()
    effectors: tuple[EndEffector, ...] = ()
    virtual: tuple[VirtualJoint, ...] = ()
    pairs: tuple[tuple[Key, Key], ...] = ()
    passive: tuple[Key, ...] = ()
    complete: bool = True
    tag: Tag | None = None

    def group(self, name: str) -> Group | None:
        """Return the first group with a name, if any."""
        return next((group for group in self.groups if group.name.text == name), None)
