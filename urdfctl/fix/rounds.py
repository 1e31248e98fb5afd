"""From the findings of a run to the bytes that its files should hold: chooses edits, tries them, and goes on with what
is left, until nothing changes. Nothing is written here."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial

from urdfctl.diagnostic import Diagnostic
from urdfctl.fix.edits import Splice, Taken, edited
from urdfctl.fix.files import EditableFiles
from urdfctl.fix.trial import Verdict, perform_with, splices_of, texts
from urdfctl.hints import Any
from urdfctl.jobs import job_for, shared_loader
from urdfctl.lint import Linted, Selection
from urdfctl.load import Target
from urdfctl.record import NamedTuple
from urdfctl.settings import Settings
from urdfctl.worker import Died, Limits, processors, run

MOST_ROUNDS = 20
MOST_TRIALS = 400
_CHANGED = "the file has changed since it was linted"


class Change(NamedTuple):
    """What a file holds and what it should hold; the file is named by its real path."""

    file: str
    before: bytes
    after: bytes


class Fixed(NamedTuple):
    """What came of fixing: the files to be changed, what would be left to find then, and what was not done, and why."""

    changes: tuple[Change, ...]
    linted: tuple[Linted, ...]
    refused: tuple[str, ...]


class Suggestion(NamedTuple):
    """The edits of one fix, the first finding that asks for them, and the robot it was found in."""

    finding: Diagnostic
    splices: tuple[Splice, ...]
    target: Target

    @property
    def files(self) -> set[str]:
        """The files that the edits are in."""
        return {splice.file for splice in self.splices}


def _nothing(_file: str, _code: str) -> bool:
    return False


class Wishes(NamedTuple):
    """What the user wants to be mended: the findings of some rules, but for those that are ignored in a file; and
    whether also what is not surely meant."""

    selection: Selection = Selection()
    ignores: Callable[[str, str], bool] = _nothing
    unsafe: bool = False

    def admits(self, finding: Diagnostic) -> bool:
        """Whether a finding is one to be mended."""
        return self.selection.admits(finding.code) and not self.ignores(finding.at.file, finding.code)


def fixed(
    linted: Sequence[tuple[Target, Linted]], settings: Settings, wishes: Wishes, parallel: int | None = None
) -> Fixed:
    """What fixing makes of some linted robots: all of one run, for what they share is only changed where all agree."""
    mending = _Mending(linted, settings, wishes, parallel or processors())
    for _ in range(MOST_ROUNDS):
        suggestions = mending.suggestions()
        if not suggestions:
            break
        mending.round(suggestions)
    return mending.result()


class _Mending:
    """The state of one run of rounds."""

    def __init__(
        self,
        linted: Sequence[tuple[Target, Linted]],
        settings: Settings,
        wishes: Wishes,
        parallel: int,
    ) -> None:
        self.targets = [target for target, _ in linted]
        self.linted = [one for _, one in linted]
        self.settings, self.wishes, self.parallel = settings, wishes, parallel
        # whatever the user wants to be told of, no rule may find anything new
        self.judges = wishes.selection._replace(select=())
        self.loader = shared_loader(self.targets, settings, self.judges)
        self.files = EditableFiles(settings)
        self.refused: dict[frozenset[Splice], str] = {}
        self.trials = 0
        self._read = [{os.path.realpath(file) for file in one.files} for one in self.linted]

    # -- what is suggested -------------------------------------------------------------------------------------------

    def suggestions(self) -> list[Suggestion]:
        """What the findings ask for and was not refused, in their order; of edits that clash the first."""
        found: dict[frozenset[Splice], Suggestion] = {}
        unsafe = set()
        for target, finding in self._findings():
            splices = splices_of(finding)
            key = frozenset(splices)
            if finding.fix and not finding.fix.safe:
                unsafe.add(key)
            if key not in found or finding.order < found[key].finding.order:
                found[key] = Suggestion(finding, splices, target)
        taken = Taken()
        in_order = sorted(found.items(), key=lambda item: item[1].finding.order)
        wanted = [
            (key, one) for key, one in in_order if key not in self.refused and (self.wishes.unsafe or key not in unsafe)
        ]
        return [one for key, one in wanted if self._is_editable(one) and taken.take(one.splices)]

    def _findings(self) -> Iterator[tuple[Target, Diagnostic]]:
        for target, linted in zip(self.targets, self.linted, strict=True):
            for finding in linted.outcome.diagnostics:
                if finding.fix and finding.fix.edits and self.wishes.admits(finding):
                    yield target, finding

    def _is_editable(self, suggestion: Suggestion) -> bool:
        for file in sorted(suggestion.files):
            why = self.files.why_not(file, suggestion.target)
            if why:
                self._refuse(suggestion, why)
                return False
        if any(splice.end > len(self.files.now[splice.file]) for splice in suggestion.splices):
            self._refuse(suggestion, _CHANGED)
            return False
        return True

    # -- what is tried -----------------------------------------------------------------------------------------------

    def round(self, suggestions: Sequence[Suggestion]) -> None:
        """Keep those of some suggestions that nothing speaks against."""
        kept: list[Suggestion] = []
        pending = [list(suggestions)]
        while pending:
            group = pending.pop()
            objections = self._try(kept, group)
            if not objections:
                kept += group
            elif len(group) == 1:
                self._refuse(group[0], objections[0])
            else:
                middle = len(group) // 2
                pending += [group[middle:], group[:middle]]
        if kept:
            self.files.now.update(self._edited(kept))
            self.refused.clear()  # their offsets have moved, and what spoke against them may be gone

    def _try(self, kept: Sequence[Suggestion], group: Sequence[Suggestion]) -> list[str]:
        """What speaks against a group of suggestions beside those that are kept. Where nothing does, what is found then
        is the state of things."""
        self.trials += 1
        if self.trials > MOST_TRIALS:
            return ["too many others had to be tried: run it again"]
        after = {**self.files.now, **self._edited([*kept, *group])}
        changed = set().union(*(suggestion.files for suggestion in group))
        splices = frozenset(splice for suggestion in (*kept, *group) for splice in suggestion.splices)
        concerned = [index for index, files in enumerate(self._read) if files & changed]
        verdicts: dict[int, Verdict] = {}
        for index, verdict in zip(concerned, self._verdicts(concerned, after, splices), strict=True):
            if verdict.objections:
                return list(verdict.objections)
            verdicts[index] = verdict
        asked_for = frozenset[Splice]().union(*(verdict.asked_for for verdict in verdicts.values()))
        if any(not asked_for.issuperset(suggestion.splices) for suggestion in group):
            return [_CHANGED]
        for index, verdict in verdicts.items():
            self.linted[index] = verdict.linted or self.linted[index]
        return []

    def _edited(self, suggestions: Iterable[Suggestion]) -> dict[str, bytes]:
        splices: dict[str, set[Splice]] = {}
        for suggestion in suggestions:
            for splice in suggestion.splices:
                splices.setdefault(splice.file, set()).add(splice)
        return {file: edited(self.files.now[file], own) for file, own in splices.items()}

    def _verdicts(
        self, concerned: Sequence[int], after: Mapping[str, bytes], splices: Iterable[Splice]
    ) -> Iterator[Verdict]:
        jobs: list[dict[str, Any]] = []
        for index in concerned:
            files = sorted(self._read[index] & set(after))
            states = {"before": texts(self.files.now, files), "after": texts(after, files)}
            own = sorted(splice for splice in splices if splice.file in files)
            job = job_for(self.targets[index], self.settings, self.judges)
            jobs.append({**job, **states, "splices": [list(splice) for splice in own]})
        limits = Limits(2 * self.settings.timeout, self.settings.memory, self.settings.environ)
        perform = partial(perform_with, self.loader)
        for result in run(jobs, perform, limits, self.parallel, fresh="urdfctl.fix.trial:perform"):
            if isinstance(result, Died):
                yield Verdict((f"what would become of it cannot be linted: {result.why}",), frozenset(), None)
            else:
                yield Verdict.from_json(result)

    def _refuse(self, suggestion: Suggestion, why: str) -> None:
        finding = suggestion.finding
        place = f"{finding.at.file}:{finding.at.line}:{finding.at.column}"
        self.refused[frozenset(suggestion.splices)] = f"{place}: {finding.code} is not fixed: {why}"

    def result(self) -> Fixed:
        """What is to be changed, and what would be left."""
        files = self.files
        changes = (Change(file, files.read[file], after) for file, after in files.now.items())
        return Fixed(
            tuple(change for change in sorted(changes) if change.before != change.after),
            tuple(self._selected(linted) for linted in self.linted),
            tuple(sorted(self.refused.values())),
        )

    def _selected(self, linted: Linted) -> Linted:
        found = [one for one in linted.outcome.diagnostics if self.wishes.selection.admits(one.code)]
        return linted._replace(outcome=linted.outcome._replace(diagnostics=found))
