"""Controller files of ROS 1 become parameter files of ROS 2: a section for each node, with `ros__parameters`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, child, content, elements, end_of, root_of
from urdfctl.migrate.edits.places import plugin_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.controller_map import GAINS_OF_GAZEBO, MapItem, controller_maps, loads_of
from urdfctl.migrate.ros1.controller_section import ControllerSection, section_of
from urdfctl.migrate.ros1.joint_gains import reads_gains
from urdfctl.migrate.ros1.joint_states import NEW_NAME, loads_declaration
from urdfctl.migrate.ros1.node_sections import node_section
from urdfctl.migrate.ros1.spawned_names import SpawnedName, spawned_names
from urdfctl.migrate.shared.hardware import simulated_by
from urdfctl.migrate.shared.manager import BROADCASTER, RATE, manager_text
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import todo_line
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping, Node

_FORM = "rcl_yaml_param_parser: parameters are below ros__parameters of their node"
_PID_GAINS = "gz_ros2_control src/gz_system.cpp: position_proportional_gain, one for all joints"
_SPAWNED = "ros2_control controller_manager.cpp: a controller is a node in the namespace of its manager"
_STEPS = 1000
"""Steps of a world in a second, by default: gazebo_ros_control updates in each (gazebo_ros_control_plugin.cpp)."""
_ANY = "/**"
"""Stands for any namespace in a parameter file (rclcpp parameter_map.cpp)."""


def _files(packages: MigratedPackages) -> Iterator[Proposal]:
    for source, root, items in controller_maps(packages):
        yield _ControllersFile(packages, source, root, items).proposal()


class _ControllersFile:
    """A controller file while it is migrated."""

    def __init__(self, packages: MigratedPackages, source: SourceText, root: Node, items: Sequence[MapItem]) -> None:
        self.packages, self.source, self.root, self.items = packages, source, root, items
        self.entries: list[ReportEntry] = []
        is_named_by_file = not any(item.is_file for item in items)
        self.loaded_into = _namespace_of(packages, source.path) if is_named_by_file else ""

    def proposal(self) -> Proposal:
        sections = [(item, section_of(self.packages, item, self.source) if item.type else None) for item in self.items]
        starts = [self._start(index) for index in range(len(self.items))]
        head = self.source.data[: min(starts[0], self._first_line())].decode("utf-8", "surrogateescape")
        blocks = [self._written(item, section, start) for (item, section), start in zip(sections, starts, strict=True)]
        text = head.rstrip("\n") + "\n\n" if head.strip() else ""
        text += "\n".join([*self._managers(sections), *(block for block in blocks if block)])
        tail = self._tail()
        done = ReportEntry(
            EntryKind.DONE, "the file is in the form of ROS 2", self.items[0].entry.key.at, authority=_FORM
        )
        whole = SourceSpan(self.source, 0, len(self.source.data))
        entries = tuple(dict.fromkeys([done, *self.entries]))
        return Proposal((Edit(whole, text.rstrip("\n") + "\n" + tail),), entries=entries)

    def _managers(self, sections: Sequence[tuple[MapItem, ControllerSection | None]]) -> Iterator[str]:
        """The section of the manager of each namespace."""
        types: dict[str, dict[str, str]] = {}
        for item, section in sections:
            if section is not None:
                self._note_name(item)
                types.setdefault(self._namespace(item), {})[self._name(item)] = section.type
            self.entries += section.entries if section else ()
        rate, why = self._rate([section for _, section in sections if section])
        self.entries.append(
            ReportEntry(EntryKind.DECIDED, f"update_rate: {rate} Hz, {why}", self.items[0].entry.key.at)
        )
        for namespace, known in types.items():
            if BROADCASTER not in known.values() and loads_declaration(self.packages):
                known[NEW_NAME] = BROADCASTER
            yield manager_text(namespace, known, rate, simulated=simulated_by(self.packages) != "none")

    def _rate(self, sections: Sequence[ControllerSection]) -> tuple[int, str]:
        for plugin in plugin_elements(self.packages, at_first=True):
            period = child(plugin, "controlPeriod")
            try:
                return round(1 / float(content(period) if period is not None else "")), "from <controlPeriod>"
            except (ValueError, ZeroDivisionError):
                continue
        published = max((section.rate or 0.0 for section in sections), default=0.0)
        if published <= _STEPS and self._is_tuned_in_gazebo(sections):
            return _STEPS, "at which gazebo_ros_control closed the loops that the gains are for"
        if published > RATE:
            return round(published), "at which a controller published"
        return RATE, "usual: ROS 1 has no such parameter"

    def _is_tuned_in_gazebo(self, sections: Sequence[ControllerSection]) -> bool:
        """Return whether controllers have gains, and are simulated as before: other rates may not suit the gains."""
        plugins = (attribute(plugin, "filename") for plugin in plugin_elements(self.packages, at_first=True))
        tuned = any(re.search(r"^gains\b", section.lines, re.MULTILINE) for section in sections)
        return tuned and simulated_by(self.packages) != "none" and any("_control" in name for name in plugins)

    def _namespace(self, item: MapItem) -> str:
        spawned = self._spawned(item)
        written = f"{self.loaded_into}/{item.namespace}" if spawned is None else spawned.manager
        return "".join(f"/{part}" for part in written.split("/") if part)

    def _name(self, item: MapItem) -> str:
        spawned = self._spawned(item)
        return item.name if spawned is None else spawned.name

    def _note_name(self, item: MapItem) -> None:
        """Report a controller whose namespace, and with it the names of its topics, changes."""
        spawned = self._spawned(item)
        if spawned is not None and f"{spawned.manager}/{spawned.name}".strip("/") != f"{item.namespace}/{item.name}":
            now = "/".join(("", *filter(None, [spawned.manager]), spawned.name))
            message = f"controller '{item.namespace}/{item.name}' became '{spawned.name}': its topics are in {now} now"
            self.entries.append(ReportEntry(EntryKind.DECIDED, message, item.entry.key.at, authority=_SPAWNED))

    def _spawned(self, item: MapItem) -> SpawnedName | None:
        parts = f"{self.loaded_into}/{item.namespace}/{item.name}".split("/")
        return self.packages.found(spawned_names).get("/".join(part for part in parts if part)) if item.type else None

    def _first_line(self) -> int:
        """The offset of the line of the first key, which may be a namespace."""
        assert isinstance(self.root, Mapping)  # noqa: S101 (it has items)
        return self.source.data.rfind(b"\n", 0, self.root.entries[0].key.start) + 1

    def _start(self, index: int) -> int:
        """The offset at which the lines of an item begin, with the comments above it."""
        item = self.items[index]
        data = self.source.data
        start = data.rfind(b"\n", 0, item.entry.key.start) + 1
        floor = _end(self.items[index - 1].entry.value) if index else 0
        while start > floor:
            above = data.rfind(b"\n", 0, start - 1) + 1
            line = data[above : start - 1].strip()
            if above < floor or not line.startswith(b"#"):
                break
            start = above
        return start

    def _written(self, item: MapItem, section: ControllerSection | None, start: int) -> str:
        data = self.source.data
        line = data.rfind(b"\n", 0, item.entry.key.start) + 1
        comments = [text.strip() for text in data[start:line].decode("utf-8", "surrogateescape").splitlines()]
        above = "".join(f"{text}\n" for text in comments if text)
        if section is not None:
            above += f"{todo_line(self.source.path, section.todo)}\n" if section.todo else ""
            body = "".join(f"    {text}\n" if text else "\n" for text in section.lines.splitlines())
            space, own = self._namespace(item), self._name(item)
            name = f"{space}/{own}" if space else own
            name = f'"{name}"' if "*" in name else name
            lines = [line.strip() for line in body.splitlines() if line.strip()]
            if all(line.startswith("#") for line in lines):  # rcl rejects a section without a value
                return above * bool(section.todo or lines) + "".join(f"{line}\n" for line in lines)
            return f"{above}{name}:\n  ros__parameters:\n{body}"
        return above + self._other(item, data[line : _end_of_lines(data, item)].decode("utf-8", "surrogateescape"))

    def _other(self, item: MapItem, text: str) -> str:
        """What is no controller of the target: kept as a comment, because ROS 2 rejects the file otherwise."""
        if item.name == GAINS_OF_GAZEBO:
            kept = "are parameters of the joints in <ros2_control>"
            lost = "are dropped: the simulator moves joints without a PID loop of its own"
            message = f"the gains of Gazebo's joints {kept if reads_gains(self.packages) else lost}"
            self.entries.append(ReportEntry(EntryKind.DECIDED, message, item.entry.key.at, authority=_PID_GAINS))
            return ""
        if not item.type and (section := node_section(self.packages, item, self._namespace(item))):
            message = f"'{item.name}' is the section of a node, which launch files give the file to"
            self.entries.append(ReportEntry(EntryKind.DONE, message, item.entry.key.at, authority=_FORM))
            return section
        kind = f"type '{item.type}' has no counterpart in ROS 2" if item.type else "no controller reads it"
        what = f"'{item.name}' is kept as a comment: {kind}"
        if not item.type:
            self.entries.append(ReportEntry(EntryKind.DECIDED, what, item.entry.key.at, authority=_FORM))
            return "".join(f"# {line}\n" for line in text.splitlines())
        self.entries.append(ReportEntry(EntryKind.FOR_YOU, what, item.entry.key.at))
        return f"{todo_line(self.source.path, what)}\n" + "".join(f"# {line}\n" for line in text.splitlines())

    def _tail(self) -> str:
        """The comments after the last item."""
        last = self.items[-1]
        rest = self.source.data[_end_of_lines(self.source.data, last) :].decode("utf-8", "surrogateescape")
        return f"\n{rest.strip()}\n" if rest.strip() else ""


def _end(node: Node) -> int:
    return node.start + len(node.source.data[node.start : node.end].rstrip())


def _end_of_lines(data: bytes, item: MapItem) -> int:
    end = data.find(b"\n", _end(item.entry.value))
    return len(data) if end < 0 else end + 1


def _namespace_of(packages: MigratedPackages, path: str) -> str:
    """The namespace that launch files load a file into; empty if none does.

    It is any namespace if there are several, or if an argument names it: unless one chooses the file, too, so that each
    namespace has its own.
    """
    loads = list(loads_of(packages, path))
    if any(_is_argument(load.at) and not _is_file_of_argument(load.at) for load in loads):
        return _ANY
    spaces = {load.namespace or "" for load in loads}
    return _ANY if len(spaces) > 1 else next(iter(spaces), "")


def _is_argument(at: Place) -> bool:
    """Whether the namespace of a <rosparam> is an argument, by its attribute or by those of groups around it."""
    return any("$(" in attribute(element, "ns") for element in _around(at))


def _is_file_of_argument(at: Place) -> bool:
    """Whether an argument chooses the file of a <rosparam>."""
    return any("$(arg" in attribute(element, "file") for element in _around(at) if element.tagName == "rosparam")


def _around(at: Place) -> list[Element]:
    """The elements around a place, with the one that it is in."""
    root = root_of(at.source)
    return [one for one in elements(root) if one.start <= at.start < end_of(one)] if root is not None else []


CONTROLLERS = Step(
    name="controllers",
    part=Part.YAML,
    summary="Controller files",
    propose=_files,
    generation=1,
    is_needed=True,
    rows=(
        Row("NAME: {type: T, ...}", "controller_manager and NAME with ros__parameters", "", _FORM),
        Row("gazebo_ros_control/pid_gains", "", "", _PID_GAINS),
    ),
    before=[
        {
            "config/controllers.yaml": """
                elbow_controller:
                  type: effort_controllers/JointEffortController
                  joint: elbow
            """,
        },
    ],
    after=[
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100  # Hz

                    elbow_controller:
                      type: forward_command_controller/ForwardCommandController

                elbow_controller:
                  ros__parameters:
                    joints: [elbow]
                    interface_name: effort
            """,
        },
    ],
)
