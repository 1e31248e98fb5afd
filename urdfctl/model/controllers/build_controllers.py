"""Build the model of controllers from YAML files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from urdfctl.model.controllers.build_parameters import (
    Flat,
    Leaf,
    parameters_of,
    read_by_rcl,
    read_by_rosparam,
    tag_faults,
    with_names_of_elements,
)
from urdfctl.model.controllers.controller_forms import MANAGER, OF_OTHER_STACKS, controllers_file, is_class
from urdfctl.model.controllers.controllers import (
    Controller,
    Controllers,
    FileReference,
    Manager,
    Section,
)
from urdfctl.model.controllers.parameters import Parameters, Value, ValueKind
from urdfctl.source.span import Place
from urdfctl.source.yaml.tree import YamlFile
from urdfctl.startup.records import NamedTuple

_READ_OF_A_DECLARATION = frozenset({"type", "params_file", "fallback_controllers"})
_SETTINGS_OF_A_MANAGER = frozenset(
    "defaults diagnostics hardware_components_initial_state hardware_synchronization overruns qos_overrides".split()
)
_COMBINED = "robot_hardware"


class Loaded(NamedTuple):
    """A YAML file and the namespace that a launch file loads it into.

    of_other: it is for a node that manages no controllers.
    inline: it is a part of a launch file.
    """

    yaml: YamlFile
    namespace: str = ""
    of_other: bool = False
    inline: bool = False


def controllers_of(
    files: Iterable[Loaded],
    ros: int | None,
    started: Sequence[str] | None = None,
    references: Iterable[FileReference] = (),
    nodes: Iterable[str] = (),
) -> Controllers:
    """Return the combined model of several files.

    ros: the ROS generation that reads the files, 1 or 2; None to read each file by its own form.
    started: controllers that are started, even if no file declares them; None if unknown.
    references: the references to the files.
    nodes: the names of other nodes to look for, in ROS 2.
    """
    controllers_files, flat = [], Flat([], [], [])
    for loaded in files:
        file = controllers_file(loaded.yaml)
        generation = ros or file.form
        if file.readable and not (file.is_moveit or loaded.of_other) and generation is not None:
            prefix = _parts_of(loaded.namespace)
            content = read_by_rcl(loaded.yaml) if generation == 2 else read_by_rosparam(loaded.yaml, prefix)  # noqa: PLR2004
            file = file._replace(faults=tuple(content.faults))
            flat.sections.extend(content.sections)
            if file.form != 2:  # noqa: PLR2004 (in a file for ROS 2, ROS 1 finds none of its parameters)
                flat.leaves.extend(content.leaves)
        elif file.readable:
            file = file._replace(faults=tuple(tag_faults(loaded.yaml)))
        if not loaded.inline:
            controllers_files.append(file)
    parts = _Parts([], [], [])
    others: list[Controller] = []
    if flat.sections or ros == 2:  # noqa: PLR2004
        ros2 = _Ros2(flat.sections, started or ())
        parts, others = ros2.parts(), [node for name in nodes for node in ros2.nodes(name)]
        defined = {node.name for node in others}
        parts = parts._replace(others=[section for section in parts.others if section.name not in defined])
    if flat.leaves or ros == 1:
        parts = parts.plus(_Ros1(flat.leaves, started or ()).parts())
    return Controllers(
        tuple(controllers_files),
        tuple(parts.managers),
        tuple(parts.controllers),
        tuple(parts.others),
        tuple(references),
        nodes=tuple(others),
        shared=tuple(parts.shared),
    )


class _Parts(NamedTuple):
    managers: list[Manager]
    controllers: list[Controller]
    others: list[Section]
    shared: Sequence[Section] = ()

    def plus(self, other: _Parts) -> _Parts:
        return self._replace(
            managers=self.managers + other.managers,
            controllers=self.controllers + other.controllers,
            others=self.others + other.others,
        )


# -- ROS 2 -----------------------------------------------------------------------------------------------------------


class _Ros2:
    def __init__(self, sections: Iterable[Section], started: Sequence[str]) -> None:
        by_path: dict[str, list[Section]] = {}
        for section in sections:  # rcl keeps a node at its first position, and adds later parameters to it
            by_path.setdefault(section.path, []).append(section)
        self.sections = [_joined(same) for same in by_path.values()]
        self.started = started
        self._are_started = set(started)
        self._full_names: dict[str, list[str]] = {}
        for name in started:
            if name.startswith("/"):
                self._full_names.setdefault(name.rpartition("/")[2], []).append(name)
        self._by_path: dict[str, list[int]] = {}
        self._by_name: dict[str, list[int]] = {}
        self._patterns: list[int] = []
        self._shared: list[int] = []
        for number, section in enumerate(self.sections):
            self._by_path.setdefault("/" + section.path.lstrip("/"), []).append(number)
            self._by_name.setdefault(section.name, []).append(number)
            self._patterns += [number] if section.is_pattern else []
            self._shared += [number] if section.is_shared else []

    def parts(self) -> _Parts:
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
        others = [section for section in self.sections if section.path not in used and not section.is_shared]
        return _Parts(managers, controllers, others, [section for section in self.sections if section.is_shared])

    def nodes(self, name: str) -> list[Controller]:
        """Return the nodes of a name, one for each section that names it; from wildcards if none does."""
        same = [self.sections[number] for number in self._by_name.get(name, ())]
        naming = [section for section in same if not section.is_shared]
        if not naming and self._shared:
            return [self._controller(name, None, None)]
        return [self._controller(name, section.namespace, None) for section in naming]

    def _placed(self, controller: Controller) -> list[Controller]:
        """The controller in each namespace that it is started in, if the files do not name its namespace."""
        if controller.namespace is not None:
            return [controller]
        names = self._full_names.get(controller.name, ())
        placed = [self._controller(controller.name, name.rpartition("/")[0], controller.manager) for name in names]
        return placed or [controller]

    def _missing(self, name: str, managers: Sequence[Manager]) -> Controller:
        """A controller that is started, but that no file declares; its manager is the one in its namespace."""
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
            declaring = (section for section in self.sections if section.is_shared and _declares(section.parameters))
            shared = next(declaring, None)
            return [self._manager(MANAGER, None, shared.at)] if shared else []
        return [self._manager(section.name, namespace, section.at) for namespace, section in named.items()]

    def _manager(self, name: str, namespace: str | None, at: Place) -> Manager:
        parameters, own, naming = self._parameters(name, namespace)
        return Manager(name=name, namespace=namespace, at=at, parameters=parameters, own=own, sections=naming)

    def _parameters(self, name: str, namespace: str | None) -> tuple[Parameters, Parameters, tuple[Section, ...]]:
        """All parameters of a node, the parameters from sections that name it, and these sections."""
        node = name if namespace is None else f"{namespace}/{name}"
        applying = self._applying(node)
        naming = tuple(section for section in applying if not section.is_shared)
        return _combined(applying), _combined(naming), naming

    def _applying(self, node: str) -> list[Section]:
        """The sections that apply to a node, see Section.names, in order."""
        if node.startswith("/"):
            numbers = {number for number in self._patterns if self.sections[number].names(node)}
            numbers.update(number for number in self._by_path.get(node, ()) if not self.sections[number].is_pattern)
        else:
            numbers = {*self._shared, *self._by_name.get(node, ())}
        return [self.sections[number] for number in sorted(numbers)]

    def _declared(self, manager: Manager) -> list[str]:
        """The names of a manager's controllers, in order: maps with a type or a section of their own, or started."""
        of_manager = {section.path for section in manager.sections}
        sections = {section.name for section in self.sections if section.path not in of_manager}
        names = []
        for child in manager.parameters.below():
            if child.value.kind is not ValueKind.MAP or child.name in _SETTINGS_OF_A_MANAGER:
                continue
            typed = f"{child.name}.type" in manager.parameters
            if typed or child.name in sections or child.name in self._are_started:
                names.append(child.name)
        return names

    def _typed_elsewhere(self, known: Iterable[Controller]) -> list[Controller]:
        """The controllers with a type in their own section, where the spawner of newer distros reads it."""
        used = {section.path for controller in known for section in controller.sections}
        controllers = []
        for section in self.sections:
            kind = section.parameters.value("type")
            is_type = kind is not None and kind.kind is ValueKind.STRING and is_class(kind.text)
            is_type = is_type and not any(key in section.parameters for key in OF_OTHER_STACKS)
            if is_type and section.path not in used and not section.is_shared:
                controllers.append(self._controller(section.name, section.namespace, None))
        return controllers

    def _controller(self, name: str, namespace: str | None, manager: Manager | None) -> Controller:
        parameters, own, sections = self._parameters(name.rpartition("/")[2], namespace)
        declaration = manager.parameters.get(name) if manager else None
        under = manager.parameters.under(name) if manager else Parameters()
        at = declaration.key if declaration else sections[0].at if sections else None
        unread = Parameters(each for each in under if each.name.partition(".")[0] not in _READ_OF_A_DECLARATION)
        files = under.value("params_file")
        return Controller(
            name=name.rpartition("/")[2],
            namespace=namespace,
            type=under.value("type") or own.value("type"),
            declared_at=at,
            parameters=parameters,
            own=own,
            sections=sections,
            under_manager=unread,
            parameter_files=(files.items or (files,)) if files else (),
            manager=manager,
        )


def _joined(sections: Sequence[Section]) -> Section:
    return sections[0] if len(sections) == 1 else sections[0]._replace(parameters=_combined(sections))


def _combined(sections: Iterable[Section]) -> Parameters:
    return Parameters(parameter for section in sections for parameter in section.parameters)


def _declares(parameters: Parameters) -> bool:
    """Whether the top-level parameters contain a map with a type of the form package/Class."""
    own = [
        each for each in parameters.below() if not any(f"{each.name}.{key}" in parameters for key in OF_OTHER_STACKS)
    ]
    kinds = (parameters.value(f"{child.name}.type") for child in own)
    return any(kind is not None and kind.kind is ValueKind.STRING and is_class(kind.text) for kind in kinds)


def _is_manager(section: Section) -> bool:
    """Whether a section is a manager's: by its name, or because it has an update rate and declares controllers."""
    if section.name == MANAGER:
        return True
    return "update_rate" in section.parameters and _declares(section.parameters)


# -- ROS 1 -----------------------------------------------------------------------------------------------------------


class _Ros1:
    def __init__(self, leaves: Iterable[Leaf], started: Sequence[str]) -> None:
        self.leaves: dict[tuple[str, ...], Leaf] = {}
        for leaf in leaves:
            if not leaf.path:  # the key "/": the root, which is no parameter
                continue
            known = self.leaves.get(leaf.path)
            if known is None or known.value.kind is not ValueKind.MAP or leaf.value.kind is not ValueKind.MAP:
                self.leaves[leaf.path] = leaf
        self.hardware = {(*path[:-1], name) for path in self.leaves for name in self._hardware(path)}
        self.children: dict[tuple[str, ...], dict[tuple[str, ...], None]] = {}
        for path in self.leaves:  # a key `left/elbow` leaves its parent out
            for length in range(len(path), 0, -1):
                self.children.setdefault(path[: length - 1], {}).setdefault(path[:length])
                if path[: length - 1] in self.leaves:
                    break
        self.started = [(name.startswith("/"), tuple(part for part in name.split("/") if part)) for name in started]
        self._started_by_end: dict[tuple[str, ...], list[tuple[bool, tuple[str, ...]]]] = {}
        for full, parts in self.started:
            self._started_by_end.setdefault(parts[-1:], []).append((full, parts))

    def parts(self) -> _Parts:
        controllers: list[Controller] = []
        others: list[Section] = []
        inside: set[tuple[str, ...]] = set()
        holders = {path[:length] for path in self._controllers() for length in range(len(path))}
        for path, leaf in self.leaves.items():
            if leaf.value.kind is not ValueKind.MAP or any(path[:length] in inside for length in range(1, len(path))):
                continue
            if self._is_controller(path):
                controllers.append(self._controller(path, leaf))
                inside.add(path)
            elif path not in holders:
                others.append(self._section(path, leaf))
                inside.add(path)
        known: dict[tuple[str, ...], list[tuple[str, ...]]] = {}
        for controller in controllers:
            known.setdefault((controller.name,), []).append((*_parts_of(controller.namespace), controller.name))
        controllers += [
            _undeclared("/" * full + "/".join(name))
            for full, name in self.started
            if not any(_is_meant(path, name, full=full) for path in known.get(name[-1:], ()))
        ]
        return _Parts([], controllers, others)

    def _controllers(self) -> list[tuple[str, ...]]:
        return [
            path for path, leaf in self.leaves.items() if leaf.value.kind is ValueKind.MAP and self._is_controller(path)
        ]

    def _is_controller(self, path: tuple[str, ...]) -> bool:
        if any(_is_meant(path, name, full=full) for full, name in self._started_by_end.get(path[-1:], ())):
            return True
        if any((*path, key) in self.leaves for key in OF_OTHER_STACKS):
            return False
        kind = self._type(path)
        return path not in self.hardware and (
            kind is not None
            and kind.kind is ValueKind.STRING
            and (is_class(kind.text) or kind.text.endswith("Controller"))
        )

    def _hardware(self, path: tuple[str, ...]) -> Iterator[str]:
        """The sections that combined_robot_hw reads as hardware."""
        if path[-1:] == (_COMBINED,):
            yield from (name for name, _ in self.leaves[path].value.strings)

    def _type(self, path: tuple[str, ...]) -> Value | None:
        leaf = self.leaves.get((*path, "type"))
        return leaf.value if leaf else None

    def _section(self, path: tuple[str, ...], leaf: Leaf) -> Section:
        leaves = with_names_of_elements(list(self._below(path)), len(path))
        return Section("/".join(path), leaf.key, parameters_of(leaves, len(path)))

    def _below(self, path: tuple[str, ...]) -> Iterator[Leaf]:
        for child in self.children.get(path, ()):
            if child in self.leaves:
                yield self.leaves[child]
            yield from self._below(child)

    def _controller(self, path: tuple[str, ...], leaf: Leaf) -> Controller:
        section = self._section(path, leaf)
        parameters = section.parameters
        return Controller(
            name=section.name,
            namespace=section.namespace,
            type=self._type(path),
            declared_at=leaf.key,
            parameters=parameters,
            own=parameters,
            sections=(section,),
        )


def _parts_of(namespace: str | None) -> tuple[str, ...]:
    return tuple(part for part in (namespace or "").split("/") if part)


def _is_meant(path: tuple[str, ...], name: tuple[str, ...], *, full: bool) -> bool:
    """Whether the name of a started controller matches a path: completely if it is a full name, otherwise its end."""
    return path == name if full else path[-len(name) :] == name


def _undeclared(name: str) -> Controller:
    """A controller that is started, but that no file declares."""
    namespace, slash, last = name.rpartition("/")
    known = f"/{namespace.strip('/')}" if namespace.strip("/") else "" if name.startswith("/") else None
    return Controller(
        name=last,
        namespace=known if slash else None,
        type=None,
        declared_at=None,
        parameters=Parameters(),
        own=Parameters(),
    )
