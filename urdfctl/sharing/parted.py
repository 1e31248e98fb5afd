"""A large robot: a process parts in two when the rules begin, and each takes the next family that nobody has taken.

A family's import takes as long as its answer, and both are done twice as fast. What the other process does not live to
tell is found again here.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable, Iterator, Sequence

from urdfctl.lint import Outcome, Selection
from urdfctl.model.project import Project
from urdfctl.rules import FAMILIES
from urdfctl.sharing.part import Part
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.suppressions import Suppressed

if sys.platform == "win32":
    raise NotImplementedError

_LONGEST_FIRST = ("UC4", "UC1", "UC5", "UC2", "UC3")


def lint_parted(
    project: Project, sources: Sequence[SourceText], selection: Selection, reached: Callable[[SourceSpan], bool]
) -> Outcome:
    """What `lint` gives, from two processes; from one where no more may be made."""
    part = Part(project, Suppressed(list(sources)), selection)
    untaken = _offered(sorted(range(len(FAMILIES)), key=_turn_of))
    reading, writing = os.pipe()
    seconds = signal.getitimer(signal.ITIMER_REAL)[0]
    try:
        pid = os.fork()
    except OSError:
        pid = None
    if pid == 0:  # pragma: no cover (what it runs is all counted in the process that it parted from)
        _do_a_part(part, untaken, writing, seconds)
    os.close(writing)
    try:
        part.work(_taken(untaken))
        with os.fdopen(reading, "rb") as telling:
            part.learn(telling.read())
        part.work_on_what_is_left()
    finally:
        if pid is not None:
            os.kill(pid, signal.SIGKILL)
            os.waitpid(pid, 0)
    return part.outcome(reached)


def _do_a_part(part: Part, untaken: int, pipe: int, seconds: float) -> None:  # pragma: no cover (in the other process)
    """Do a part, tell of it, and be gone, whatever happens. A fork has its parent's handler of alarms, but no alarm."""
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds)
        part.work(_taken(untaken))
        with os.fdopen(pipe, "wb") as telling:
            telling.write(part.told())
    finally:
        os._exit(0)


def _offered(numbers: Sequence[int]) -> int:
    """A pipe with the numbers of families: who reads one has taken it."""
    reading, writing = os.pipe()
    os.write(writing, bytes(numbers))
    os.close(writing)
    return reading


def _taken(offered: int) -> Iterator[int]:
    """Families that nobody else has taken, one after the other."""
    for number in iter(lambda: os.read(offered, 1), b""):
        yield number[0]
    os.close(offered)


def _turn_of(number: int) -> int:
    prefix = FAMILIES[number].prefix
    return _LONGEST_FIRST.index(prefix) if prefix in _LONGEST_FIRST else len(_LONGEST_FIRST)
