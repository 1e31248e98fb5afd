"""What can be written among the arguments of a spawner: controllers, managers, and options with their values."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.control.parameters.spawner_options import DISTROS
from urdfctl.load.loader import LoadedTarget
from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.names import CONTROLLER
from urdfctl.server.analysis.question import Question

_OF_MANAGERS = frozenset({"-c", "--controller-manager"})
_WITH_VALUES = frozenset(
    "-n --namespace -t --controller-type -p --param-file --controller-manager-timeout --switch-timeout "
    "--service-call-timeout --controller-ros-args --ros-args".split()
)
OF_SPAWNER = frozenset({CONTROLLER, "option", "value"})
"""The kinds of items among the arguments of a spawner. Each replaces one of them, not the whole text."""
_ARGUMENTS = r"arguments\s*=\s*\[(?P<before>[^\[\]]*?)(?P<quote>[\"'])(?P<word>[^\"'\[\],]*)$"
_NODE = r"\b(?:Node|ExecuteProcess)\s*\("


def in_python(question: Question) -> Iterator[OfferedItem]:
    """Yield what can be written in a launch file in Python: the arguments of a spawner."""
    data = question.source.data
    before = data[: question.offset].decode("utf-8", "replace")
    nodes = [found.start() for found in re.finditer(_NODE, before)]
    node = before[nodes[-1] :] if nodes else ""
    found = re.search(_ARGUMENTS, node)
    after = data[question.offset :][:2000].decode("utf-8", "replace")
    if found is None:
        return
    rest = after.partition("]")[0]
    is_spawner = "spawner" in node or "spawner" in after[: (re.search(_NODE, after) or re.search(r"\Z", after)).start()]  # type: ignore[union-attr]
    words = [one[1] or one[2] for one in re.finditer(r"\"([^\"]*)\"|'([^']*)'", found["before"])]
    later = [one[1] or one[2] for one in re.finditer(r"\"([^\"]*)\"|'([^']*)'", rest.partition(found["quote"])[2])]
    if is_spawner:
        yield from _arguments(question, words, found["word"], later)


def in_spawner(question: Question, typed: str, *, is_spawner: bool) -> Iterator[OfferedItem]:
    """Yield what can be written in `args` of a node in XML. typed: the text of the attribute up to the place."""
    after = question.source.data[question.offset :][:1000].decode("utf-8", "replace")
    if not is_spawner and "spawn" not in after.partition(">")[0]:
        return
    *words, word = re.split(r"\s+", typed)
    later = re.split(r"\s+", re.split(r"[\"']", after)[0])[1:]
    yield from _arguments(question, [one for one in words if one], word, [one for one in later if one])


def _arguments(question: Question, words: Sequence[str], word: str, later: Sequence[str]) -> Iterator[OfferedItem]:
    last = words[-1] if words else ""
    for robot in question.robots:
        if last in _OF_MANAGERS:
            yield from (OfferedItem(name, "value", replaces=len(word)) for name in _managers(robot))
        elif last not in _WITH_VALUES:
            yield from _controllers(robot, {*words, *later}, len(word))
            yield from _options(robot, {*words, *later}, len(word), is_last=not later)


def _managers(robot: LoadedTarget) -> Iterator[str]:
    controllers = robot.project.controllers
    for controller in controllers.controllers if controllers else ():
        if controller.namespace is not None:
            yield f"{controller.namespace}/controller_manager"


def _controllers(robot: LoadedTarget, taken: set[str], typed: int) -> Iterator[OfferedItem]:
    """The declared controllers that no spawner starts yet; all if each is started."""
    project = robot.project
    declared = project.controllers.controllers if project.controllers else ()
    spawned = {name for spawn in (project.launch.spawns if project.launch else ()) for name, _ in spawn.names}
    names = [one.name for one in declared if one.declared_at is not None and one.name not in taken]
    free = [name for name in names if name not in spawned]
    yield from (OfferedItem(name, CONTROLLER, replaces=typed) for name in free)


def _options(robot: LoadedTarget, taken: set[str], typed: int, *, is_last: bool) -> Iterator[OfferedItem]:
    """The options that the spawner has in each distro that the robot may be for. One with a value is offered last."""
    distros = robot.project.distros
    for name, known in DISTROS.items():
        is_possible = (
            name.startswith("--") and name != "--help" and (is_last or name not in _OF_MANAGERS | _WITH_VALUES)
        )
        if is_possible and name not in taken and distros and set(distros) <= set(known):
            yield OfferedItem(name, "option", f"an option of the spawner in {', '.join(distros)}", typed)
