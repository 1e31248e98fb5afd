"""Read MoveIt's YAML files: controllers, kinematics solvers, joint limits and planning pipelines."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Key, MoveItController, MoveItList
from urdfctl.model.moveit.moveit import JointLimits, Pipeline, Solver
from urdfctl.names import is_slip
from urdfctl.source.span import Place
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlEntry, YamlFile

_MANAGER = "moveit_simple_controller_manager"
PLUGIN = "moveit_controller_manager"
"""The parameter of ROS 2's move_group that names the plugin by which it reaches controllers."""
_REQUIRED = ("type", "action_ns", "joints")
_NULL = frozenset({"", "~", "null", "Null", "NULL"})
_PREFIXES = ("robot_description_kinematics", "robot_description_planning", "/**", "ros__parameters")
"""Keys that a file may have above what it configures."""
_DEEPEST = 16


def moveit_controllers(file: YamlFile) -> tuple[MoveItController, ...]:
    """Return the controllers of MoveIt's simple controller manager, in order: ROS 2's names, or ROS 1's list."""
    document = _document(file)
    listed = document.get("controller_list") if document else None
    if isinstance(listed, Sequence):
        return tuple(_of_list(item) for item in listed.items if isinstance(item, Mapping))
    inner = _manager(document)
    names = inner.get("controller_names") if inner else None
    if inner is None or not isinstance(names, Sequence):
        return ()
    return tuple(_described(item, inner) for item in names.items if isinstance(item, Scalar))


def empty_controller_list(file: YamlFile) -> Place | None:
    """Return the place of an empty list of controllers: ROS 1's controller_list, or ROS 2's controller_names.

    Or that of a misspelt key, so that MoveIt has no list.
    """
    document = _document(file)
    inner = _manager(document)
    for mapping, name in ((document, "controller_list"), (inner, "controller_names")):
        entry = _entry(mapping, name)
        if entry is not None and _is_empty(entry.value):
            return entry.key.at
    if inner is not None:
        return _misspelt(inner, "controller_names", Sequence)
    return _misspelt(document, _MANAGER, Mapping) or _misspelt(document, "controller_list", Sequence)


def plugin_of(file: YamlFile) -> tuple[Key, Key] | None:
    """Return the key, which may have one letter wrong, and the value of `moveit_controller_manager`; None if the file
    has no such key."""
    document = _document(file)
    right = _entry(document, PLUGIN)
    entries = (right,) if right else document.entries if document else ()
    for entry in entries:
        if isinstance(entry.value, Scalar) and (entry is right or is_slip(entry.key.text, PLUGIN)):
            return Key(entry.key.text, entry.key.at), Key(entry.value.text, entry.value.at)
    return None


def _misspelt(mapping: Mapping | None, name: str, kind: type[Mapping | Sequence]) -> Place | None:
    """The place of a key with a value of this kind that has one letter wrong, if the map does not have the name."""
    entries = mapping.entries if mapping else ()
    if any(entry.key.text == name for entry in entries):
        return None
    places = (entry.key.at for entry in entries if isinstance(entry.value, kind) and is_slip(entry.key.text, name))
    return next(places, None)


def unlisted_controllers(file: YamlFile) -> Iterator[Key]:
    """Yield the sections of controllers that controller_names does not list."""
    inner = _manager(_document(file))
    names = inner.get("controller_names") if inner else None
    listed = {item.text for item in names.items if isinstance(item, Scalar)} if isinstance(names, Sequence) else set()
    for entry in inner.entries if inner and listed else ():
        is_section = isinstance(entry.value, Mapping) and isinstance(entry.value.get("joints"), Sequence)
        if is_section and entry.key.text not in listed:
            yield Key(entry.key.text, entry.key.at)


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


def solvers_of(file: YamlFile) -> Iterator[Solver]:
    """Yield the groups in kinematics.yaml with their solvers."""
    document = _inside(_document(file))
    for entry in document.entries if document else ():
        if isinstance(entry.value, Mapping):
            solver = entry.value.get("kinematics_solver")
            key = Key(solver.text, solver.at) if isinstance(solver, Scalar) else None
            yield Solver(Key(entry.key.text, entry.key.at), key)


def limits_of(file: YamlFile) -> Iterator[JointLimits]:
    """Yield the joints in joint_limits.yaml with their limits."""
    document = _inside(_document(file))
    limits = document.get("joint_limits") if document else None
    for entry in limits.entries if isinstance(limits, Mapping) else ():
        if isinstance(entry.value, Mapping):
            pairs = ((Key(each.key.text, each.key.at), each.value) for each in entry.value.entries)
            values = tuple((key, value) for key, value in pairs if isinstance(value, Scalar))
            yield JointLimits(Key(entry.key.text, entry.key.at), values)


def pipeline_of(name: str, file: YamlFile) -> Pipeline | None:
    """Return the planning pipeline in a file; None if the file has no map."""
    document = _document(file)
    inner = document.get(name) if document else None
    settings = inner if isinstance(inner, Mapping) else document
    return Pipeline(name, settings) if settings else None


def empty_values(file: YamlFile) -> Iterator[tuple[str, Place]]:
    """Yield the empty lists and missing values in a file, each with its key and its place."""
    pending: list[tuple[Node, int]] = [(document, 0) for document in file.documents]
    while pending:
        node, depth = pending.pop()
        if isinstance(node, Mapping) and depth < _DEEPEST:
            for entry in node.entries:
                if _is_empty(entry.value):
                    yield entry.key.text, entry.key.at
                else:
                    pending.append((entry.value, depth + 1))


def _is_empty(node: Node) -> bool:
    if isinstance(node, Scalar):
        return not node.style and node.tag is None and node.text in _NULL
    return isinstance(node, Sequence) and not node.items


def _document(file: YamlFile) -> Mapping | None:
    document = file.documents[0] if file.documents else None
    return document if isinstance(document, Mapping) else None


def _inside(document: Mapping | None) -> Mapping | None:
    """The map below the keys that some files have above it."""
    for _ in range(len(_PREFIXES)):
        inner = next((document.get(name) for name in _PREFIXES if document and document.get(name)), None)
        if not isinstance(inner, Mapping):
            break
        document = inner
    return document


def _manager(document: Mapping | None) -> Mapping | None:
    """The settings of the simple controller manager; a launch file may add the key above them."""
    inner = document.get(_MANAGER) if document else None
    if isinstance(inner, Mapping):
        return inner
    return document if document and document.get("controller_names") is not None else None


def _entry(node: Node | None, name: str) -> YamlEntry | None:
    entries = node.entries if isinstance(node, Mapping) else ()
    return next((entry for entry in entries if entry.key.text == name), None)


def _text(node: Node | None) -> str:
    return node.text if isinstance(node, Scalar) else ""


def _of_list(item: Mapping) -> MoveItController:
    name = item.get("name")
    scalar = name if isinstance(name, Scalar) else None
    at = scalar.at if scalar else item.entries[0].key.at if item.entries else item.at
    return _controller(Key(_text(name), at), Key(_text(name), at), item, ("name", *_REQUIRED))


def _described(name: Scalar, inner: Mapping) -> MoveItController:
    section = _entry(inner, name.text)
    settings = section.value if section and isinstance(section.value, Mapping) else None
    key = Key(section.key.text, section.key.at) if section else None
    return _controller(Key(name.text, name.at), key, settings, _REQUIRED)


def _controller(
    name: Key, section: Key | None, settings: Mapping | None, required: tuple[str, ...]
) -> MoveItController:
    joints = settings.get("joints") if settings else None
    kind = settings.get("type") if settings else None
    action = settings.get("action_ns") if settings else None
    lacking = tuple(key for key in required if settings is None or settings.get(key) is None)
    return MoveItController(
        name=name,
        section=section,
        lacking=lacking,
        type=kind.text if isinstance(kind, Scalar) else None,
        joints=tuple(_keys(joints)),
        first=settings.entries[0].key.at if settings and settings.entries else None,
        action=Key(action.text, action.at) if isinstance(action, Scalar) else None,
        type_at=kind.at if isinstance(kind, Scalar) else None,
        joints_at=joints.at if joints is not None else None,
    )


def _keys(node: Node | None) -> list[Key]:
    items = node.items if isinstance(node, Sequence) else ()
    return [Key(item.text, item.at) for item in items if isinstance(item, Scalar)]
