"""Tries edits on one robot, on nothing but copies of its files in memory: lints it before and after, and tells what
speaks against them."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.diagnostic import Diagnostic, Step
from urdfctl.fix.comparison import EditedFile, edited_file, same_file, same_tree
from urdfctl.fix.edits import Splice
from urdfctl.hints import Any
from urdfctl.jobs import loader_of, target_of
from urdfctl.lint import Linted
from urdfctl.load import Loader, Seen
from urdfctl.record import NamedTuple
from urdfctl.serialise import linted_from_json, linted_to_json
from urdfctl.source.dom import Element

Chain = tuple[Step, ...]


class Verdict(NamedTuple):
    """What became of edits in one robot: what speaks against them, which of them a finding asked for, and the findings
    that are left."""

    objections: tuple[str, ...]
    asked_for: frozenset[Splice]
    linted: Linted | None

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Verdict:
        """From plain data."""
        asked_for = frozenset(Splice(*splice) for splice in data["asked_for"])
        return cls(tuple(data["objections"]), asked_for, linted_from_json(data["linted"]))


def splices_of(diagnostic: Diagnostic) -> tuple[Splice, ...]:
    """The edits of a finding's fix, in the files that they are really in."""
    edits = diagnostic.fix.edits if diagnostic.fix else ()
    return tuple(Splice(os.path.realpath(edit.file), edit.start, edit.end, edit.text) for edit in edits)


def perform(job: dict[str, Any]) -> dict[str, Any]:
    """Try the edits of a job that came as JSON."""
    return perform_with(loader_of(job), job)


def perform_with(loader: Loader, job: dict[str, Any]) -> dict[str, Any]:
    """Try edits: those that lead from the bytes `before` to the bytes `after`, given as Latin-1 by real paths."""
    target = target_of(job)
    splices = frozenset(Splice(*splice) for splice in job["splices"])
    before = loader.holding(_bytes(job["before"])).seen(target)
    after = loader.holding(_bytes(job["after"])).seen(target)
    trial = _Trial(before, after, splices)
    return {
        "objections": list(dict.fromkeys(trial.objections())),
        "asked_for": sorted(trial.asked_for()),
        "linted": linted_to_json(after.linted),
    }


def _bytes(texts: Mapping[str, str]) -> dict[str, bytes]:
    return {file: text.encode("latin-1") for file, text in texts.items()}


class _Trial:
    """One robot before and after some edits."""

    def __init__(self, before: Seen, after: Seen, splices: frozenset[Splice]) -> None:
        self.before, self.after = before, after
        self.edited: dict[str, EditedFile] = {}
        for path, source in before.sources.items():
            own = [splice for splice in splices if splice.file == os.path.realpath(path)]
            if own:
                self.edited[path] = edited_file(source, own)
        found = [(diagnostic, splices_of(diagnostic)) for diagnostic in before.linted.outcome.diagnostics]
        self.mended = [(diagnostic, own) for diagnostic, own in found if own and splices.issuperset(own)]

    def asked_for(self) -> set[Splice]:
        return {splice for _, splices in self.mended for splice in splices}

    def objections(self) -> Iterator[str]:
        """What speaks against the edits, in the order of its weight."""
        if self.after.linted.outcome.crashed and not self.before.linted.outcome.crashed:
            yield "urdfctl crashes on what would become of it"
        yield from self._of_findings()
        yield from self._of_comments()
        if not same_tree(self.before.root, self.after.root, self.edited) or not self._same_files():
            yield "other parts of the robot would change too"
        if self.before.linted.complete:
            yield from self._of_calls()

    # -- findings ----------------------------------------------------------------------------------------------------

    def _of_findings(self) -> Iterator[str]:
        """No finding may come; and those that the edits are for must go."""
        before = Counter(self._key(diagnostic) for diagnostic in self.before.linted.outcome.diagnostics)
        mended = Counter(self._key(diagnostic) for diagnostic, _ in self.mended)
        left = before - mended
        for diagnostic in self.after.linted.outcome.diagnostics:
            key = diagnostic.code, diagnostic.at.file, diagnostic.at.start
            left[key] -= 1
            if left[key] < 0:
                stays = key in mended and left[key] >= -mended[key]
                yield "the finding would stay" if stays else f"{diagnostic.code} would come: {diagnostic.message}"

    def _key(self, diagnostic: Diagnostic) -> tuple[str, str, int]:
        """What a finding is known by after the edits: its code, and where it stands then."""
        return diagnostic.code, diagnostic.at.file, self._moved(diagnostic.at.file, diagnostic.at.start)

    def _moved(self, file: str, offset: int) -> int:
        edited = self.edited.get(file)
        return edited.shift.near(offset) if edited else offset

    def _of_comments(self) -> Iterator[str]:
        """A comment that silences something must not be left with nothing to silence."""
        used = {(use.at.file, use.at.start) for use in self.after.linted.outcome.suppressions if use.used}
        for use in self.before.linted.outcome.suppressions:
            if use.used and (use.at.file, self._moved(use.at.file, use.at.start)) not in used:
                yield f"the comment in line {use.at.line} would have nothing to silence"

    # -- the tree ----------------------------------------------------------------------------------------------------

    def _same_files(self) -> bool:
        sources = self.before.sources, self.after.sources
        return all(
            path in sources[1] and same_file(sources[0][path], sources[1][path], edited)
            for path, edited in self.edited.items()
        )

    def _of_calls(self) -> Iterator[str]:
        """What several calls of a macro show is changed only where each of them shows the finding."""
        chains: dict[Splice, set[Chain]] = {}
        for diagnostic, splices in self.mended:
            for splice in splices:
                chains.setdefault(splice, set()).update(diagnostic.expanded_from or [()])
        for element, splice in self._touched(self.before.root):
            if not any(_goes_with(_chain(element), chain) for chain in chains.get(splice, ())):
                yield _elsewhere(_chain(element))

    def _touched(self, root: Element | None) -> Iterator[tuple[Element, Splice]]:
        """The expanded elements that edits touch or take away, each with the edit."""
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
        Step(call.source.path, *call.source.position(call.offset), f"{call.kind} {call.name}".strip()) for call in calls
    )


def _goes_with(chain: Chain, found: Chain) -> bool:
    """Whether two chains lead to the same, or one to where the other goes on from: they agree from the outside in."""
    return all(one == other for one, other in zip(reversed(chain), reversed(found), strict=False))


def _elsewhere(chain: Chain) -> str:
    macro = next((step for step in chain if step.what.startswith("macro")), None)
    if macro is None:
        return "it would change a robot that has no such finding"
    name = macro.what.removeprefix("macro ")
    return f"the call of macro '{name}' at {macro.file}:{macro.line} has no such finding, and would change too"


def texts(held: Mapping[str, bytes], files: Sequence[str]) -> dict[str, str]:
    """Some of the held files, as a job carries them."""
    return {file: held[file].decode("latin-1") for file in files}
