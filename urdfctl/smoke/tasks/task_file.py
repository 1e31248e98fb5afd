"""The user's own tasks for controllers, from a YAML file: targets, trajectories, velocities and drives."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from typing import Any

from urdfctl.errors import UserError
from urdfctl.names import did_you_mean, nearest_path
from urdfctl.smoke.robot import Mechanism
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.span import Place, SourceText
from urdfctl.source.yaml.tree import Mapping as YamlMap
from urdfctl.source.yaml.tree import Node, Scalar, Sequence, read_yaml
from urdfctl.source.yaml.types import typed_by_pyyaml
from urdfctl.startup.records import NamedTuple

MOST_SECONDS = 60.0
"""A task takes at most this long, in s."""
_MOST_BYTES = 1 << 20
WITHIN = 2.0
"""The default time to reach a target or a velocity, in s."""
KINDS = ("target", "trajectory", "velocity", "drive")
_TOLERANCES = ("tolerance", "path_tolerance", "angle_tolerance")
_KEYS = {
    "target": ("within", *_TOLERANCES[:2]),
    "trajectory": _TOLERANCES[:2],
    "velocity": ("within", "tolerance"),
    "drive": (_TOLERANCES[0], _TOLERANCES[2]),
}


class TaskStep(NamedTuple):
    """A part of a task: what should be the case some seconds after its start.

    `values` holds positions (rad or m) or velocities (rad/s or m/s) of joints by name; of a drive the speeds `forward`
    (m/s) and `turn` (rad/s, to the left) until then. `line` is its line in the file.
    """

    until: float
    values: tuple[tuple[str, float], ...]
    line: int


class UserTask(NamedTuple):
    """The task that a user gives a controller, instead of the motion that the smoke test chooses.

    controller: its name, as reports show it.
    kind: one of KINDS.
    steps: what should be the case when.
    at: the span of its key in the file, in bytes.
    tolerance: how far the end may be off, in rad, m, rad/s or m/s; None if it is not given, as the others.
    path_tolerance: how far the way may be off, in rad or m.
    angle_tolerance: how far the direction of a base may be off, in rad.
    """

    controller: str
    kind: str
    steps: tuple[TaskStep, ...]
    at: tuple[int, int]
    tolerance: float | None = None
    path_tolerance: float | None = None
    angle_tolerance: float | None = None

    @property
    def seconds(self) -> float:
        """How long it takes, in s."""
        return self.steps[-1].until

    @property
    def subject(self) -> str:
        """The subject of findings about it."""
        return f"task:{self.controller}"

    @classmethod
    def from_json(cls, data: list[Any]) -> UserTask:
        """Return the task that a list of plain data holds."""
        steps = tuple(TaskStep(until, tuple((n, v) for n, v in values), line) for until, values, line in data[2])
        names = ("tolerance", "path_tolerance", "angle_tolerance")
        return cls(data[0], data[1], steps, (data[3][0], data[3][1]), **dict(zip(names, data[4:], strict=True)))


class TaskFile(NamedTuple):
    """A file with the user's own tasks.

    start: the positions of joints at spawn, in rad or m, each with its line.
    user_tasks: one for each controller that is in the file.
    """

    path: str
    text: str
    start: tuple[tuple[str, float, int], ...] = ()
    user_tasks: tuple[UserTask, ...] = ()

    @classmethod
    def from_json(cls, data: list[Any]) -> TaskFile:
        """Return the file that a list of plain data holds."""
        start = tuple((name, value, line) for name, value, line in data[2])
        return cls(data[0], data[1], start, tuple(map(UserTask.from_json, data[3])))

    def place_of(self, user_task: UserTask) -> Place:
        """Return the place of a task in the file."""
        return Place(SourceText(self.path, self.text.encode()), user_task.at[0], end=user_task.at[1])

    def line_of(self, user_task: UserTask) -> int:
        """Return the line of a task in the file."""
        return self.text.encode()[: user_task.at[0]].count(b"\n") + 1

    def started(self, mechanism: Mechanism) -> Mechanism:
        """Return a robot that is spawned in the pose of the file."""
        given = {name: value for name, value, _ in self.start}
        hinges = (hinge._replace(initial=given.get(hinge.name, hinge.initial)) for hinge in mechanism.hinges)
        return mechanism._replace(hinges=tuple(hinges)) if given else mechanism


def read_tasks(path: str) -> TaskFile:
    """Return the tasks in a file. UserError if there is no such file, or it is no file of tasks: at file:line."""
    if not os.path.isfile(path):
        raise UserError(f"file does not exist: '{path}'{nearest_path(path)}")
    source = SourceText(os.path.abspath(path), first_bytes(path, _MOST_BYTES))
    file = read_yaml(source)
    reader = _TaskFileReader(path, source)
    for problem in (*file.problems, *file.refused_tags):
        raise reader.wrong(problem.at, problem.message)
    if len(file.documents) != 1:
        raise UserError(f"{path}:1: a file of tasks needs one document, with the key 'controllers'")
    start, user_tasks = reader.whole(file.documents[0])
    return TaskFile(source.path, source.data.decode("utf-8", "replace"), start, user_tasks)


class _TaskFileReader:
    """Reads the nodes of one file; what is wrong is an error with file and line."""

    def __init__(self, path: str, source: SourceText) -> None:
        self._path, self._source = path, source

    def wrong(self, at: Place, message: str) -> UserError:
        return UserError(f"{self._path}:{self._line(at)}: {message}")

    def _line(self, at: Place) -> int:
        return self._source.position(at.start).line

    def whole(self, root: Node) -> tuple[tuple[tuple[str, float, int], ...], tuple[UserTask, ...]]:
        top = self._entries(root, ("start", "controllers"), "a file of tasks")
        start = self._values(top["start"]) if "start" in top else ()
        lines = tuple(self._line(entry.key.at) for entry in self._map(top["start"]).entries) if "start" in top else ()
        tasks = self._map(top["controllers"]).entries if "controllers" in top else ()
        if not start and not tasks:
            raise self.wrong(root.at, "no tasks: give 'controllers', 'start' or both")
        user_tasks = tuple(self._user_task(entry.key, entry.value) for entry in tasks)
        return tuple((*value, line) for value, line in zip(start, lines, strict=True)), user_tasks

    def _user_task(self, key: Scalar, node: Node) -> UserTask:
        given = self._entries(node, (*KINDS, "within", *_TOLERANCES), f"the task of '{key.text}'")
        kinds = [kind for kind in KINDS if kind in given]
        if len(kinds) != 1:
            raise self.wrong(key.at, f"controller '{key.text}' needs one of {', '.join(KINDS)}")
        [kind] = kinds
        for name in given:
            if name != kind and name not in _KEYS[kind]:
                raise self.wrong(given[name].at, f"'{name}' has no meaning beside '{kind}'")
        tolerances = {name: self._positive(given[name]) for name in _TOLERANCES if name in given}
        within = self._positive(given["within"]) if "within" in given else WITHIN
        steps = self._steps(kind, given[kind], within)
        if steps[-1].until > MOST_SECONDS:
            raise self.wrong(key.at, f"the task of '{key.text}' takes {steps[-1].until:g} s; at most {MOST_SECONDS:g}")
        return UserTask(key.text, kind, steps, (key.start, key.end), **tolerances)

    def _steps(self, kind: str, node: Node, within: float) -> tuple[TaskStep, ...]:
        if kind in ("target", "velocity"):
            return (TaskStep(within, self._values(node), self._line(node.at)),)
        if not isinstance(node, Sequence) or not node.items:
            raise self.wrong(node.at, f"'{kind}' must be a list of steps")
        steps: list[TaskStep] = []
        for item in node.items:
            before = steps[-1].until if steps else 0.0
            steps.append(self._leg(item, before) if kind == "drive" else self._point(item, before))
        return tuple(steps)

    def _point(self, item: Node, before: float) -> TaskStep:
        given = self._entries(item, ("at", "joints"), "a point of a trajectory", needed=("at", "joints"))
        until = self._positive(given["at"])
        if until <= before:
            raise self.wrong(given["at"].at, f"'at' must rise from point to point: {until:g} s after {before:g} s")
        return TaskStep(until, self._values(given["joints"]), self._line(item.at))

    def _leg(self, item: Node, before: float) -> TaskStep:
        given = self._entries(item, ("for", "forward", "turn"), "a step of a drive", needed=("for",))
        speeds = tuple((name, self._number(given[name])) for name in ("forward", "turn") if name in given)
        return TaskStep(before + self._positive(given["for"]), speeds, self._line(item.at))

    def _values(self, node: Node) -> tuple[tuple[str, float], ...]:
        entries = self._map(node).entries
        if not entries:
            raise self.wrong(node.at, "expects joints with numbers: {elbow: 0.5}")
        return tuple((entry.key.text, self._number(entry.value)) for entry in entries)

    def _map(self, node: Node) -> YamlMap:
        if not isinstance(node, YamlMap):
            raise self.wrong(node.at, "expects names with values: {name: value}")
        return node

    def _entries(self, node: Node, known: Iterable[str], what: str, needed: Iterable[str] = ()) -> dict[str, Node]:
        given = {entry.key.text: entry for entry in self._map(node).entries}
        for name, entry in given.items():
            if name not in known:
                raise self.wrong(entry.key.at, f"{what} has no '{name}'{did_you_mean(name, known)}")
        missing = next((name for name in needed if name not in given), None)
        if missing:
            raise self.wrong(node.at, f"{what} needs '{missing}'")
        return {name: entry.value for name, entry in given.items()}

    def _number(self, node: Node) -> float:
        value = typed_by_pyyaml(node).value if isinstance(node, Scalar) else None
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            raise self.wrong(node.at, f"expects a number, not '{node.text if isinstance(node, Scalar) else '...'}'")
        return float(value)

    def _positive(self, node: Node) -> float:
        value = self._number(node)
        if value <= 0:
            raise self.wrong(node.at, f"expects a number above 0, not {value:g}")
        return value
