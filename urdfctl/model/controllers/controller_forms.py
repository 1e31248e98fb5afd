"""What the keys of a controller file show: the ROS generation that it is written for, and whether it is MoveIt's."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfctl.model.controllers.build_parameters import PARAMETERS_KEY
from urdfctl.model.controllers.controllers import ControllersFile, Key
from urdfctl.source.span import Place
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, YamlEntry, YamlFile

MANAGER = "controller_manager"
OF_OTHER_STACKS = ("package", "module")
"""Keys beside `type` of plugins that other programs load."""
_NULL = frozenset({"", "~", "null"})
_KEYS_OF_MOVEIT = frozenset(
    "controller_list controller_names moveit_controller_manager moveit_simple_controller_manager "
    "moveit_manage_controllers moveit_ros_control_interface trajectory_execution".split()
)
_DEEPEST = 6


def form_of(file: YamlFile) -> int | None:
    """Return the ROS generation that a file is written for, 1 or 2; None if unknown."""
    return _form(file)[0]


def types_in(file: YamlFile) -> Iterator[str]:
    """Yield the controller types of the form package/Class that a file names."""
    for entry in (entry for document in file.documents for entry in _entries(document)):
        kind = entry.value.get("type") if _is_typed(entry) and isinstance(entry.value, Mapping) else None
        if isinstance(kind, Scalar):
            yield kind.text


def _form(file: YamlFile) -> tuple[int | None, list[YamlEntry]]:
    """The ROS generation that a file is written for, and the entries that show it."""
    entries = [entry for document in file.documents for entry in _entries(document)]
    evidence = [entry for entry in entries if entry.key.text.startswith(PARAMETERS_KEY)]
    evidence = evidence or [entry for entry in entries if _is_of_a_manager(entry)]
    if evidence:
        return 2, evidence
    evidence = [entry for entry in entries if _is_typed(entry)]
    return 1 if evidence else None, evidence


def _entries(node: Node, depth: int = 0) -> Iterable[YamlEntry]:
    if not isinstance(node, Mapping) or depth > _DEEPEST:
        return
    for entry in node.entries:
        yield entry
        yield from _entries(entry.value, depth + 1)


def _is_of_a_manager(entry: YamlEntry) -> bool:
    return entry.key.text.rpartition("/")[2] == MANAGER and isinstance(entry.value, Mapping)


def _is_typed(entry: YamlEntry) -> bool:
    """Whether an entry is a ROS 1 controller: a map with a type of the form package/Class."""
    if not isinstance(entry.value, Mapping):
        return False
    kind = entry.value.get("type")
    is_of_another = any(entry.value.get(key) is not None for key in OF_OTHER_STACKS)
    return isinstance(kind, Scalar) and is_class(kind.text) and not is_of_another


def is_class(text: str) -> bool:
    """Return whether a text has the form package/Class."""
    package, slash, name = text.partition("/")
    return bool(slash and package and name) and "/" not in name and " " not in text


def controllers_file(file: YamlFile) -> ControllersFile:
    """Return what is known of a file before it is known which ROS generation reads it."""
    at = Place(file.source, 0, end=0)
    if not file.readable:
        return ControllersFile(file.source.path, at, None, readable=False)
    form, evidence = _form(file)
    keys = tuple(Key(entry.key.text, entry.key.at) for entry in evidence)
    top = {entry.key.text for document in file.documents if isinstance(document, Mapping) for entry in document.entries}
    is_moveit = form is None and bool(top & _KEYS_OF_MOVEIT)
    empty = all(isinstance(document, Scalar) and document.text in _NULL for document in file.documents)
    return ControllersFile(file.source.path, at, form, is_moveit=is_moveit, told_by=keys, empty=empty)
