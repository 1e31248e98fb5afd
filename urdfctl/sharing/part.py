"""What one of two processes finds of a robot, and how it tells the other."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator

from urdfctl.diagnostic import Diagnostic
from urdfctl.hints import Any
from urdfctl.lint import Found, Outcome, Selection, found_by, outcome_of
from urdfctl.model.project import Project
from urdfctl.rules import FAMILIES
from urdfctl.serialise import diagnostic_from_json, diagnostic_to_json
from urdfctl.source.span import SourceSpan
from urdfctl.source.suppressions import Suppressed


class Part:
    """The findings of some families of rules, by the family's number among all."""

    def __init__(self, project: Project, suppressed: Suppressed, selection: Selection) -> None:
        self.project, self.suppressed, self.selection = project, suppressed, selection
        self._found: dict[int, Found] = {}

    def work(self, numbers: Iterable[int]) -> None:
        """Load and ask family after family."""
        for number in numbers:
            family = FAMILIES[number]
            rules = family.load() if family.concerns(self.project) else ()
            self._found[number] = found_by(rules, self.project, self.suppressed, self.selection)

    def work_on_what_is_left(self) -> None:
        """Ask those families that nobody has told of."""
        self.work(number for number in range(len(FAMILIES)) if number not in self._found)

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

    def outcome(self, reached: Callable[[SourceSpan], bool]) -> Outcome:
        """What `lint` gives, the findings in the same order."""
        found = Found(list(self._diagnostics()), any(one.crashed for one in self._found.values()))
        return outcome_of(found, self.project, self.suppressed, self.selection, reached)

    def _diagnostics(self) -> Iterator[Diagnostic]:
        for _, one in sorted(self._found.items()):
            yield from one.diagnostics
