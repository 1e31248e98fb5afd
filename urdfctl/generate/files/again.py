"""`urdfctl gen-check`: run the command in each generated file again, and report the files that are out of date."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from itertools import takewhile

from urdfctl.discover.robots import check_readable
from urdfctl.errors import UserError
from urdfctl.output.answer import CommandAnswer, FileState
from urdfctl.source.disk.files import first_bytes, folders_upwards
from urdfctl.source.disk.gate import admits, exists, names_in, reading_within, walk
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.startup.records import NamedTuple

_COMMAND = re.compile(r"made by urdfctl (gen-[a-z0-9-]+|convert)(.*?)(?: -->)?$")
_PARTS = ("config", "urdf", "launch", "mujoco")
_LONG = re.compile(r"^-(?=[a-z]{2})")
"""An option in an XML comment has one dash."""
_PACKAGES = ("gen-all", "gen-moveit")
"""The commands that write a package."""
_FIRST = 1 << 16
_COPY = (
    "was checked against the copy of the robot in it; to check it against the original, run gen-check in the folder in "
    "which {} was run"
)
_FORBIDDEN = re.compile(
    r"-o.*|--?(output|into|force|diff|check|trust|templates|package-path|workspace|config|env|timeout|memory)(=.*)?"
)
"""Options that the command in a file cannot set: output files, further inputs, trust, limits. Its author is not the one
who runs it."""


class GeneratedOrigin(NamedTuple):
    """A generated file or package.

    path: the file, or the folder of the package.
    words: the command that generated it.
    home: the folder that paths in the command are relative to.
    workspace: the workspace of the file: the command reads nothing outside of it.
    """

    path: str
    words: tuple[str, ...]
    home: str
    workspace: str

    @property
    def command(self) -> tuple[str, ...]:
        """Return the words of the command with its output."""
        return (*self.words, "-o", os.path.relpath(self.path, self.home))


def run_again(
    paths: Sequence[str],
    generate: Callable[[Sequence[str], CommandAnswer], int],
    answer: CommandAnswer,
    *,
    update: bool,
) -> int:
    """Check or update the generated files among some files and folders, and return the exit status.

    generate: runs the command line of a generator and returns its exit status.
    """
    stale, start = False, os.getcwd()
    origins = list(dict.fromkeys(_origins(paths or ["."], answer)))
    if not origins:
        raise UserError(f"no generated file was checked in {', '.join(paths or ['this folder'])}")
    for origin in origins:
        made = CommandAnswer(is_kept=True)
        with reading_within([origin.workspace]), _working_in(origin.home):
            try:
                status = generate([*origin.command, "--force" if update else "--check"], made)
            except UserError as error:
                raise UserError(f"'{os.path.relpath(origin.path)}' cannot be generated again: {error}") from None
        stale = stale or bool(status)
        _tell(made, answer, origin, start)
        if _has_a_copy(origin):
            answer.message(f"'{os.path.relpath(origin.path, start)}' {_COPY.format(origin.words[0])}")
    return int(stale)


def _tell(made: CommandAnswer, answer: CommandAnswer, origin: GeneratedOrigin, start: str) -> None:
    """Say what was found of a generated file, or of those of a package, with paths from the folder of the run."""
    if not made.files:
        answer.messages(f"{os.path.relpath(origin.path, start)}: {line}" for line in made.lines)
    for path, file in made.files.items():
        shown = os.path.relpath(os.path.join(origin.home, path), start)
        if file["state"] == FileState.OUT_OF_DATE.value:
            answer.out_of_date(shown)
            continue
        state = FileState(file["state"])
        answer.file(shown, state)
        if state is FileState.WRITTEN:
            answer.message(f"'{shown}' written")


def _origins(paths: Sequence[str], answer: CommandAnswer) -> Iterator[GeneratedOrigin]:
    for path in paths:
        if not os.path.exists(path):
            raise UserError(f"file or folder '{path}' does not exist")
        for file in _files(path):
            words = words_of_generated_file(file)
            if words:
                workspace = workspace_of(os.path.abspath(file))
                with reading_within([workspace]):
                    origin = _origin(file, words, workspace)
                if isinstance(origin, GeneratedOrigin):
                    yield origin
                elif file not in answer.files:
                    answer.file(file, FileState.SKIPPED, reason=origin)
                    answer.message(f"'{file}' is skipped: {origin}")


def _files(path: str) -> Iterator[str]:
    if not os.path.isdir(path):
        yield path
        return
    check_readable(path)
    for folder, folders, names in walk(path):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        yield from (os.path.normpath(os.path.join(folder, name)) for name in sorted(names))


def words_of_generated_file(file: str) -> tuple[str, ...] | None:
    """Return the command in the first two lines of a generated file; None if there is none."""
    try:
        lines = first_bytes(file, _FIRST).decode("utf-8", "replace").splitlines()[:2]
    except OSError:
        return None
    for line in lines:
        command = _COMMAND.search(line)
        if command:
            try:
                return (command[1], *(_LONG.sub("--", word) for word in shlex.split(command[2])))
            except ValueError:
                return None
    return None


def _origin(file: str, words: tuple[str, ...], workspace: str) -> GeneratedOrigin | str:
    """Return how to generate a file again, or why that is not possible."""
    first = takewhile(lambda word: word == "-" or not word.startswith("-"), words[1:])
    inputs = [word for word in first if ":=" not in word]
    forbidden = next((word for word in words if _FORBIDDEN.fullmatch(word)), None)
    folder = os.path.dirname(os.path.abspath(file))
    is_part = os.path.basename(folder) in _PARTS and not exists(os.path.join(folder, "package.xml"))
    package = os.path.dirname(folder) if is_part else folder
    above = list(folders_upwards(folder))
    if not inputs:
        above = [folder for folder in above if exists(os.path.join(folder, "package.xml"))]
    homes = [home for home in ([os.curdir, *above] if inputs or not above else above) if admits(home)]
    if words[0] in _PACKAGES:  # the package may hold a copy of its robot, which is no input: it is searched last
        outside = [home for home in homes if not f"{os.path.abspath(home)}{os.sep}".startswith(f"{package}{os.sep}")]
        homes = (
            outside
            if any(_has(home, inputs) for home in outside)
            else [*outside, *_only_beside(package, inputs), package]
        )
    home = next((home for home in homes if _has(home, inputs)), None)
    if forbidden or home is None or "-" in inputs:
        outside = [path for path in inputs if not any(admits(os.path.join(home, path)) for home in homes)]
        where = f"is outside the workspace '{workspace}'" if outside else "does not exist"
        why = f"its command sets {forbidden}" if forbidden else f"its input '{' '.join(outside or inputs)}' {where}"
        return "it was generated from standard input" if "-" in inputs else why
    if words[0] not in _PACKAGES:
        return GeneratedOrigin(os.path.abspath(file), words, os.path.abspath(home), workspace)
    return GeneratedOrigin(package, words, os.path.abspath(home), workspace)


def _has(home: str, inputs: Sequence[str]) -> bool:
    return all(exists(os.path.join(home, path)) for path in inputs)


def _only_beside(package: str, inputs: Sequence[str]) -> list[str]:
    """The folder beside a package that has the inputs of its command, if it is the only one: it ran there."""
    try:
        folders = [os.path.join(os.path.dirname(package), name) for name in names_in(os.path.dirname(package))]
    except OSError:
        return []
    found = [folder for folder in folders if folder != package and _has(folder, inputs)]
    return found if inputs and len(found) == 1 else []


def _has_a_copy(origin: GeneratedOrigin) -> bool:
    """Whether a package was compared with the robot in itself, though its package.xml is generated: with a copy."""
    is_own = origin.words[0] in _PACKAGES and origin.home == origin.path
    return is_own and words_of_generated_file(os.path.join(origin.path, "package.xml")) is not None


@contextmanager
def _working_in(folder: str) -> Iterator[None]:
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
