"""The folder that an editor shows: its open texts, and the findings in all of its robots."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager

from urdfctl.config.file import Config, config_for, with_environ
from urdfctl.config.settings import Settings, passed_on, validate_settings
from urdfctl.diagnostic import Diagnostic
from urdfctl.discover.walk import reading_instead
from urdfctl.lint.files import LintRun, lint_files
from urdfctl.lint.live import LiveLinter
from urdfctl.lint.merging import merge
from urdfctl.lint.planning import discovered
from urdfctl.lint.selection import Selection, validate_selection
from urdfctl.source.packages import package_around
from urdfctl.startup.records import NamedTuple


class Wishes(NamedTuple):
    """What the editor's settings ask for; None or empty for what the configuration file says."""

    distro: str | None = None
    simulator: str | None = None
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()


class Checked(NamedTuple):
    """The findings in a part of the workspace.

    run: the results that the findings come from.
    findings: those of `urdfctl lint FOLDER --format json`, by the absolute path of their file.
    files: the files that were read; those without findings have none.
    """

    run: LintRun
    findings: Mapping[str, tuple[Diagnostic, ...]]
    files: frozenset[str]


class Workspace:
    """One folder with its open texts.

    folder: everything below it is linted.
    is_outdated: asked between robots; if it returns True, `check` stops with Outdated.
    Raises UserError if the configuration or a wish is invalid.
    """

    def __init__(
        self,
        folder: str,
        wishes: Wishes,
        is_outdated: Callable[[], bool] = lambda: False,
    ) -> None:
        self.folder = os.path.realpath(folder)
        self.texts: dict[str, bytes] = {}
        self.config = with_environ(config_for((self.folder,)), os.environ)
        self.settings = _settings(self.config, wishes)
        self._selection = _selection(self.config, wishes)
        self._is_outdated = is_outdated
        self._linter = LiveLinter(self.settings, self._selection, self.texts, is_outdated)

    def changed(self, path: str, text: bytes | None) -> None:
        """Take an open file's text; None if it was closed, and its text on disk counts again."""
        real = os.path.realpath(path)
        is_new = not os.path.exists(real)
        if text is None:
            self.texts.pop(real, None)
        else:
            self.texts[real] = text
        if is_new:
            self.forget()
        else:
            self.saved(real)

    def saved(self, path: str) -> None:
        """Read a file again whose text on disk changed."""
        real = os.path.realpath(path)
        if os.path.basename(real) in _OF_PACKAGES:
            self.forget()
        else:
            self._linter.changed(dict(self.texts), [real])

    def forget(self) -> None:
        """Lint everything again: files were created or deleted."""
        self._linter = LiveLinter(self.settings, self._selection, dict(self.texts), self._is_outdated)

    def check(self, path: str | None = None) -> Checked:
        """Return the findings in the package around a file, or in the whole folder.

        Raises Outdated if `is_outdated` says so meanwhile.
        """
        folder = self.folder
        if path is not None:
            folder = package_around(os.path.dirname(os.path.realpath(path))) or folder
        with self.reading():
            run = lint_files(discovered([folder], self.config), (), self._linter, self.config.robots)
        merged = merge([result.outcome for result in run.results], self._selection)
        findings: dict[str, list[Diagnostic]] = {}
        for finding in merged:
            if not self.config.ignores(finding.at.file, finding.code):
                findings.setdefault(os.path.abspath(finding.at.file), []).append(finding)
        files = frozenset(os.path.abspath(file) for result in run.results for file in result.files)
        return Checked(run, {file: tuple(found) for file, found in findings.items()}, files)

    @contextmanager
    def reading(self) -> Iterator[None]:
        """Read the open texts instead of the files on disk, also when robots are looked for."""
        with reading_instead(self.texts):
            yield


_OF_PACKAGES = frozenset({"package.xml", "CMakeLists.txt", "setup.py", "urdfctl.toml", "pyproject.toml"})
"""Files that decide more than the robots which read them."""


def _settings(config: Config, wishes: Wishes) -> Settings:
    return validate_settings(
        Settings(
            distro=wishes.distro or config.distro,
            simulator=wishes.simulator or config.simulator,
            package_paths=config.package_paths,
            environ=passed_on(os.environ),
            additions=config.additions,
            distro_from=None if wishes.distro else config.distro_from,
            simulator_from=None if wishes.simulator else config.simulator_from,
        )
    )


def _selection(config: Config, wishes: Wishes) -> Selection:
    return validate_selection(
        Selection(
            select=wishes.select or config.select,
            ignore=(*wishes.ignore, *config.ignore),
            extend=config.extend_select,
            severities=config.severities,
        )
    )
