"""Lints one robot in two processes at once, where it is the only one and there are processors for both.

Each takes the next family of rules that nobody has taken, and loads and asks it: a family's import takes as long as its
answer. What the other process finds comes back as JSON; what it does not live to tell is found again here.
"""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from urdfctl.lint import Found, Outcome, Selection, found_by, lint, outcome_of
from urdfctl.model.project import Project
from urdfctl.rules import FAMILIES, Family
from urdfctl.serialise import diagnostic_from_json, diagnostic_to_json
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.suppressions import Suppressed

_LONGEST_FIRST = ("UC4", "UC1", "UC5", "UC2", "UC3")


def lint_in_two(
    project: Project, sources: Sequence[SourceText], selection: Selection, reached: Callable[[SourceSpan], bool]
) -> Outcome:
    """What `lint` gives, the findings in the same order."""
    families = [family for family in FAMILIES if family.concerns(project)]
    if len(families) < 2:  # noqa: PLR2004 (one is done as soon alone)
        return lint(project, sources, selection, reached=reached)
    part = _Part(project, families, Suppressed(list(sources)), selection)
    reading, writing = os.pipe()
    seconds = signal.getitimer(signal.ITIMER_REAL)[0]
    pid = os.fork()
    if pid == 0:  # pragma: no cover (what it runs is all counted in the process that it parted from)
        _leave_after(part, writing, seconds)
    os.close(writing)
    try:
        part.work()
        with os.fdopen(reading, "rb") as told:
            part.learn(told.read())
        part.work_on_what_is_left()
    finally:
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
    return outcome_of(part.found(), project, part.suppressed, selection, reached)


def _leave_after(part: _Part, pipe: int, seconds: float) -> None:  # pragma: no cover (runs in the other process)
    """Do a part, tell of it, and be gone, whatever happens. A fork has its parent's handler of alarms, but no alarm."""
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds)
        part.work()
        with os.fdopen(pipe, "wb") as telling:
            telling.write(part.told())
    finally:
        os._exit(0)


class _Part:
    """What one of the processes has found so far, by the number of the family."""

    def __init__(
        self, project: Project, families: Sequence[Family], suppressed: Suppressed, selection: Selection
    ) -> None:
        self.project, self.families, self.suppressed, self.selection = project, families, suppressed, selection
        self._found: dict[int, Found] = {}
        longest = sorted(range(len(families)), key=lambda number: _length_of(families[number]))
        self._untaken, writing = os.pipe()
        os.write(writing, bytes(longest))
        os.close(writing)

    def work(self) -> None:
        """Ask family after family, as long as there is one that nobody has taken."""
        for number in iter(lambda: os.read(self._untaken, 1), b""):
            self._ask(number[0])
        os.close(self._untaken)

    def work_on_what_is_left(self) -> None:
        """Ask those that somebody has taken and told nothing of."""
        for number in range(len(self.families)):
            if number not in self._found:
                self._ask(number)

    def _ask(self, number: int) -> None:
        rules = self.families[number].load()
        self._found[number] = found_by(rules, self.project, self.suppressed, self.selection)

    def told(self) -> bytes:
        """All that was found here, as JSON."""
        found = [
            [number, [diagnostic_to_json(diagnostic) for diagnostic in one.diagnostics], one.crashed]
            for number, one in self._found.items()
        ]
        return json.dumps({"found": found, "silencing": sorted(self.suppressed.used)}).encode()

    def learn(self, told: bytes) -> None:
        """Add what the other process told; nothing where it did not come to an end."""
        if not told:
            return
        read: dict[str, Any] = json.loads(told)
        self.suppressed.used.update(read["silencing"])
        for number, diagnostics, crashed in read["found"]:
            self._found[number] = Found([diagnostic_from_json(one) for one in diagnostics], crashed)

    def found(self) -> Found:
        """The findings of all families, in their order."""
        return Found(list(self._diagnostics()), any(one.crashed for one in self._found.values()))

    def _diagnostics(self) -> Iterator[Any]:
        for _, one in sorted(self._found.items()):
            yield from one.diagnostics


def _length_of(family: Family) -> int:
    return _LONGEST_FIRST.index(family.prefix) if family.prefix in _LONGEST_FIRST else len(_LONGEST_FIRST)
