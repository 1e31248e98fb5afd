"""Build the model of an SRDF file from its tree. Names are trimmed, as srdfdom does."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Key
from urdfctl.model.moveit.moveit import Chain, EndEffector, Group, GroupState, Semantic, VirtualJoint
from urdfctl.model.robot import Tag
from urdfctl.source.xml.dom import Element


def semantic_of(root: Element, path: str, *, complete: bool = True) -> Semantic | None:
    """Return the model of an SRDF file; None if its root element is not <robot>.

    complete: False if part of the file could not be expanded.
    """
    if root.tagName != "robot":
        return None
    pairs = ((_key(each, "link1"), _key(each, "link2")) for each in _named(root, "disable_collisions"))
    return Semantic(
        path=path,
        name=_key(root, "name"),
        at=root.at,
        groups=tuple(_groups(root)),
        states=tuple(_states(root)),
        effectors=tuple(_effectors(root)),
        virtual=tuple(
            VirtualJoint(_key(each, "name"), _key(each, "child_link"), each.attrs.get("type", "").strip().lower())
            for each in _named(root, "virtual_joint")
        ),
        pairs=tuple((one, other) for one, other in pairs if one and other),
        passive=tuple(_keys(root, "passive_joint")),
        complete=complete,
        tag=Tag(root),
    )


def _groups(root: Element) -> Iterator[Group]:
    for element in _named(root, "group"):
        name = _key(element, "name")
        if name is not None:
            yield Group(
                name=name,
                links=tuple(_keys(element, "link")),
                joints=tuple(_keys(element, "joint")),
                chains=tuple(
                    Chain(_key(each, "base_link"), _key(each, "tip_link"), each.at) for each in _named(element, "chain")
                ),
                groups=tuple(_keys(element, "group")),
            )


def _states(root: Element) -> Iterator[GroupState]:
    for element in _named(root, "group_state"):
        joints = tuple(_keys(element, "joint"))
        yield GroupState(element.attrs.get("name", "").strip(), _key(element, "group"), joints)


def _effectors(root: Element) -> Iterator[EndEffector]:
    for element in _named(root, "end_effector"):
        yield EndEffector(
            name=element.attrs.get("name", "").strip(),
            group=_key(element, "group"),
            parent_link=_key(element, "parent_link"),
            parent_group=_key(element, "parent_group"),
        )


def _named(parent: Element, tag: str) -> Iterator[Element]:
    return (element for element in parent.elements() if element.tagName == tag)


def _keys(parent: Element, tag: str) -> Iterator[Key]:
    keys = (_key(element, "name") for element in _named(parent, tag))
    return (key for key in keys if key is not None)


def _key(element: Element, attribute: str) -> Key | None:
    text = element.attrs.get(attribute)
    return None if text is None else Key(text.strip(), element.at[attribute])
