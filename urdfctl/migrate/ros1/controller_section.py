"""Write the section of one controller in a file for ROS 2: its type, and its parameters as that type reads them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence

from urdfctl.catalog.catalog import Catalog, catalog_with
from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.entries import ControllerType, ParameterEntry
from urdfctl.catalog.map_parameters import matching
from urdfctl.migrate.distro.names import OWN
from urdfctl.migrate.edits.yaml_edits import MapEdits, Path, leaves
from urdfctl.migrate.moved_topics import CODE
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.controller_map import MapItem
from urdfctl.migrate.ros1.parameters import MECANUM, ParameterChange, changed, changes_of, pid_settings
from urdfctl.migrate.ros1.roslaunch_values import parameter_name
from urdfctl.migrate.ros1.wheel_measures import measured
from urdfctl.migrate.step import EntryKind, ReportEntry
from urdfctl.migrate.todo import todo_line
from urdfctl.source.span import SourceText
from urdfctl.source.yaml.kinds import ValueKind
from urdfctl.source.yaml.tree import Mapping as Map
from urdfctl.source.yaml.tree import Node, Scalar
from urdfctl.source.yaml.tree import Sequence as List
from urdfctl.source.yaml.types import typed_by_rcl
from urdfctl.startup.records import NamedTuple

_RENAMED = "ros2_controllers doc/migration.rst; the parameters that the distro's branch declares"
_STAMPED = "ros2_controllers humble diff_drive_controller_parameter.yaml: use_stamped_vel"
_TYPES = "control.ros.org, differences between ros_control and ros2_control"
_FRACTION = re.compile(r"[-+]?\d*\.\d*")
_STAND_INS = {"wheel_separation": 0.5, "wheel_radius": 0.1}
_STAND_INS_OF_MECANUM = {
    "kinematics.wheels_radius": 0.1,
    "kinematics.sum_of_robot_center_projection_on_X_Y_axis": 0.5,
}
"""The measures of wheels that a controller requires, with values as the generators write them if they are unknown."""
_SIDES = ("left", "right")
_OF_MECANUM = tuple(f"{end}_{side}_wheel_joint" for end in ("front", "back") for side in _SIDES)
_DECIMAL = re.compile(r"\d+\.?\d*|\.\d+")
_PID = re.compile(r"(?:^|\.)pid\.")


class ControllerSection(NamedTuple):
    """A controller for ROS 2.

    type: its type.
    lines: its parameters as YAML, indented by nothing.
    rate: the rate in Hz at which it published, None if it had none.
    todo: what is left to a person, if it is a type of the user's own.
    """

    type: str
    lines: str
    rate: float | None
    entries: tuple[ReportEntry, ...]
    todo: str = ""


def section_of(packages: MigratedPackages, item: MapItem, source: SourceText) -> ControllerSection | None:
    """Return a controller for the target; None if its type has no replacement there.

    A type that is not of ROS stays, with its parameters.
    """
    catalog = catalog_with(packages.settings.additions)
    target = packages.options.target
    same = catalog.controller(item.type, target)
    replacement = None if same else catalog.replacement(item.type, target)
    kind = same or (catalog.controller(replacement.type, target) if replacement else None)
    if not isinstance(item.entry.value, Map):
        return None
    if kind is None:
        own = packages.options.successors.get(item.type, "")
        return _unported(item, item.entry.value, source, own) if not catalog.distros_of(item.type) else None
    writer = _SectionWriter(item, kind, source, catalog)
    extra = dict(replacement.parameters) if replacement else {}
    return writer.section(extra, packages)


def _unported(item: MapItem, parameters: Map, source: SourceText, own: str) -> ControllerSection:
    """A controller of a type that its owner must port, as it is; of its successor if the owner names that."""
    todo = f"port the controller type '{item.type}' of '{item.name}' to ROS 2"
    lines = (line for line in _block(parameters, source, MapEdits(source)) if not line.startswith("type:"))
    entry = ReportEntry(EntryKind.FOR_YOU, todo, item.entry.key.at)
    if own:
        what = f"controller '{item.name}' of type '{item.type}' became '{own}'"
        entry = ReportEntry(EntryKind.DONE, what, item.entry.key.at, authority=OWN)
        todo = ""
    return ControllerSection(own or item.type, "".join(f"{line}\n" for line in lines), None, (entry,), todo)


def _publishes_stamps(packages: MigratedPackages) -> bool:
    return any(b"TwistStamped" in packages.read(path).data for path in packages.files(*CODE))


class _SectionWriter:
    def __init__(self, item: MapItem, kind: ControllerType, source: SourceText, catalog: Catalog) -> None:
        self.item, self.kind, self.source, self.catalog = item, kind, source, catalog
        self.entries: list[ReportEntry] = []
        self.rate: float | None = None
        self.gone: set[str] = set()
        assert isinstance(item.entry.value, Map)  # noqa: S101 (the caller looked)
        self.map = item.entry.value

    def section(self, extra: Mapping[str, object], packages: MigratedPackages) -> ControllerSection:
        if self.kind.type != self.item.type:
            what = f"controller '{self.item.name}' of type '{self.item.type}' became '{self.kind.type}'"
            self.entries.append(ReportEntry(EntryKind.DONE, what, self.item.entry.key.at, authority=_TYPES))
        edits = MapEdits(self.source)
        names = {parameter_name(name): path for name, path in leaves(self.map)}
        added = [f"{name}: {_yaml(value)}" for name, value in extra.items() if name not in names]
        added += self._loops(names)
        added += self._unstamped(names, packages)
        added += self._wheels(names, packages) if self.kind.type != MECANUM else self._mecanum(names, packages)
        for name, path in names.items():
            self._change(edits, name, path, added, packages)
        return ControllerSection(self.kind.type, self._text(edits, added), self.rate, tuple(self.entries))

    def _unstamped(self, names: Mapping[str, Path], packages: MigratedPackages) -> Iterator[str]:
        """Yield the setting with which a drive reads velocities without a stamp, as ROS 1 publishes them."""
        if "use_stamped_vel" not in self.kind.parameters or "use_stamped_vel" in names:
            return
        if not packages.found(_publishes_stamps):
            what = f"nobody in these packages publishes velocities with a stamp: '{self.item.name}' reads them without"
            at = self.item.entry.key.at
            option = "remove use_stamped_vel"
            self.entries.append(ReportEntry(EntryKind.DECIDED, what, at, authority=_STAMPED, option=option))
            yield "use_stamped_vel: false"

    def _loops(self, names: Mapping[str, Path]) -> list[str]:
        """The settings of a pid_controller for a controller with a PID loop."""
        joints = [text for name in ("joint", "joints") if name in names for text in _texts(names[name][-1][1].value)]
        return pid_settings(self.item.type, {joint: self._gains(joint, names) for joint in joints})

    def _gains(self, joint: str, names: Mapping[str, Path]) -> list[tuple[str, str]]:
        """The gains of a joint: its own, or those of the only one."""
        starts = (f"{joint}.pid.", "pid.")
        given = [
            (name[len(start) :], path) for start in starts for name, path in names.items() if name.startswith(start)
        ]
        written = _clamps([(name, self._scalar(path)) for name, path in given])
        return [(name, value) for name, value in written if f"gains.<dof_names>.{name}" in self.kind.parameters]

    def _wheels(self, names: Mapping[str, Path], packages: MigratedPackages) -> list[str]:
        """The measures of the wheels, which ROS 1 reads from the robot."""
        sides = [self._texts_of(name, names) for name in ("left_wheel", "right_wheel")]
        if not all(sides):
            return []
        lines = list(measured(packages, sides[0], sides[1], tuple(names)))
        if lines:
            what = "the controller no longer measures the wheels in the robot: their measures are written"
            self.entries.append(ReportEntry(EntryKind.DONE, what, self.item.entry.key.at, authority=_RENAMED))
        known = {*names, *(line.partition(":")[0] for line in lines)}
        return [*lines, *self._stand_ins(_STAND_INS, known)]

    def _mecanum(self, names: Mapping[str, Path], packages: MigratedPackages) -> list[str]:
        """The measures of four wheels that roll sideways too; ROS 1 reads them from the robot."""
        given = {name: texts for name in _OF_MECANUM if (texts := self._texts_of(name, names))}
        left, right = ([one for name, texts in given.items() if side in name for one in texts] for side in _SIDES)
        found = measured(packages, left, right, (*names, "wheel_separation")) if left and right else ()
        lines = [f"kinematics.{line.replace('wheel_radius', 'wheels_radius', 1)}" for line in found]
        lines += self._projection(names) if not any("sum_of_robot" in line for line in lines) else []
        changes = (changed(name, changes_of(MECANUM)) for name in names)
        known = {*(one[0].name for one in changes if one), *(line.partition(":")[0] for line in lines)}
        return [*lines, *self._stand_ins(_STAND_INS_OF_MECANUM, known)]

    def _projection(self, names: Mapping[str, Path]) -> Iterator[str]:
        """Yield half the sum of both distances between wheels (mecanum_drive_controller.cpp wheels_k_; lx + ly)."""
        texts = [next(iter(self._texts_of(f"wheel_separation_{axis}", names)), "") for axis in "xy"]
        if all(map(_DECIMAL.fullmatch, texts)):
            half = (float(texts[0]) + float(texts[1])) / 2
            yield f"kinematics.sum_of_robot_center_projection_on_X_Y_axis: {half:.6g}"

    def _stand_ins(self, stand_ins: Mapping[str, float], known: Collection[str]) -> Iterator[str]:
        """Yield the lines of the measures that no robot tells, each with a TODO."""
        for name, value in stand_ins.items():
            if name not in known:
                what = f"measure the wheels and write {name} of '{self.item.name}', in m"
                self.entries.append(ReportEntry(EntryKind.FOR_YOU, what, self.item.entry.key.at, authority=_RENAMED))
                yield f"{name}: {value}  {todo_line(self.source.path, what)}"

    def _texts_of(self, name: str, names: Mapping[str, Path]) -> list[str]:
        return _texts(names[name][-1][1].value) if name in names else []

    def _scalar(self, path: Path) -> str:
        node = path[-1][1].value
        return _as_double(node) if isinstance(node, Scalar) else ""

    def _change(self, edits: MapEdits, name: str, path: Path, added: list[str], packages: MigratedPackages) -> None:
        key, value = path[-1][1].key, path[-1][1].value
        if name == "type":
            self._drop(edits, path)
            return
        if name.endswith("publish_rate") and isinstance(value, Scalar):
            self.rate = _number(value)
        found = changed(name, changes_of(self.kind.type))
        if found is None and _PID.search(name) and "gains.<dof_names>.p" in self.kind.parameters:
            self._drop(edits, path)
            return
        change, element = found or (ParameterChange(name), "")
        targets = [each.replace("<>", element) for each in change.name.split()]
        is_misread = bool(targets) and self._is_misread(value, targets[0])
        if not targets or is_misread or not self._was_ever_read(targets[0]):
            self._drop(edits, path)
            why = change.why or f"'{self.kind.type}' does not read it in {packages.options.target}"
            why = "it is an integer, and ROS 1 ignores other values" if is_misread else why
            message = f"parameter '{name}' of '{self.item.name}' is dropped: {why}"
            self.entries.append(ReportEntry(EntryKind.DONE, message, key.at, authority=_RENAMED))
            return
        if targets != [name]:
            message = f"parameter '{name}' of '{self.item.name}' became {' and '.join(targets)}"
            self.entries.append(ReportEntry(EntryKind.DONE, message, key.at, authority=_RENAMED))
        self._rename(edits, path, targets, added)
        self._retype(edits, value, targets[0], as_list=change.as_list)

    def _was_ever_read(self, name: str) -> bool:
        """Whether a distro of ROS 2 reads a parameter: later steps bring it into the form of the target."""
        return bool(matching(name, self.kind.parameters) or matching(name, self.kind.former))

    def _is_misread(self, value: Node, name: str) -> bool:
        """Whether a value is a number with a fraction for a parameter that is an integer."""
        parameter = self._parameter(name)
        is_integer = parameter is not None and set(parameter.types) == {"int"}
        return is_integer and isinstance(value, Scalar) and _FRACTION.fullmatch(value.text) is not None

    def _parameter(self, name: str) -> ParameterEntry | None:
        """The parameter in the target, or in a distro of ROS 2 that still reads it; None if there is none."""
        if found := matching(name, self.kind.parameters):
            return self.kind.parameters[found[0]]
        if not (former := matching(name, self.kind.former)):
            return None
        distros = (distro for distro in self.kind.former[former[0]].distros if distro in ROS2)
        kinds = (self.catalog.controller(self.kind.type, distro) for distro in distros)
        return next((kind.parameters[former[0]] for kind in kinds if kind and former[0] in kind.parameters), None)

    def _drop(self, edits: MapEdits, path: Path) -> None:
        """Drop a parameter; those of a map in braces when their lines are written."""
        if len(path) == 1 and _is_flow(self.map):
            self.gone.add(path[0][1].key.text)
        else:
            edits.drop(path)

    def _rename(self, edits: MapEdits, path: Path, targets: Sequence[str], added: list[str]) -> None:
        key, value = path[-1][1].key, path[-1][1].value
        if targets == [".".join(entry.key.text for _, entry in path)]:
            return
        written = self.source.data[value.start : value.end].decode("utf-8", "surrogateescape").strip()
        if len(path) == 1:
            edits.replace(key, targets[0])
            added += (
                f"{other}: {_as_double(value) if isinstance(value, Scalar) else written}" for other in targets[1:]
            )
        else:
            self._drop(edits, path)
            added += (f"{other}: {_as_double(value) if isinstance(value, Scalar) else written}" for other in targets)

    def _retype(self, edits: MapEdits, value: Node, name: str, *, as_list: bool) -> None:
        parameter = self._parameter(name)
        if parameter is None:
            return
        if isinstance(value, Scalar):
            text = self.source.data[value.start : value.end].decode("utf-8", "surrogateescape")
            new = _as_double(value) if "double" in parameter.types or "double_array" in parameter.types else text
            is_array = as_list or all(kind.endswith("_array") for kind in parameter.types)
            if is_array:
                new = f"[{new}]"
            if new != text:
                edits.replace(value, new)
        elif isinstance(value, List) and "double_array" in parameter.types:
            for item in value.items:
                if isinstance(item, Scalar) and (new := _as_double(item)) != item.text:
                    edits.replace(item, new)
        elif isinstance(value, List) and "string_array" in parameter.types:
            self._name_items(edits, value, name)

    def _name_items(self, edits: MapEdits, value: List, name: str) -> None:
        """Replace each map of a list by its name: ROS 2 has no lists of maps."""
        maps = [item for item in value.items if isinstance(item, Map)]
        names = [item.get("name") for item in maps]
        if not maps or not all(isinstance(one, Scalar) for one in names) or len(maps) < len(value.items):
            return
        for item, own in zip(maps, names, strict=True):
            assert isinstance(own, Scalar)  # noqa: S101 (all of them were looked at)
            edits.replace(item, self.source.data[own.start : own.end].decode("utf-8", "surrogateescape"))
        others = dict.fromkeys(entry.key.text for item in maps for entry in item.entries if entry.key.text != "name")
        dropped = f", without {', '.join(others)}" if others else ""
        message = f"parameter '{name}' of '{self.item.name}' became a list of names{dropped}"
        self.entries.append(ReportEntry(EntryKind.DONE, message, value.at, authority=_RENAMED))

    def _text(self, edits: MapEdits, added: Sequence[str]) -> str:
        """The parameters as YAML, indented by nothing: as they are written, with the edits."""
        lines = list(_block(self.map, self.source, edits))
        kept = [line for line in lines if not self.gone or line.partition(":")[0].strip("'\" ") not in self.gone]
        return "".join(f"{line}\n" for line in [*kept, *added])


def _block(node: Map, source: SourceText, edits: MapEdits) -> Iterator[str]:
    if not node.entries:
        return
    if _is_flow(node):
        inside = _edited(source, edits, node.start + 1, node.end - 1).decode("utf-8", "surrogateescape")
        yield from _flow_entries(inside)
        return
    first = source.data.rfind(b"\n", 0, node.start) + 1
    column = node.entries[0].key.start - (source.data.rfind(b"\n", 0, node.entries[0].key.start) + 1)
    end = source.data.find(b"\n", len(source.data[: node.end].rstrip()) - 1)
    text = _edited(source, edits, first, len(source.data) if end < 0 else end + 1).decode("utf-8", "surrogateescape")
    for line in text.rstrip().splitlines():
        yield line[min(column, len(line) - len(line.lstrip())) :] if line.strip() else ""


def _is_flow(node: Map) -> bool:
    """Whether a map is written in braces."""
    return node.source.data[node.start : node.start + 1] == b"{"


def _edited(source: SourceText, edits: MapEdits, start: int, end: int) -> bytes:
    position, pieces = start, []
    for edit in edits.edits():
        if edit.span.start < start or edit.span.end > end:
            continue
        pieces += [source.data[position : edit.span.start], edit.text.encode("utf-8", "surrogateescape")]
        position = max(position, edit.span.end)
    return b"".join([*pieces, source.data[position:end]])


def _flow_entries(text: str) -> Iterator[str]:
    """The entries of a flow map, each as a line of its own."""
    depth, quote, start = 0, "", 0
    for index, character in enumerate(text):
        if quote:
            quote = "" if character == quote else quote
        elif character in "'\"":
            quote = character
        elif character in "[{":
            depth += 1
        elif character in "]}":
            depth -= 1
        elif character == "," and not depth:
            yield from _one_line(text[start:index])
            start = index + 1
    yield from _one_line(text[start:])


def _one_line(text: str) -> Iterator[str]:
    joined = " ".join(text.split())
    if joined:
        yield joined


def _clamps(gains: Sequence[tuple[str, str]]) -> Iterator[tuple[str, str]]:
    """The gains with two limits of the integral part instead of one (control_toolbox Pid)."""
    given = dict(gains)
    for name, value in gains:
        if name == "i_clamp":
            yield from (
                (each, value if each.endswith("max") else _negative(value))
                for each in ("i_clamp_max", "i_clamp_min")
                if each not in given
            )
        else:
            yield name, value


def _negative(text: str) -> str:
    return text.removeprefix("-") if text.startswith("-") else f"-{text.removeprefix('+')}"


def _texts(node: Node) -> list[str]:
    items = node.items if isinstance(node, List) else (node,)
    return [item.text for item in items if isinstance(item, Scalar)]


def _as_double(node: Scalar) -> str:
    """A number as rcl reads it as a double; any other value as it is written."""
    typed = typed_by_rcl(node)
    if typed.kind is ValueKind.INT:
        return f"{typed.value}.0"
    return node.source.data[node.start : node.end].decode("utf-8", "surrogateescape")


def _number(node: Scalar) -> float | None:
    value = typed_by_rcl(node).value
    return float(value) if isinstance(value, int | float) else None


def _yaml(value: object) -> str:
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_yaml, value))}]"
    return str(value).lower() if isinstance(value, bool) else str(value)
