"""Parameters of controllers and of the controller manager: renamed, converted, dropped, or with their old default."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.moves import MANAGER, Move, When, as_yaml, in_words, parameter_moves
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.yaml_edits import MapEdits, Path, deepest, leaves
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, sections
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import todo_line
from urdfctl.source.yaml.tree import Scalar

_PLAIN_NAME = r"[a-z_][\w.<>]*"
_CATALOGUE = "ros2_controllers: the parameters that the distro's branch declares"


class _Parameter:
    """A parameter of a section while moves are applied to it.

    path: the maps and entries that lead to it; empty for a new one.
    name: its dotted name now; empty if it is dropped.
    value: its new value as YAML; None if it is unchanged.
    origin: the parameter that it comes from, for a new one.
    """

    __slots__ = ("entries", "name", "origin", "path", "todo", "value")

    def __init__(self, name: str, path: Path, origin: _Parameter | None = None) -> None:
        self.name, self.path, self.origin = name, path, origin
        self.value: str | None = None
        self.todo = ""

    @property
    def text(self) -> str | None:
        """Its value as YAML; None for a list or map."""
        if self.value is not None or not self.path:
            return self.value
        node = self.path[-1][1].value
        return node.source.data[node.start : node.end].decode("utf-8", "replace") if isinstance(node, Scalar) else None


def _parameters(packages: MigratedPackages) -> Iterator[Proposal]:
    for section in packages.found(sections):
        known = _moves_for(section.type, packages.options.target)
        moves = [move for move in known if _is_due(packages, move, section.path)]
        if moves and section.parameters.entries and packages.may_change(section.path):
            yield from _Moving(packages, section, moves).proposals()


def _is_due(packages: MigratedPackages, move: Move, path: str) -> bool:
    """Whether the target needs a move: an old name if it is there at all, a default only if it changes on the way."""
    return packages.crosses(move.since, path) if move.is_default else packages.reaches(move.since)


class _Moving:
    """One section while it is moved."""

    def __init__(self, packages: MigratedPackages, section: FileSection, moves: Sequence[Move]) -> None:
        self.section, self.moves = section, moves
        self.source = packages.read(section.path)
        self.all = [_Parameter(name, path) for name, path in leaves(section.parameters)]
        self.given = {one.name: one.text for one in self.all}
        self.entries: list[ReportEntry] = []

    def proposals(self) -> Iterator[Proposal]:
        for move in self.moves:
            if move.is_default:
                self._add_default(move)
                continue
            for parameter in list(self.all):
                element = _element(move.name, parameter.name) if parameter.name else None
                if element is not None and self._holds(move.when, parameter):
                    self._make(move, parameter, element)
        edits = self._edits()
        if edits:
            yield Proposal(edits=edits, entries=tuple(self.entries), fixes=("UC435", "UC436"))

    # -- the moves -----------------------------------------------------------------------------------------------------

    def _find(self, name: str) -> _Parameter | None:
        return next((one for one in self.all if one.name == name), None)

    def _holds(self, when: When | None, parameter: _Parameter) -> bool:
        """Whether a condition holds for the parameters as they are in the file."""
        if when is None:
            return True
        name = when.param or parameter.name
        if name not in self.given:
            return when.or_absent
        text = (self.given[name] or "") if when.param else (parameter.text or "")
        return when.is_set or text.strip("'\"").lower() == str(when.value).lower()

    def _make(self, move: Move, parameter: _Parameter, element: str) -> None:
        becomes = {re.sub("<[^>]*>", lambda _: element, name): value for name, value in move.becomes.items()}
        values = {name: _converted(value, parameter) for name, value in becomes.items()}
        if any(value is None and becomes[name] != "same" for name, value in values.items()):
            return
        old, parameter.todo = parameter.name, move.todo
        if move.only_set:
            for name, value in values.items():
                target = self._find(name)
                if target is not None:
                    target.value = value
            values = {}
        new = {name: value for name, value in values.items() if self._find(name) is None}
        parameter.name = next(iter(new), "")
        if new:
            parameter.value = new.pop(parameter.name) or parameter.value
        at = self.all.index(parameter)
        for number, (name, value) in enumerate(new.items()):
            added = _Parameter(name, (), parameter)
            added.value = value
            self.all.insert(at + 1 + number, added)
        self._report(move, parameter, old, becomes)

    def _report(self, move: Move, parameter: _Parameter, old: str, becomes: Mapping[str, object]) -> None:
        at = parameter.path[-1][1].key.at if parameter.path else self.section.parameters.at
        now = " and ".join(f"'{in_words(name, value)}'" for name, value in becomes.items())
        what = f"'{old}' of '{self.section.node}' " + (f"became {now}" if now else "is dropped")
        if self.entries and self.entries[-1].message == what:
            return
        self.entries.append(ReportEntry(EntryKind.DONE, what, at, authority=move.authority))
        if move.todo:
            self.entries.append(ReportEntry(EntryKind.FOR_YOU, move.todo, at, authority=move.authority))

    def _add_default(self, move: Move) -> None:
        if self._find(move.name) is not None or not self.all:
            return
        added = _Parameter(move.name, ())
        added.value = as_yaml(move.becomes[move.name])
        self.all.append(added)
        what = f"the default of '{move.name}' changed: the old value {added.value} is written for '{self.section.node}'"
        option = f"remove {move.name}"
        self.entries.append(
            ReportEntry(EntryKind.DECIDED, what, self.section.parameters.at, authority=move.authority, option=option)
        )

    # -- the edits -----------------------------------------------------------------------------------------------------

    def _edits(self) -> tuple[Edit, ...]:
        edits = MapEdits(self.source)
        for parameter in self.all:
            if not parameter.path:
                self._insert(edits, parameter)
        for parameter in self.all:
            if parameter.path:
                self._change(edits, parameter)
        return edits.edits()

    def _insert(self, edits: MapEdits, added: _Parameter) -> None:
        parent, key = deepest(self.section.parameters, added.name)
        origin = added.origin
        after = origin.path[-1][1] if origin and origin.path and origin.path[-1][0] is parent else None
        edits.insert(parent, f"{key}: {added.value}", after=after)

    def _change(self, edits: MapEdits, parameter: _Parameter) -> None:
        _, entry = parameter.path[-1]
        old = ".".join(one.key.text for _, one in parameter.path)
        if parameter.todo:
            self._remark(edits, parameter)
        if not parameter.name:
            edits.drop(parameter.path)
            return
        if parameter.value is not None:
            edits.replace(entry.value, parameter.value)
        if parameter.name == old:
            return
        before = old.removesuffix(entry.key.text)
        if parameter.name.startswith(before):
            edits.replace(entry.key, parameter.name.removeprefix(before))
            return
        value = self.source.data[entry.value.start : entry.value.end].decode("utf-8", "surrogateescape")
        other, key = deepest(self.section.parameters, parameter.name)
        edits.insert(other, f"{key}: {parameter.value or value}")
        edits.drop(parameter.path)

    def _remark(self, edits: MapEdits, parameter: _Parameter) -> None:
        """Write a TODO in place of a parameter."""
        parent, entry = parameter.path[-1]
        if self.source.data[parent.start : parent.start + 1] != b"{":
            edits.insert(parent, todo_line(self.source.path, parameter.todo), after=entry)


def _element(pattern: str, name: str) -> str | None:
    """What the placeholder of a parameter's name stands for; empty without one, None if the name is another."""
    if "<" not in pattern:
        return "" if pattern == name else None
    before, _, rest = pattern.partition("<")
    after = rest.partition(">")[2]
    fits = name.startswith(before) and name.endswith(after) and len(name) > len(before) + len(after)
    return name[len(before) : len(name) - len(after)] if fits else None


def _converted(value: object, parameter: _Parameter) -> str | None:
    """A new value as YAML; None for the same one, or if it cannot be known."""
    if value == "same":
        return None
    if value != "negative":
        return as_yaml(value)
    text = parameter.text or ""
    if not re.fullmatch(r"[+-]?[\d.][\d.eE+-]*|[+-]?\.inf", text):
        return None
    return text[1:] if text.startswith("-") else f"-{text.removeprefix('+')}"


# -- the moves of a type -----------------------------------------------------------------------------------------------


def _moves_for(name: str, target: str) -> list[Move]:
    """The moves of a controller's parameters: those of the data, then those that the catalogue's entry says."""
    if not name:
        return []
    known = [move for move in parameter_moves() if move.is_for(name)]
    kind = None if name == MANAGER else CATALOG.controller(name, target)
    return [*known, *(_of_catalogue(kind, {move.name for move in known}) if kind else ())]


def _of_catalogue(kind: ControllerType, known: Iterable[str]) -> Iterator[Move]:
    """Yield a move for each parameter that the catalogue calls renamed or removed."""
    for name, former in kind.former.items():
        is_past = former.last_version or (former.distros and ROS2.index(former.distros[-1]) < ROS2.index(kind.distro))
        if name in known or not is_past:
            continue
        since = _first_after(former.distros, kind.distro)
        if former.replacement is None:
            yield Move((kind.type,), name, since, _because(former.note))
        elif re.fullmatch(_PLAIN_NAME, former.replacement) and matching(former.replacement, kind.parameters):
            yield Move((kind.type,), name, since, _because(former.note), becomes={former.replacement: "same"})


def _because(note: str | None) -> str:
    return f"{_CATALOGUE}; {note}" if note else _CATALOGUE


def _first_after(distros: Sequence[str], target: str) -> str:
    """The first distro after some others, up to the target."""
    later = ROS2[ROS2.index(distros[-1]) + 1 :] if distros else ()
    return later[0] if later else target


def _rows() -> tuple[Row, ...]:
    """The rows of the table: the moves of the data, each once."""
    return tuple(dict.fromkeys(map(_row, parameter_moves())))


def _row(move: Move) -> Row:
    value = f": {as_yaml(move.when.value)}" if move.when and not move.when.param else ""
    new = ", ".join(in_words(name, to) for name, to in move.becomes.items())
    new = f"the old default, {new}" if move.is_default else new
    return Row(f"{_short(move)}: {move.name}{value}", new, move.since, move.authority)


def _short(move: Move) -> str:
    return ", ".join(name.partition("/")[0] for name in move.controllers)


PARAMETERS = Step(
    name="parameters",
    part=Part.YAML,
    summary="Parameters of controllers and of the controller manager",
    propose=_parameters,
    rows=_rows(),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base:
                      type: diff_drive_controller/DiffDriveController
                base:
                  ros__parameters:
                    left_wheel_names: [left]
                    right_wheel_names: [right]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
                    linear.x.has_velocity_limits: true
                    linear.x.max_velocity: 0.5
                    use_stamped_vel: false
            """,
        },
    ],
    after=[
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base:
                      type: diff_drive_controller/DiffDriveController
                base:
                  ros__parameters:
                    left_wheel_names: [left]
                    right_wheel_names: [right]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
                    linear.x.max_velocity: 0.5
                    # TODO(urdfctl): the controller now reads TwistStamped on ~/cmd_vel, no longer Twist on ~/cmd_vel_unstamped: change what publishes it (in Nav2: enable_stamped_cmd_vel: true)
            """,
        },
    ],
)
