"""Try edits on copies of one robot's files in memory: lint it before and after, and report objections."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from urdfctl.diagnostic import CallStep, Diagnostic, Severity
from urdfctl.fix.comparison import EditedFile, edited_file, same_file, same_tree
from urdfctl.fix.edits import Splice
from urdfctl.lint.job import Work
from urdfctl.lint.results import TargetResult
from urdfctl.lint.serialising import result_from_json, result_to_json
from urdfctl.lint.target import LintedTarget, lint_target
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

Chain = tuple[CallStep, ...]


class TrialResult(NamedTuple):
    """The result of trying edits on one robot."""

    objections: tuple[str, ...]
    """Reasons against the edits, the weightiest first."""
    asked_for: frozenset[Splice]
    """The edits that a finding of this robot suggests."""
    linted: TargetResult | None
    """The findings after the edits, None if the worker died."""
    remarks: tuple[str, ...] = ()
    """The less severe findings that come in the place of errors."""

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> TrialResult:
        """Return it from plain data."""
        asked_for = frozenset(Splice(*splice) for splice in data["asked_for"])
        linted = result_from_json(data["linted"])
        return cls(tuple(data["objections"]), asked_for, linted, tuple(data["remarks"]))


def splices_of(diagnostic: Diagnostic) -> tuple[Splice, ...]:
    """Return the edits of a finding's fix, with the real paths of their files."""
    edits = diagnostic.fix.edits if diagnostic.fix else ()
    return tuple(Splice(os.path.realpath(edit.file), edit.start, edit.end, edit.text) for edit in edits)


def trial_work(work: Work) -> dict[str, Any]:
    """Try edits in a worker: the `splices` that lead from `before` to `after`, which map real paths to bytes as
    Latin-1 text."""
    details = work.details
    splices = frozenset(Splice(*splice) for splice in details["splices"])
    before = lint_target(work.loader.with_overlay(_bytes(details["before"])), work.target, work.selection)
    after = lint_target(work.loader.with_overlay(_bytes(details["after"])), work.target, work.selection)
    trial = _Trial(before, after, splices)
    return {
        "objections": list(dict.fromkeys(trial.objections())),
        "asked_for": sorted(trial.asked_for()),
        "remarks": sorted(trial.remarks),
        "linted": result_to_json(after.result),
    }


def _bytes(texts: Mapping[str, str]) -> dict[str, bytes]:
    return {file: text.encode("latin-1") for file, text in texts.items()}


class _Trial:
    """One robot before and after some edits."""

    def __init__(self, before: LintedTarget, after: LintedTarget, splices: frozenset[Splice]) -> None:
        self.before, self.after = before, after
        self.edited: dict[str, EditedFile] = {}
        for path, source in before.sources.items():
            own = [splice for splice in splices if splice.file == os.path.realpath(path)]
            if own:
                self.edited[path] = edited_file(source, own)
        with_edits = [(diagnostic, splices_of(diagnostic)) for diagnostic in before.result.outcome.diagnostics]
        self.remarks: set[str] = set()
        self.fixed = [(diagnostic, own) for diagnostic, own in with_edits if own and splices.issuperset(own)]

    def asked_for(self) -> set[Splice]:
        return {splice for _, splices in self.fixed for splice in splices}

    def objections(self) -> Iterator[str]:
        """The objections to the edits, the weightiest first."""
        if self.after.result.outcome.crashed and not self.before.result.outcome.crashed:
            yield "urdfctl crashes on the fixed robot"
        yield from self._of_findings()
        yield from self._of_comments()
        if not same_tree(self.before.root, self.after.root, self.edited) or not self._same_files():
            yield "other parts of the robot would also change"
        if self.before.result.complete:
            yield from self._of_calls()

    # -- findings ------------------------------------------------------------------------------------------------------

    def _of_findings(self) -> Iterator[str]:
        """The edits must not cause a new finding, and must remove the findings that they fix.

        Findings that are less severe than all of those may come in their place, which is remarked.
        """
        mildest = min((one.severity for one, _ in self.fixed), key=lambda one: one.weight, default=Severity.INFO)
        fixed = f"{'an' if mildest is Severity.ERROR else 'a'} {mildest.value} is fixed"
        before = Counter(self._key(diagnostic) for diagnostic in self.before.result.outcome.diagnostics)
        expected_gone = Counter(self._key(diagnostic) for diagnostic, _ in self.fixed)
        left = before - expected_gone
        for diagnostic in self.after.result.outcome.diagnostics:
            key = diagnostic.code, diagnostic.at.file, diagnostic.at.start
            left[key] -= 1
            if left[key] < 0:
                stays = key in expected_gone and left[key] >= -expected_gone[key]
                if not stays and diagnostic.severity.weight < mildest.weight:
                    where = f"{diagnostic.at.file}:{diagnostic.at.line}:{diagnostic.at.column}"
                    self.remarks.add(f"{where}: {fixed}; left is {diagnostic.code}: {diagnostic.message}")
                    continue
                new = f"the fix would cause {diagnostic.code} ({diagnostic.message})"
                yield "the fix would not remove the finding" if stays else new

    def _key(self, diagnostic: Diagnostic) -> tuple[str, str, int]:
        """The identity of a finding after the edits: its code and its new place."""
        return diagnostic.code, diagnostic.at.file, self._moved(diagnostic.at.file, diagnostic.at.start)

    def _moved(self, file: str, offset: int) -> int:
        edited = self.edited.get(file)
        return edited.shift.near(offset) if edited else offset

    def _of_comments(self) -> Iterator[str]:
        """A suppression that is used before the edits must still be used after them."""
        used = {(use.at.file, use.at.start) for use in self.after.result.outcome.suppressions if use.used}
        for use in self.before.result.outcome.suppressions:
            if use.used and (use.at.file, self._moved(use.at.file, use.at.start)) not in used:
                yield f"the suppression in line {use.at.line} would be unused"

    # -- the tree ------------------------------------------------------------------------------------------------------

    def _same_files(self) -> bool:
        sources = self.before.sources, self.after.sources
        return all(
            path in sources[1] and same_file(sources[0][path], sources[1][path], edited)
            for path, edited in self.edited.items()
        )

    def _of_calls(self) -> Iterator[str]:
        """A macro with several calls is changed only if every call has the finding."""
        chains: dict[Splice, set[Chain]] = {}
        for diagnostic, splices in self.fixed:
            for splice in splices:
                chains.setdefault(splice, set()).update(diagnostic.expanded_from or [()])
        for element, splice in self._touched(self.before.root):
            if not any(_goes_with(_chain(element), chain) for chain in chains.get(splice, ())):
                yield _elsewhere(_chain(element))

    def _touched(self, root: Element | None) -> Iterator[tuple[Element, Splice]]:
        """The expanded elements that edits change or remove, each with the edit."""
        pending = [root] if root is not None else []
        while pending:
            element = pending.pop()
            pending += element.elements()
            edited = self.edited.get(element.source.path)
            if edited:
                for splice in (*edited.touched.get(element.start, ()), *edited.shift.replacing(element.start)):
                    yield element, splice


def _chain(element: Element) -> Chain:
    calls = element.call.chain() if element.call else ()
    return tuple(
        CallStep(call.source.path, *call.source.position(call.offset), f"{call.kind} {call.name}".strip())
        for call in calls
    )


def _goes_with(chain: Chain, found: Chain) -> bool:
    """Whether one chain of calls, from the outside in, is the beginning of the other."""
    return all(step == other for step, other in zip(reversed(chain), reversed(found), strict=False))


def _elsewhere(chain: Chain) -> str:
    macro = next((step for step in chain if step.what.startswith("macro")), None)
    if macro is None:
        return "the fix would also change a robot without this finding"
    name = macro.what.removeprefix("macro ")
    return f"the call of macro '{name}' at {macro.file}:{macro.line} does not have this finding but would also change"


def texts(held: Mapping[str, bytes], files: Sequence[str]) -> dict[str, str]:
    """Return the contents of these files as text, for a job."""
    return {file: held[file].decode("latin-1") for file in files}
