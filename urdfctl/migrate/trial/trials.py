"""Find the steps that must be left out of a migration, by attempts to apply all steps."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Generator, Iterator, Mapping, Sequence
from itertools import takewhile

from urdfctl.config.settings import Settings
from urdfctl.migrate.packages import Lint, MigratedPackages
from urdfctl.migrate.step import Step
from urdfctl.migrate.trial.acceptance import Before, Objection, errors_in
from urdfctl.migrate.trial.attempt import Attempt, Barred, Key, Noted
from urdfctl.migrate.trial.scratch import WrittenFile
from urdfctl.startup.records import NamedTuple

MOST_ATTEMPTS = 24

Kind = tuple[str, str]
Search = Generator[Sequence[Key], bool, Sequence[Key]]
"""Yields what to leave out next; is sent whether the objection is gone then; returns what to leave out for good."""


class Trials:
    """Attempts to apply all steps, each without those that the objections to the earlier ones bar.

    earlier: the entries of the report about what was accepted before.
    """

    def __init__(
        self,
        packages: MigratedPackages,
        steps: Sequence[Step],
        state: Before,
        lint: Lint,
        settings: Settings,
        earlier: Sequence[Noted] = (),
    ) -> None:
        self.packages, self.steps, self.state = packages, steps, state
        self.lint, self.settings = lint, settings
        self._stages = [_Stage(Attempt(packages, {}, earlier), dict(packages.scratch.written))]
        self.made = 0

    def best(self) -> tuple[Attempt, list[Objection]]:
        """Return the last attempt, and the objections to it that no step is responsible for.

        One kind of fault is searched in all files at once, one after the other: the next may be its consequence.
        """
        searches: dict[Kind, _Suspects] = {}
        attempt, found = self._attempt({})
        known = errors_in(attempt.linted)
        while self.made < MOST_ATTEMPTS:
            kinds = {objection.kind for objection in found}
            new_errors = (files for error, files in errors_in(attempt.linted).items() if error not in known)
            worse = {file for files in new_errors for file in files}
            for kind, suspects in searches.items():
                suspects.judge(is_gone=kind not in kinds, worse=worse)
            while all(suspects.is_done for suspects in searches.values()):
                new = dict(self._next(attempt, found, searches))
                if not new:
                    break
                searches.update(new)
            barred = {key: suspects.why for suspects in searches.values() for key in suspects.choice}
            if barred.keys() == attempt.barred.keys():
                return attempt, found
            attempt, found = self._attempt(barred)
        return self._without_all(searches, attempt)

    def states(self) -> Iterator[tuple[str, Mapping[str, WrittenFile]]]:
        """Yield the steps of the last attempt in order, each with what differs from the user's files after it."""
        for step, stage in zip(self.steps, self._stages[1:], strict=False):
            yield step.name, stage.written

    def _without_all(self, searches: Mapping[Kind, _Suspects], attempt: Attempt) -> tuple[Attempt, list[Objection]]:
        """The attempt without all that may be responsible, or without anything if that does not help."""
        everyone = {key: suspects.why for suspects in searches.values() for key in suspects.all}
        last, found = self._attempt(everyone)
        if all(objection.kind in searches for objection in found):
            return last, found
        why = "too many changes would cause findings of a new kind"
        return self._attempt({**everyone, **dict.fromkeys((*attempt.touched, *last.touched), why)})

    def _attempt(self, barred: Barred) -> tuple[Attempt, list[Objection]]:
        """Apply all steps, beginning with the first one that the last attempt barred from other files."""
        self.made += 1
        scratch = self.packages.scratch
        last = self._stages[-1].attempt.barred
        is_same = (_files_of(step, last) == _files_of(step, barred) for step in self.steps)
        index = min(sum(takewhile(bool, is_same)), len(self._stages) - 1)
        del self._stages[index + 1 :]
        scratch.restore(self._stages[index].written)
        self.packages.forget()
        attempt = self._stages[index].attempt.copy(barred)
        for step in self.steps[index:]:
            attempt.apply(step)
            self._stages.append(_Stage(attempt.copy(barred), dict(scratch.written)))
        found = attempt.judged(self.state, self.lint, self.settings) if scratch.written else []
        return attempt, found

    def _next(
        self, attempt: Attempt, found: Sequence[Objection], searches: Mapping[Kind, _Suspects]
    ) -> Iterator[tuple[Kind, _Suspects]]:
        """Yield the searches for the first new objection, and for those of its code that may be of the same step."""
        like: tuple[str, str] | None = None
        for objection in reversed({one.kind: one for one in reversed(found)}.values()):
            known = searches.get(objection.kind)
            if known is not None and not known.is_back:
                continue
            candidates = self._candidates(attempt, objection)
            its = objection.kind[0], candidates[0][0] if candidates else ""
            like = like or its
            if its == like:
                yield objection.kind, _Suspects(objection, candidates, known.choice if known else ())

    def _candidates(self, attempt: Attempt, objection: Objection) -> list[Key]:
        """The steps that may be responsible for an objection: first those that changed its file, the last one first.

        What lint finds is no reason to leave out a step without which the target cannot read the file, and a warning
        about a file that such a step wrote is none to leave out what others change elsewhere.
        """
        own, files = os.path.realpath(objection.file), {os.path.realpath(file) for file in objection.files}
        needed = {step.name for step in self.steps if step.is_needed and objection.finding is not None}
        written = self.packages.scratch.written.get(own)
        is_new = written is not None and written.is_new
        if objection.is_warning and is_new and any((name, own) in attempt.touched for name in needed):
            return []
        touched = [key for key in reversed(attempt.touched) if key[0] not in needed]
        direct = [key for key in touched if key[1] == own]
        return direct + [key for key in touched if key[1] in files and key not in direct]


class _Stage(NamedTuple):
    """An attempt before a step, and the state of the files."""

    attempt: Attempt
    written: Mapping[str, WrittenFile]


def _files_of(step: Step, barred: Barred) -> set[str]:
    return {file for name, file in barred if name == step.name}


class _Suspects:
    """The search for the steps that are responsible for an objection.

    choice: what to leave out next; empty if nothing helps.
    all: everything that may be responsible; empty if nothing helps.
    base: what was found to be responsible before the objection came back.
    """

    def __init__(self, objection: Objection, candidates: Sequence[Key], base: Sequence[Key] = ()) -> None:
        self.why, self._is_warning = objection.message, objection.is_warning
        self._base = tuple(base)
        self.is_done = self.is_back = False
        self.all = (*self._base, *candidates)
        self._search = _search(candidates)
        self.choice: tuple[Key, ...] = ()
        self._choose(lambda: next(self._search))

    def judge(self, *, is_gone: bool, worse: Collection[str]) -> None:
        """Choose what to leave out next, by whether the objection is gone without the last choice.

        worse: the files of the targets with errors that the complete migration does not have: a warning is no reason
            for them.
        """
        if self._is_warning and is_gone and any(file in worse for _, file in self.choice):
            self.is_done, self.choice, self.all = True, (), ()
        elif self.is_done:
            self.is_back = not is_gone and bool(self.choice)
        else:
            self._choose(lambda: self._search.send(is_gone))

    def _choose(self, resume: Callable[[], Sequence[Key]]) -> None:
        try:
            self.choice = (*self._base, *resume())
        except StopIteration as end:
            self.is_done = True
            self.choice = self.all = (*self._base, *end.value) if end.value else ()


def _search(candidates: Sequence[Key]) -> Search:
    """Search the first candidate alone, then all of them, then the one among the first few that makes the difference.

    Of the steps that changed a file, the last one is mostly responsible.
    """
    if not candidates:
        return ()
    if (yield candidates[:1]):
        return candidates[:1]
    if len(candidates) == 1 or not (yield candidates):
        return ()
    low, high = 1, len(candidates)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if (yield candidates[:middle]) else (middle, high)
    alone = candidates[high - 1 : high]
    return alone if (yield alone) else candidates[:high]
