"""Read MoveIt's files: the controllers in moveit_controllers.yaml (ROS 2), and the lists of joints (ROS 1)."""

from __future__ import annotations

from urdfctl.model.controllers import Key, MoveItController, MoveItList
from urdfctl.source.yaml import Mapping, Node, Scalar, Sequence, YamlFile

_MANAGER = "moveit_simple_controller_manager"
_REQUIRED = ("type", "action_ns", "joints")


def moveit_controllers(file: YamlFile) -> tuple[MoveItController, ...]:
    """Return the controllers in `controller_names` of MoveIt's simple controller manager, in order."""
    document = file.documents[0] if file.documents else None
    inner = document.get(_MANAGER) if isinstance(document, Mapping) else None
    names = inner.get("controller_names") if isinstance(inner, Mapping) else None
    if not isinstance(inner, Mapping) or not isinstance(names, Sequence):
        return ()
    return tuple(_described(item, inner) for item in names.items if isinstance(item, Scalar))


def moveit_lists(file: YamlFile, namespace: str) -> tuple[MoveItList, ...]:
    """Return the lists of joints in a file.

    These are the controllers of the simple or the fake controller manager, and the limits in
    `robot_description_planning`.

    namespace: the namespace that a launch file loads the file into.
    """
    document = file.documents[0] if file.documents else None
    if not isinstance(document, Mapping):
        return ()
    entries = document.get("controller_list")
    controllers = [item for item in entries.items if isinstance(item, Mapping)] if isinstance(entries, Sequence) else []
    lists = [MoveItList(_text(each.get("name")), tuple(_keys(each.get("joints")))) for each in controllers]
    limits = document.get("joint_limits") if namespace.endswith("_planning") else None
    if isinstance(limits, Mapping):
        lists.append(MoveItList(None, tuple(Key(entry.key.text, entry.key.at) for entry in limits.entries)))
    return tuple(lists)


def _text(node: Node | None) -> str:
    return node.text if isinstance(node, Scalar) else ""


def _described(name: Scalar, inner: Mapping) -> MoveItController:
    section = next((entry for entry in inner.entries if entry.key.text == name.text), None)
    settings = section.value if section and isinstance(section.value, Mapping) else None
    joints = settings.get("joints") if settings else None
    kind = settings.get("type") if settings else None
    lacking = tuple(key for key in _REQUIRED if settings is None or settings.get(key) is None)
    return MoveItController(
        name=Key(name.text, name.at),
        section=Key(section.key.text, section.key.at) if section else None,
        lacking=lacking,
        type=kind.text if isinstance(kind, Scalar) else None,
        joints=tuple(_keys(joints)),
        first=settings.entries[0].key.at if settings and settings.entries else None,
    )


def _keys(node: Node | None) -> list[Key]:
    items = node.items if isinstance(node, Sequence) else ()
    return [Key(item.text, item.at) for item in items if isinstance(item, Scalar)]
