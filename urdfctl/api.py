"""urdfctl from Python: what the commands find and make, as objects.

    from urdfctl.api import lint

    report = lint("urdf/robot.xacro", args={"prefix": "left_"}, distro="jazzy")
    assert not report.findings

Each function does what the command of its name does, and takes the options of that command as keywords, with
underscores for dashes: `lint(".", fail_on="warning", ignore=["UC155"])`. It prints nothing, writes nothing, and reads
only what the command would read. Bad input raises UserError with the line that the command would print; an option that
the command does not have raises TypeError. Calls from several threads wait for each other.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from threading import Lock
from typing import TYPE_CHECKING, Any

from urdfctl.commands import command_named
from urdfctl.commands.declaring import Options
from urdfctl.commands.reach import within_reach
from urdfctl.errors import UserError
from urdfctl.source.disk.shown import forget_files

if TYPE_CHECKING:
    from urdfctl.lint.results import Report
    from urdfctl.migrate.engine import Migration
    from urdfctl.model.robot import Robot
    from urdfctl.smoke.reports import SmokeReport

__all__ = ["Path", "UserError", "expand", "explain", "generate", "lint", "load_robot", "migrate", "smoke"]

Path = str | os.PathLike[str]
"""The path of a file or folder."""
_ONE_AT_A_TIME = Lock()


def lint(*paths: Path, args: Mapping[str, str] | None = None, **options: Any) -> Report:
    """Return the report of `urdfctl lint`: `findings` has each finding once, causes before consequences.

    paths: files and folders; the package around the current folder if there are none.
    args: the arguments of the descriptions.
    """
    from urdfctl.commands.find.lint import fail_on_of, request_of
    from urdfctl.commands.words import baseline_of
    from urdfctl.lint import run

    with _options("lint", options, paths=_words(paths, args)) as given:
        request = request_of(given)
        fail_on = fail_on_of(given, request)
        baseline = baseline_of(given, [request.config], request.selection, found_by="lint")
        return run.report(run.lint(request), request, fail_on=fail_on, unknown=baseline and baseline.unknown)


def smoke(*paths: Path, args: Mapping[str, str] | None = None, **options: Any) -> SmokeReport:
    """Return the report of `urdfctl smoke`: `robots` with their controllers, and in `found` the findings of all."""
    from urdfctl.commands.find.smoke import tested

    with _options("smoke", options, paths=_words(paths, args), progress=False) as given:
        return tested(given, lambda tests, _number: tests)[1]


def expand(path: Path, args: Mapping[str, str] | None = None, **options: Any) -> str:
    """Return the text that `urdfctl expand` prints. Raises UserError with the first problem if there is none."""
    from urdfctl.commands.understand.expand import expansion

    with _options("expand", options, file=os.fspath(path), arguments=_words((), args)) as given:
        expanded = expansion(given)
        if expanded.text is None:
            first = expanded.problems[0]
            raise UserError(f"{first.at.file}:{first.at.line}:{first.at.column}: {first.message}")
        return expanded.text


def load_robot(path: Path, args: Mapping[str, str] | None = None, **options: Any) -> Robot:
    """Return the robot of a description: links, joints, transmissions, ros2_control components, each with its place.

    It is expanded in this process, within limits on its work but none on time and memory. Raises UserError if there is
    no robot in it.
    """
    from urdfctl.commands.find.lint import request_of
    from urdfctl.load.loader import Loader
    from urdfctl.load.target import Target

    with _options("lint", options, paths=_words((path,), args)) as given:
        request = request_of(given)
        target = Target(os.fspath(path), request.arguments)
        if not os.path.isfile(target.path):
            raise UserError(f"file '{target.path}' does not exist")
        loader = Loader(request.settings)
        with loader.reading_for(target.path):
            project = loader.load(target).project
        if project.robot is None:
            problem = next((problem.message for problem in project.problems), "it describes no robot")
            raise UserError(f"'{target.path}' cannot be loaded: {problem}")
        return project.robot


def generate(command: str, *words: Path, args: Mapping[str, str] | None = None, **options: Any) -> dict[str, str]:
    """Return the files of a generator, such as "gen-all" or "gen-controllers", by their names. Nothing is written.

    words: the robot, or lists of joints.
    """
    from urdfctl.commands.generate.running import UnreadableRobot, generated

    if not command.startswith("gen-") or command == "gen-check":
        raise UserError(f"'{command}' is no generator; see urdfctl --help")
    with _options(command, options, words=_words(words, args)) as given:
        try:
            return {file.name: file.text for file in generated(given).files}
        except UnreadableRobot as error:
            raise UserError(str(error).rstrip()) from None


def migrate(*paths: Path, to: str, **options: Any) -> Migration:
    """Return what `urdfctl migrate` would change: `changes`, files with their bytes before and after, and `lines`, the
    report. Nothing is written."""
    from urdfctl.commands.migrate import migration_of, settings_in, with_own_names
    from urdfctl.migrate import engine
    from urdfctl.migrate.steps import STEPS
    from urdfctl.migrate.trial.linting import Lint
    from urdfctl.migrate.trial.scratch import Scratch

    with (
        _options("migrate", options, paths=_words(paths, None), to=to) as given,
        closing(Scratch(given.paths or [os.curdir])) as scratch,
    ):
        lint = Lint(scratch, lambda results, _number: results)
        return engine.migrate(
            scratch, with_own_names(migration_of(given), scratch, given), settings_in(scratch, given), lint, STEPS
        )


def explain(*what: str, **options: Any) -> str:
    """Return the explanation of a fault by its code or name, of a message, or of a log file."""
    from urdfctl.commands.understand.explain import explanation

    with _options("explain", options, what=what) as given:
        return explanation(given)


@contextmanager
def _options(command: str, options: Mapping[str, Any], **own: Any) -> Iterator[Any]:
    """Give the options of a command, within what it may read. A sequence may be a list, a path of any kind."""
    kind: type[Options] = command_named(command).options
    given = kind(**own, **{name: _plain(value) for name, value in options.items()})
    with _ONE_AT_A_TIME:
        forget_files()
        with within_reach(given):
            yield given


def _plain(value: object) -> object:
    """The value of an option as the command line has it."""
    if type(value) in (list, tuple):
        return tuple(map(_plain, value))  # type: ignore[call-overload]
    return os.fspath(value) if isinstance(value, os.PathLike) else value


def _words(paths: tuple[Path, ...], args: Mapping[str, str] | None) -> tuple[str, ...]:
    return (*(os.fspath(path) for path in paths), *(f"{name}:={value}" for name, value in (args or {}).items()))
