"""Choose and try the fixes of a run's findings, in rounds, until nothing changes. No file is written here."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic
from urdfctl.fix.edits import Splice, Taken, edited
from urdfctl.fix.files import EditableFiles
from urdfctl.fix.trial import TrialResult, splices_of, texts, trial_work
from urdfctl.lint.job import Workers, run_on_targets, shared_loader
from urdfctl.lint.results import TargetResult
from urdfctl.lint.selection import Selection
from urdfctl.load.target import Target
from urdfctl.output.change import Change
from urdfctl.run.limits import WorkerFailure, processors
from urdfctl.startup.records import NamedTuple

MOST_ROUNDS = 20
MOST_TRIALS = 400
MOST_ALIKE = 10
"""Fixes of one rule that are tried alone and refused for one kind of reason; more of them are refused together."""
_CHANGED = "the file has changed since it was linted"


class Fixed(NamedTuple):
    """The result of fixing."""

    changes: tuple[Change, ...]
    """The files to write."""
    linted: tuple[TargetResult, ...]
    """The findings that remain after the changes."""
    refused: tuple[str, ...]
    """A message for each fix that was refused, with the reason."""
    remarks: tuple[str, ...] = ()
    """A message for each warning that came in the place of an error."""


class Suggestion(NamedTuple):
    """The edits of one fix, the first finding with this fix, and the robot of that finding."""

    finding: Diagnostic
    splices: tuple[Splice, ...]
    target: Target

    @property
    def files(self) -> set[str]:
        """The files that the edits change."""
        return {splice.file for splice in self.splices}


def _nothing(_file: str, _code: str) -> bool:
    return False


class FixOptions(NamedTuple):
    """The findings that the user wants to fix."""

    selection: Selection = Selection()
    """The selected rules."""
    ignores: Callable[[str, str], bool] = _nothing
    """Whether a file, given by its path, ignores a code."""
    unsafe: bool = False
    """Whether unsafe fixes are applied too."""

    def admits(self, finding: Diagnostic) -> bool:
        """Return whether the user wants to fix a finding."""
        return self.selection.admits(finding.code) and not self.ignores(finding.at.file, finding.code)


def fixed(
    linted: Sequence[tuple[Target, TargetResult]],
    settings: Settings,
    options: FixOptions,
    parallel: int | None = None,
) -> Fixed:
    """Return the result of fixing all robots of a run. A shared file is changed only if the fix suits all of them."""
    mending = _Mending(linted, settings, options, parallel or processors())
    for _ in range(MOST_ROUNDS):
        suggestions = mending.suggestions()
        if not suggestions:
            break
        mending.round(suggestions)
    return mending.result()


def _kind_of(objection: str) -> str:
    """An objection without the names in it."""
    return objection.partition(" (")[0]


class _Mending:
    """The state of one run of rounds."""

    def __init__(
        self,
        linted: Sequence[tuple[Target, TargetResult]],
        settings: Settings,
        options: FixOptions,
        parallel: int,
    ) -> None:
        self.targets = [target for target, _ in linted]
        self.linted = [result for _, result in linted]
        self.settings, self.options, self.parallel = settings, options, parallel
        # a fix must not cause a new finding of any rule, whether selected or not
        self.judges = options.selection._replace(select=())
        self.loader = shared_loader(self.targets, settings)
        self.files = EditableFiles(settings)
        self.refused: dict[frozenset[Splice], str] = {}
        self.remarks: dict[str, None] = {}
        self.trials = 0
        self.alike: Counter[tuple[str, str]] = Counter()
        self._read = [{os.path.realpath(file) for file in result.files} for result in self.linted]

    # -- suggestions ---------------------------------------------------------------------------------------------------

    def suggestions(self) -> list[Suggestion]:
        """Return the suggested fixes that were not refused, in order.

        If edits clash, only the first fix is returned.
        """
        by_edits: dict[frozenset[Splice], Suggestion] = {}
        unsafe = set()
        for target, finding in self._findings():
            splices = splices_of(finding)
            key = frozenset(splices)
            if finding.fix and not finding.fix.safe:
                unsafe.add(key)
            if key not in by_edits or finding.order < by_edits[key].finding.order:
                by_edits[key] = Suggestion(finding, splices, target)
        taken = Taken()
        in_order = sorted(by_edits.items(), key=lambda item: item[1].finding.order)
        wanted = [
            suggestion
            for key, suggestion in in_order
            if key not in self.refused and (self.options.unsafe or key not in unsafe)
        ]
        return [suggestion for suggestion in wanted if self._is_editable(suggestion) and taken.take(suggestion.splices)]

    def _findings(self) -> Iterator[tuple[Target, Diagnostic]]:
        for target, linted in zip(self.targets, self.linted, strict=True):
            for finding in linted.outcome.diagnostics:
                if finding.fix and finding.fix.edits and self.options.admits(finding):
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

    # -- trials --------------------------------------------------------------------------------------------------------

    def round(self, suggestions: Sequence[Suggestion]) -> None:
        """Try suggestions and keep those without objections."""
        kept: list[Suggestion] = []
        pending = [list(suggestions)]
        while pending:
            group = pending.pop()
            objections = self._try(kept, group)
            if not objections:
                kept += group
            elif len(group) == 1 or self._is_like_others(group, objections[0]):
                self._refuse_all(group, objections[0])
            else:
                middle = len(group) // 2
                pending += [group[middle:], group[:middle]]
        if kept:
            self.files.now.update(self._edited(kept))
            self.refused.clear()  # their offsets have moved, and the objections may no longer hold

    def _try(self, kept: Sequence[Suggestion], group: Sequence[Suggestion]) -> list[str]:
        """Return the objections to a group of suggestions together with the kept ones.

        Without objections, the new findings become the current state.
        """
        self.trials += 1
        if self.trials > MOST_TRIALS:
            return ["too many other fixes were tried first. Run the command again"]
        after = {**self.files.now, **self._edited([*kept, *group])}
        changed = set().union(*(suggestion.files for suggestion in group))
        splices = frozenset(splice for suggestion in (*kept, *group) for splice in suggestion.splices)
        concerned = [index for index, files in enumerate(self._read) if files & changed]
        verdicts: dict[int, TrialResult] = {}
        for index, verdict in zip(concerned, self._verdicts(concerned, after, splices), strict=True):
            if verdict.objections:
                return list(verdict.objections)
            verdicts[index] = verdict
        asked_for = frozenset[Splice]().union(*(verdict.asked_for for verdict in verdicts.values()))
        if any(not asked_for.issuperset(suggestion.splices) for suggestion in group):
            return [_CHANGED]
        for index, verdict in verdicts.items():
            self.remarks.update(dict.fromkeys(verdict.remarks))
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
    ) -> Iterator[TrialResult]:
        details: list[dict[str, Any]] = []
        for index in concerned:
            files = sorted(self._read[index] & set(after))
            states = {"before": texts(self.files.now, files), "after": texts(after, files)}
            own = sorted(splice for splice in splices if splice.file in files)
            details.append({**states, "splices": [list(splice) for splice in own]})
        results = run_on_targets(
            trial_work,
            [self.targets[index] for index in concerned],
            self.settings._replace(timeout=2 * self.settings.timeout),
            self.judges,
            details=details,
            workers=Workers(self.loader, self.parallel),
        )
        for result in results:
            if isinstance(result, WorkerFailure):
                yield TrialResult((f"the fixed robot cannot be linted: {result.reason}",), frozenset(), None)
            else:
                yield TrialResult.from_json(result)

    def _is_like_others(self, group: Sequence[Suggestion], objection: str) -> bool:
        """Return whether so many fixes like these were refused for such a reason that these are not tried alone."""
        return all(self.alike[suggestion.finding.code, _kind_of(objection)] >= MOST_ALIKE for suggestion in group)

    def _refuse_all(self, group: Sequence[Suggestion], objection: str) -> None:
        for suggestion in group:
            self.alike[suggestion.finding.code, _kind_of(objection)] += 1
            self._refuse(suggestion, objection)

    def _refuse(self, suggestion: Suggestion, why: str) -> None:
        finding = suggestion.finding
        place = f"{finding.at.file}:{finding.at.line}:{finding.at.column}"
        self.refused[frozenset(suggestion.splices)] = f"{place}: {finding.code} is not fixed: {why}"

    def result(self) -> Fixed:
        """Return the changes, and the findings that remain."""
        files = self.files
        changes = (Change(file, files.read[file], after) for file, after in files.now.items())
        return Fixed(
            tuple(change for change in sorted(changes) if change.before != change.after),
            tuple(self._selected(linted) for linted in self.linted),
            tuple(sorted(self.refused.values())),
            tuple(self.remarks),
        )

    def _selected(self, linted: TargetResult) -> TargetResult:
        selected = [finding for finding in linted.outcome.diagnostics if self.options.selection.admits(finding.code)]
        return linted._replace(outcome=linted.outcome._replace(diagnostics=selected))
