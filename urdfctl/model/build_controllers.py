"""Builds the model of controllers from YAML files: which controllers, of which type, with which parameters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from urdfctl.model.build_parameters import PARAMETERS_KEY, Flat, Leaf, parameters_of, read_by_rcl, read_by_rosparam
from urdfctl.model.controllers import (
    Controller,
    Controllers,
    ControllersFile,
    FileReference,
    Key,
    Manager,
    Section,
)
from urdfctl.model.parameters import Kind, Parameters, Value
from urdfctl.record import NamedTuple
from urdfctl.source.span import Place
from urdfctl.source.yaml import Entry, Mapping, Node, Scalar, YamlFile

MANAGER = "controller_manager"
_OF_MOVEIT = frozenset(
    "controller_list controller_names moveit_controller_manager moveit_simple_controller_manager "
    "moveit_manage_controllers moveit_ros_control_interface trajectory_execution".split()
)
_READ_OF_A_DECLARATION = frozenset({"type", "params_file", "fallback_controllers"})
_SETTINGS_OF_A_MANAGER = frozenset(
    "defaults diagnostics hardware_components_initial_state hardware_synchronization overruns qos_overrides".split()
)
_DEEPEST = 6


class Loaded(NamedTuple):
    """A YAML file, and the namespace that a launch file loads it into."""

    yaml: YamlFile
    namespace: str = ""


def controllers_of(
    files: Iterable[Loaded],
    ros: int | None,
    started: Sequence[str] | None = None,
    references: Iterable[FileReference] = (),
) -> Controllers:
    """The model of all files together, as a generation of ROS reads them; of each by its own form where it is not
    known. `started` names controllers that are there though no file may say so."""
    read, flat = [], Flat([], [], [])
    for loaded in files:
        file = _file(loaded.yaml)
        generation = ros or file.form
        if file.readable and not file.is_moveit and generation is not None:
            parts = tuple(part for part in loaded.namespace.split("/") if part)
            one = read_by_rcl(loaded.yaml) if generation == 2 else read_by_rosparam(loaded.yaml, parts)  # noqa: PLR2004
            file = file._replace(faults=tuple(one.faults))
            flat.sections.extend(one.sections)
            if file.form != 2:  # noqa: PLR2004 (ROS 1 finds nothing where it looks in such a file)
                flat.leaves.extend(one.leaves)
        read.append(file)
    made = _Ros2(flat.sections, started or ()).made() if flat.sections or ros == 2 else _Made([], [], [])  # noqa: PLR2004
    if flat.leaves or ros == 1:
        made = made.plus(_Ros1(flat.leaves, started or ()).made())
    return Controllers(
        tuple(read), tuple(made.managers), tuple(made.controllers), tuple(made.others), tuple(references)
    )


class _Made(NamedTuple):
    managers: list[Manager]
    controllers: list[Controller]
    others: list[Section]

    def plus(self, other: _Made) -> _Made:
        return _Made(self.managers + other.managers, self.controllers + other.controllers, self.others + other.others)


# -- which form a file has -------------------------------------------------------------------------------------------


def form_of(file: YamlFile) -> int | None:
    """1 or 2 for the generation of ROS that a file is written for; None where nothing in it tells."""
    return _form(file)[0]


def _form(file: YamlFile) -> tuple[int | None, list[Entry]]:
    """The generation, and the entries that tell it."""
    entries = [entry for document in file.documents for entry in _entries(document)]
    telling = [entry for entry in entries if entry.key.text.startswith(PARAMETERS_KEY)]
    telling = telling or [entry for entry in entries if _is_of_a_manager(entry)]
    if telling:
        return 2, telling
    telling = [entry for entry in entries if _is_typed(entry)]
    return 1 if telling else None, telling


def _entries(node: Node, depth: int = 0) -> Iterable[Entry]:
    if not isinstance(node, Mapping) or depth > _DEEPEST:
        return
    for entry in node.entries:
        yield entry
        yield from _entries(entry.value, depth + 1)


def _is_of_a_manager(entry: Entry) -> bool:
    return entry.key.text.rpartition("/")[2] == MANAGER and isinstance(entry.value, Mapping)


def _is_typed(entry: Entry) -> bool:
    """Whether a key with its value is a controller of ROS 1: a map with a type of the form package/Class."""
    if not isinstance(entry.value, Mapping):
        return False
    kind = entry.value.get("type")
    return isinstance(kind, Scalar) and _is_class(kind.text)


def _is_class(text: str) -> bool:
    package, slash, name = text.partition("/")
    return bool(slash and package and name) and "/" not in name and " " not in text


def _file(file: YamlFile) -> ControllersFile:
    at = Place(file.source, 0, end=0)
    if not file.readable:
        return ControllersFile(file.source.path, at, None, readable=False)
    form, telling = _form(file)
    told_by = tuple(Key(entry.key.text, entry.key.at) for entry in telling)
    top = {entry.key.text for document in file.documents if isinstance(document, Mapping) for entry in document.entries}
    is_moveit = form is None and bool(top & _OF_MOVEIT)
    return ControllersFile(file.source.path, at, form, is_moveit=is_moveit, told_by=told_by)


# -- ROS 2 -----------------------------------------------------------------------------------------------------------


class _Ros2:
    def __init__(self, sections: Iterable[Section], started: Sequence[str]) -> None:
        by_path: dict[str, list[Section]] = {}
        for section in sections:  # rcl keeps a node where it met it first, and adds to it
            by_path.setdefault(section.path, []).append(section)
        self.sections = [_joined(same) for same in by_path.values()]
        self.started = started

    def made(self) -> _Made:
        managers = self._managers()
        controllers = [
            self._controller(name, manager.namespace, manager)
            for manager in managers
            for name in self._declared(manager)
        ]
        controllers += self._typed_elsewhere(controllers)
        controllers = [placed for controller in controllers for placed in self._placed(controller)]
        known = {name for controller in controllers for name in (controller.name, controller.full_name.lstrip("/"))}
        controllers += [self._missing(name, managers) for name in self.started if name.lstrip("/") not in known]
        used = {section.path for manager in managers for section in manager.sections}
        used |= {section.path for controller in controllers for section in controller.sections}
        others = [s for s in self.sections if s.path not in used and not s.is_shared]
        return _Made(managers, controllers, others)

    def _placed(self, controller: Controller) -> list[Controller]:
        """A controller in each namespace that it is started in, where the files leave open which."""
        if controller.namespace is not None:
            return [controller]
        full = [name for name in self.started if name.startswith("/") and name.rpartition("/")[2] == controller.name]
        placed = [self._controller(controller.name, name.rpartition("/")[0], controller.manager) for name in full]
        return placed or [controller]

    def _missing(self, name: str, managers: Sequence[Manager]) -> Controller:
        """A controller that is started, and that no file declares: of the manager in its namespace."""
        namespace, slash, last = name.rpartition("/")
        if slash and name.startswith("/"):
            manager = next((manager for manager in managers if manager.namespace in {namespace, None}), None)
            return self._controller(last, namespace, manager)
        only = managers[0] if len(managers) == 1 else None
        return self._controller(name, only.namespace if only else None, only)

    def _managers(self) -> list[Manager]:
        named: dict[str | None, Section] = {}
        for section in self.sections:
            if not section.is_shared and _is_manager(section):
                named.setdefault(section.namespace, section)
        if not named:
            shared = next((s for s in self.sections if s.is_shared and _declares(s.parameters)), None)
            return [self._manager(MANAGER, None, shared.at)] if shared else []
        return [self._manager(section.name, namespace, section.at) for namespace, section in named.items()]

    def _manager(self, name: str, namespace: str | None, at: Place) -> Manager:
        reaching, own, naming = self._reaching(name, namespace)
        return Manager(name, namespace, at, reaching, own, naming)

    def _reaching(self, name: str, namespace: str | None) -> tuple[Parameters, Parameters, tuple[Section, ...]]:
        """All parameters of a node, those of sections that name it, and those sections."""
        node = name if namespace is None else f"{namespace}/{name}"
        speaking = [section for section in self.sections if section.names(node)]
        naming = tuple(section for section in speaking if not section.is_shared)
        return _together(speaking), _together(naming), naming

    def _declared(self, manager: Manager) -> list[str]:
        """The names of a manager's controllers, in order: maps with a type, or with a section of their own."""
        sections = {section.name for section in self.sections if section not in manager.sections}
        names = []
        for child in manager.parameters.below():
            if child.value.kind is not Kind.MAP or child.name in _SETTINGS_OF_A_MANAGER:
                continue
            typed = f"{child.name}.type" in manager.parameters
            if typed or child.name in sections or child.name in self.started:
                names.append(child.name)
        return names

    def _typed_elsewhere(self, known: Iterable[Controller]) -> list[Controller]:
        """The controllers whose own section gives their type, as the spawner of newer distros reads it."""
        used = {section.path for controller in known for section in controller.sections}
        found = []
        for section in self.sections:
            kind = section.parameters.value("type")
            is_type = kind is not None and kind.kind is Kind.STRING and _is_class(kind.text)
            if is_type and section.path not in used and not section.is_shared:
                found.append(self._controller(section.name, section.namespace, None))
        return found

    def _controller(self, name: str, namespace: str | None, manager: Manager | None) -> Controller:
        reaching, own, sections = self._reaching(name.rpartition("/")[2], namespace)
        declared = manager.parameters.get(name) if manager else None
        under = manager.parameters.under(name) if manager else Parameters()
        at = declared.key if declared else sections[0].at if sections else None
        left = Parameters(p for p in under if p.name.partition(".")[0] not in _READ_OF_A_DECLARATION)
        files = under.value("params_file")
        return Controller(
            name.rpartition("/")[2],
            namespace,
            under.value("type") or own.value("type"),
            at,
            reaching,
            own,
            sections,
            left,
            (files.items or (files,)) if files else (),
            manager,
        )


def _joined(sections: Sequence[Section]) -> Section:
    return sections[0] if len(sections) == 1 else sections[0]._replace(parameters=_together(sections))


def _together(sections: Iterable[Section]) -> Parameters:
    return Parameters(parameter for section in sections for parameter in section.parameters)


def _declares(parameters: Parameters) -> bool:
    """Whether a map with a type of the form package/Class stands at the top of some parameters."""
    kinds = (parameters.value(f"{child.name}.type") for child in parameters.below())
    return any(kind is not None and kind.kind is Kind.STRING and _is_class(kind.text) for kind in kinds)


def _is_manager(section: Section) -> bool:
    """A manager by its name; under a name of its own, by a rate and controllers."""
    if section.name == MANAGER:
        return True
    return "update_rate" in section.parameters and _declares(section.parameters)


# -- ROS 1 -----------------------------------------------------------------------------------------------------------


class _Ros1:
    def __init__(self, leaves: Iterable[Leaf], started: Sequence[str]) -> None:
        self.leaves: dict[tuple[str, ...], Leaf] = {}
        for leaf in leaves:
            known = self.leaves.get(leaf.path)
            if known is None or known.value.kind is not Kind.MAP or leaf.value.kind is not Kind.MAP:
                self.leaves[leaf.path] = leaf
        self.children: dict[tuple[str, ...], list[tuple[str, ...]]] = {}
        for path in self.leaves:
            self.children.setdefault(path[:-1], []).append(path)
        self.started = [(name.startswith("/"), tuple(part for part in name.split("/") if part)) for name in started]

    def made(self) -> _Made:
        controllers: list[Controller] = []
        others: list[Section] = []
        inside: set[tuple[str, ...]] = set()
        holders = {path[:length] for path in self._controllers() for length in range(len(path))}
        for path, leaf in self.leaves.items():
            if leaf.value.kind is not Kind.MAP or any(path[:n] in inside for n in range(1, len(path))):
                continue
            if self._is_controller(path):
                controllers.append(self._controller(path, leaf))
                inside.add(path)
            elif path not in holders:
                others.append(self._section(path, leaf))
                inside.add(path)
        found = {(*_parts(controller.namespace), controller.name) for controller in controllers}
        controllers += [
            _missing("/" * full + "/".join(name))
            for full, name in self.started
            if not any(_is_meant(path, name, full=full) for path in found)
        ]
        return _Made([], controllers, others)

    def _controllers(self) -> list[tuple[str, ...]]:
        return [path for path, leaf in self.leaves.items() if leaf.value.kind is Kind.MAP and self._is_controller(path)]

    def _is_controller(self, path: tuple[str, ...]) -> bool:
        if any(_is_meant(path, name, full=full) for full, name in self.started):
            return True
        kind = self._type(path)
        return (
            kind is not None and kind.kind is Kind.STRING and (_is_class(kind.text) or kind.text.endswith("Controller"))
        )

    def _type(self, path: tuple[str, ...]) -> Value | None:
        leaf = self.leaves.get((*path, "type"))
        return leaf.value if leaf else None

    def _section(self, path: tuple[str, ...], leaf: Leaf) -> Section:
        return Section("/".join(path), leaf.key, parameters_of(self._below(path), len(path)))

    def _below(self, path: tuple[str, ...]) -> Iterator[Leaf]:
        for child in self.children.get(path, ()):
            yield self.leaves[child]
            yield from self._below(child)

    def _controller(self, path: tuple[str, ...], leaf: Leaf) -> Controller:
        section = self._section(path, leaf)
        parameters = section.parameters
        return Controller(
            section.name, section.namespace, self._type(path), leaf.key, parameters, parameters, (section,)
        )


def _parts(namespace: str | None) -> tuple[str, ...]:
    return tuple(part for part in (namespace or "").split("/") if part)


def _is_meant(path: tuple[str, ...], name: tuple[str, ...], *, full: bool) -> bool:
    """Whether a name that is started means a path: all of it where it is a full name."""
    return path == name if full else path[-len(name) :] == name


def _missing(name: str) -> Controller:
    """A controller that is started, and in no file."""
    namespace, slash, last = name.rpartition("/")
    known = f"/{namespace.strip('/')}" if namespace.strip("/") else "" if name.startswith("/") else None
    return Controller(last, known if slash else None, None, None, Parameters(), Parameters())
