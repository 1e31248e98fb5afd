"""The folder that an editor shows: its open texts, and the findings in all of its robots."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager

from urdfctl.config.file import config_for, package_folders_in, with_environ
from urdfctl.config.settings import Settings, passed_on, settings_with
from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.lint.judging import LintRun, judge
from urdfctl.lint.live import LiveLinter
from urdfctl.lint.results import TargetResult
from urdfctl.lint.run import LintRequest, find, merge, plan
from urdfctl.lint.selection import Selection, selection_with
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import LoadedTarget, Loader
from urdfctl.load.target import Target
from urdfctl.model.project import Project
from urdfctl.run.here import Clock
from urdfctl.run.limits import Limits
from urdfctl.server.analysis.attempts import Attempts, Codes, codes_of
from urdfctl.server.analysis.variants import Variant, variants_among
from urdfctl.source.budget import OverBudget
from urdfctl.source.disk.files import MAX_BYTES, first_bytes
from urdfctl.source.disk.gate import admit, reading_within
from urdfctl.source.disk.shown import as_shown, forget_files
from urdfctl.source.workspaces.packages import Packages, package_around
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.startup.records import NamedTuple


class EditorSettings(NamedTuple):
    """What the editor's settings ask for; None or empty for what the configuration file says."""

    distro: str | None = None
    simulator: str | None = None
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    arguments: tuple[tuple[str, str], ...] = ()
    """The variant that is shown: arguments for the descriptions that are found in folders."""

    @classmethod
    def from_json(cls, data: object) -> EditorSettings:
        """Return what an editor sends: an object with any of these names. Other names and values are ignored."""
        given = data if isinstance(data, dict) else {}
        texts = {name: given[name] for name in ("distro", "simulator") if isinstance(given.get(name), str)}
        lists = {name: given[name] for name in ("select", "ignore") if isinstance(given.get(name), list)}
        codes = {name: tuple(code.upper() for code in found if isinstance(code, str)) for name, found in lists.items()}
        arguments = given.get("arguments")
        pairs = arguments.items() if isinstance(arguments, dict) else ()
        return cls(
            distro=texts.get("distro") or None,
            simulator=texts.get("simulator") or None,
            select=codes.get("select", ()),
            ignore=codes.get("ignore", ()),
            arguments=tuple((str(name), str(value)) for name, value in pairs),
        )


class Checked(NamedTuple):
    """The findings in a folder, or in a part of it.

    folder: the real path of the whole folder.
    is_whole: whether they are those of all of it.
    run: the results that the findings come from.
    findings: those of `urdfctl lint FOLDER --format json`, by the absolute path of their file.
    files: the files that were read; those without findings have none.
    """

    folder: str
    is_whole: bool
    run: LintRun
    findings: Mapping[str, tuple[Diagnostic, ...]]
    files: frozenset[str]

    @classmethod
    def nothing(cls, folder: str) -> Checked:
        """Return the findings in a folder that cannot be read."""
        return cls(folder, is_whole=True, run=LintRun([], []), findings={}, files=frozenset())


class Workspace:
    """One folder with its open texts.

    folder: everything below it is linted.
    is_outdated: asked between robots; if it returns True, `check` stops with Outdated.
    Raises UserError if the configuration or a wish is invalid.
    """

    def __init__(
        self,
        folder: str,
        asked: EditorSettings,
        is_outdated: Callable[[], bool] = lambda: False,
    ) -> None:
        self.folder = os.path.realpath(folder)
        self.texts: dict[str, bytes] = {}
        self._on_disk: dict[str, bool] = {}
        self._aside: set[str] = set()
        with as_shown(self.folder, {}):
            around = workspace_of(os.path.join(self.folder, "robot"))
        self._readable = [around, *package_folders_in(os.environ)]
        for root in self._readable:
            admit(root)
        with self._shown({}):
            self.config = with_environ(config_for((self.folder,)), os.environ)
        given = Settings(distro=asked.distro, simulator=asked.simulator, environ=passed_on(os.environ))
        self.settings = settings_with(self.config, given)
        self._selection = selection_with(self.config, Selection(asked.select, asked.ignore))
        self._asked = asked
        self._is_outdated = is_outdated
        self._run: LintRun | None = None
        self._loaded: tuple[object, list[LoadedTarget]] | None = None
        self._edition = 0
        self._chosen: list[Target] = []
        self._readers: tuple[LintRun | None, dict[str, list[tuple[Target, TargetResult]]]] = None, {}
        self._whole: dict[Target, LoadedTarget] = {}
        self._saved: dict[Target, Codes] = {}
        self._packages = Loader(self.settings)
        self._reading: tuple[dict[str, bytes], Loader] = {}, self._packages
        self._linter = LiveLinter(self.settings, self._selection, {}, is_outdated)

    @contextmanager
    def _shown(self, texts: Mapping[str, bytes]) -> Iterator[None]:
        """Within it, this thread works in the folder with these texts, and reads nothing outside of its workspace, nor
        of those of the open texts."""
        readable = dict.fromkeys([*self._readable, *map(workspace_of, list(self.texts))])
        with as_shown(self.folder, texts, self._aside), reading_within(readable):
            yield

    def changed(self, path: str, text: bytes | None) -> None:
        """Take an open file's text; None if it was closed, and its text on disk counts again.

        The text of a file that was never saved is kept, but not linted.
        """
        real = os.path.realpath(path)
        if text is None:
            self.texts.pop(real, None)
        else:
            self.texts[real] = text
            admit(workspace_of(real))
        if text is None:
            self.saved(real)
        else:
            self._read_again(real)

    def saved(self, path: str) -> None:
        """Read a file again whose text on disk changed."""
        real = os.path.realpath(path)
        self._reading = {}, self._packages.with_overlay({})
        self._read_again(real)

    def _read_again(self, real: str) -> None:
        """Read a file again whose text changed."""
        was_there = self._on_disk.get(real)
        is_there = self._on_disk[real] = os.path.exists(real)
        if was_there not in (None, is_there) or real in self._aside:
            self.forget()
        elif is_there:
            self._edition += 1
            self._linter.changed(self._saved_once(), [real])

    def _saved_once(self) -> dict[str, bytes]:
        """The open texts of the files that exist."""
        return {path: text for path, text in dict(self.texts).items() if os.path.exists(path)}

    def forget(self) -> None:
        """Lint everything again: files were created or deleted."""
        self._edition += 1
        self._aside.clear()
        forget_files()
        self._packages = Loader(self.settings)
        self._reading = {}, self._packages.with_overlay({})
        self._linter = LiveLinter(self.settings, self._selection, self._saved_once(), self._is_outdated)

    def variants(self, path: str) -> list[Variant]:
        """Return the variants of the robots that read a file, as they were found last: the one that says most first."""
        return variants_among(self._pairs_with(path), self.folder)

    def choose(self, path: str, target: Target | None) -> None:
        """Show a variant of the robots that read a file from now on; all of them if None."""
        others = {variant.target for variant in self.variants(path)}
        kept = [one for one in self._chosen if one not in others]
        self._chosen = kept if target is None else [target, *kept]

    def chosen(self, path: str) -> Target | None:
        """Return the variant that was chosen last of those that read a file; None if none was."""
        targets = {target for target, _ in self._pairs_with(path)}
        return next((target for target in self._chosen if target in targets), None)

    def robots(self) -> Iterator[tuple[TargetResult, bool]]:
        """Yield the robots that were found last, each with whether it is a variant that was chosen."""
        run = self._run or LintRun([], [])
        known = {id(result) for result in run.robots}
        yield from ((result, target in self._chosen) for target, result in run.targets if id(result) in known)

    def _pairs_with(self, path: str) -> list[tuple[Target, TargetResult]]:
        """What was linted last and reads a file, with what it is: what says most first."""
        run = self._run
        if run is None:
            return []
        if self._readers[0] is not run:
            self._readers = run, _readers(run)
        return self._readers[1].get(os.path.realpath(path), [])

    def target_with(self, path: str) -> Target:
        """Return the target that says most about a file: the variant that was chosen, if one was."""
        pairs = self._pairs_with(path)
        return self.chosen(path) or next((target for target, _ in pairs), Target(os.path.realpath(path)))

    def robots_with(self, path: str) -> list[LoadedTarget]:
        """Return the robots that read a file, as they were found last: the one that says most first, after the variant
        that was chosen.

        Of a file that no robot reads, it is what the file is by itself.
        """
        first, others = self.target_with(path), [target for target, _ in self._pairs_with(path)]
        chosen = list(dict.fromkeys([first, *others]))[:_MOST_ROBOTS]
        key = tuple(chosen), self._edition
        if self._loaded is None or self._loaded[0] != key:
            with self._shown(dict(self.texts)):
                loader = self._loader()
                self._loaded = key, [self._read(loader, target) for target in chosen]
        return self._loaded[1]

    def attempts(self, path: str) -> Attempts:
        """Return what lints the robots that read a file with other texts of it. Nothing of that is kept."""
        real = os.path.realpath(path)
        targets = list(dict.fromkeys([self.target_with(path), *(target for target, _ in self._pairs_with(path))]))
        on_disk = text_on_disk(real)
        loaders, texts = [self._loader()], dict(self.texts)

        def lint(robot: int, text: bytes, seconds: float) -> Sequence[Diagnostic] | None:
            target = targets[robot]
            if self._linter.seconds.get(target, 0.0) > seconds:
                return None
            shown = {**texts, real: text}
            tried = loaders[-1].with_overlay(shown, [real])
            loaders[:] = [tried]
            try:
                with self._shown(shown), self._clock():
                    linted = lint_target(tried, target, self._selection)
                    return self._reported(linted.result.outcome.diagnostics)
            except OverBudget:
                return None

        def saved(robot: int) -> Codes:
            if targets[robot] in self._saved:
                return self._saved[targets[robot]]
            return codes_of((on_disk is not None and lint(robot, on_disk, PATIENCE)) or ())

        return Attempts(lint, min(len(targets), _MOST_ROBOTS), saved, on_disk)

    def _reported(self, findings: Iterable[Diagnostic]) -> list[Diagnostic]:
        """The findings that the configuration does not ignore."""
        return [finding for finding in findings if not self.config.ignores(finding.at.file, finding.code)]

    def _unknown(self, findings: list[Diagnostic]) -> list[Diagnostic]:
        """The findings that the configuration's baseline does not have; all while that cannot be read."""
        path = self.config.baseline
        if path is None:
            return findings
        from urdfctl.report.baseline import compare, read_baseline

        try:
            return compare(findings, read_baseline(path), path, lambda *_: False).new
        except UserError:
            return findings

    def packages_for(self, path: str) -> Packages:
        """Return the packages of the workspace as a file sees them."""
        with self._shown(dict(self.texts)):
            return self._loader().reading(path)[1]

    def _loader(self) -> Loader:
        """The loader for the texts as they are. What reads none of the changed ones is not expanded again."""
        before, loader = self._reading
        texts = dict(self.texts)
        if texts != before:
            changed = [path for path in {*before, *texts} if before.get(path) != texts.get(path)]
            loader = loader.with_overlay(texts, changed)
            self._reading = texts, loader
        return loader

    def _read(self, loader: Loader, target: Target) -> LoadedTarget:
        """The robot of a target; as it was last, or as it is on disk, while a text that is typed cannot be parsed."""
        loaded = self._load(loader, target)
        before = self._whole.get(target)
        if before is None and self.texts and _may_lack(loaded):
            before = self._load(self._packages.with_overlay({}), target)
        self._whole[target] = before if before is not None and _lacks(loaded, before) else loaded
        return self._whole[target]

    def _load(self, loader: Loader, target: Target) -> LoadedTarget:
        """The robot of a target; nothing of it if that takes longer than the user would wait."""
        try:
            with self._clock():
                return loader.load(target)
        except OverBudget:
            return LoadedTarget(Project(None, os.path.abspath(target.path), complete=False), None, {})

    def _clock(self) -> Clock:
        """Ends what takes longer than the user would wait."""
        seconds = min(self.settings.timeout, PATIENCE)
        return Clock(Limits(seconds, self.settings.memory, self.settings.environ, waiting=1.0))

    def check(self, path: str | None = None) -> Checked:
        """Return the findings in the package around a file, or in the whole folder.

        Raises Outdated if `is_outdated` says so meanwhile.
        """
        folder = self.folder
        if path is not None:
            folder = package_around(os.path.dirname(os.path.realpath(path))) or folder
        texts = self._saved_once()
        request = LintRequest((folder,), self.config, self.settings, self._selection, self._asked.arguments)
        with self._shown(texts):
            run = judge(plan(find(request), request), self._linter)
            found = self._unknown(merge(run.results, request))
        if path is None or self._run is None:
            self._run = run
        self._keep_saved(run)
        findings: dict[str, list[Diagnostic]] = {}
        for finding in found:
            findings.setdefault(os.path.abspath(finding.at.file), []).append(finding)
        read = frozenset(os.path.abspath(file) for result in run.results for file in result.files)
        in_files = {file: tuple(each) for file, each in findings.items()}
        return Checked(self.folder, is_whole=path is None, run=run, findings=in_files, files=read)

    def _keep_saved(self, run: LintRun) -> None:
        """Keep what is found in each target when all texts are saved: what is typed since then may not be finished."""
        if all(text == text_on_disk(path) for path, text in dict(self.texts).items()):
            found = ((target, self._reported(result.outcome.diagnostics)) for target, result in run.targets)
            self._saved.update((target, codes_of(findings)) for target, findings in found)

    def reads(self, path: str) -> bool:
        """Return whether anything that was linted last reads a file."""
        return bool(self._pairs_with(path))


def text_on_disk(path: str) -> bytes | None:
    """Return the text of a saved file; None if it cannot be read."""
    try:
        return first_bytes(path, MAX_BYTES)
    except OSError:
        return None


PATIENCE = 5.0
"""Seconds for reading one robot when an editor asks about it."""
_MOST_ROBOTS = 8
"""So many robots with a file are looked at when an editor asks about a name in it."""


def _weight(result: TargetResult) -> tuple[object, ...]:
    return not result.library, result.complete, bool(result.controllers), result.launch is not None, len(result.files)


def _may_lack(loaded: LoadedTarget) -> bool:
    """Return whether something is missing that a text which cannot be parsed may hold."""
    return bool(loaded.project.problems) and not all(_there(loaded))


def _lacks(loaded: LoadedTarget, before: LoadedTarget) -> bool:
    """Return whether the robot or its controllers cannot be read any more."""
    return _may_lack(loaded) and any(had and not has for has, had in zip(_there(loaded), _there(before), strict=True))


def _there(loaded: LoadedTarget) -> tuple[bool, bool]:
    """Whether there is a robot, and whether there are controllers."""
    controllers = loaded.project.controllers
    return loaded.root is not None, controllers is not None and bool(controllers.controllers)


def _readers(run: LintRun) -> dict[str, list[tuple[Target, TargetResult]]]:
    """For each file, by its real path, what reads it: what says most first."""
    real: dict[str, str] = {}
    found: dict[str, list[tuple[Target, TargetResult]]] = {}
    for pair in sorted(run.targets, key=lambda pair: _weight(pair[1]), reverse=True):
        for file in pair[1].files:
            if file not in real:
                real[file] = os.path.realpath(file)
        for file in {real[file] for file in pair[1].files}:
            found.setdefault(file, []).append(pair)
    return found
