"""The controllers that MoveIt sends trajectories to, as moveit_controllers.yaml of ROS 2 describes them, and the joints
that ROS 1's files list."""

from __future__ import annotations

from urdfctl.model.controllers import Key, MoveItController, MoveItList
from urdfctl.source.yaml import Mapping, Node, Scalar, Sequence, YamlFile

_MANAGER = "moveit_simple_controller_manager"
_NEEDED = ("type", "action_ns", "joints")


def moveit_controllers(file: YamlFile) -> tuple[MoveItController, ...]:
    """The controllers that are named for MoveIt's simple controller manager, in order."""
    document = file.documents[0] if file.documents else None
    inner = document.get(_MANAGER) if isinstance(document, Mapping) else None
    names = inner.get("controller_names") if isinstance(inner, Mapping) else None
    if not isinstance(inner, Mapping) or not isinstance(names, Sequence):
        return ()
    return tuple(_described(item, inner) for item in names.items if isinstance(item, Scalar))


def moveit_lists(file: YamlFile, namespace: str) -> tuple[MoveItList, ...]:
    """The lists of joints in a file that is loaded into a namespace: of the simple or the fake controller manager, and
    the limits of `robot_description_planning`."""
    document = file.documents[0] if file.documents else None
    if not isinstance(document, Mapping):
        return ()
    listed = document.get("controller_list")
    controllers = [item for item in listed.items if isinstance(item, Mapping)] if isinstance(listed, Sequence) else []
    found = [MoveItList(_text(one.get("name")), tuple(_keys(one.get("joints")))) for one in controllers]
    limits = document.get("joint_limits") if namespace.endswith("_planning") else None
    if isinstance(limits, Mapping):
        found.append(MoveItList(None, tuple(Key(entry.key.text, entry.key.at) for entry in limits.entries)))
    return tuple(found)


def _text(node: Node | None) -> str:
    return node.text if isinstance(node, Scalar) else ""


def _described(name: Scalar, inner: Mapping) -> MoveItController:
    section = next((entry for entry in inner.entries if entry.key.text == name.text), None)
    known = section.value if section and isinstance(section.value, Mapping) else None
    joints = known.get("joints") if known else None
    kind = known.get("type") if known else None
    lacking = tuple(key for key in _NEEDED if known is None or known.get(key) is None)
    return MoveItController(
        Key(name.text, name.at),
        Key(section.key.text, section.key.at) if section else None,
        lacking,
        kind.text if isinstance(kind, Scalar) else None,
        tuple(_keys(joints)),
        known.entries[0].key.at if known and known.entries else None,
    )


def _keys(node: Node | None) -> list[Key]:
    items = node.items if isinstance(node, Sequence) else ()
    return [Key(item.text, item.at) for item in items if isinstance(item, Scalar)]
