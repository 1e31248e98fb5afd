"""`urdfctl gen-check`: makes generated files again, each by the command that it names, and tells which are stale."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import takewhile

from urdfctl.cli.writing import tell
from urdfctl.discover import check_readable
from urdfctl.errors import UserError
from urdfctl.record import NamedTuple
from urdfctl.source.files import first_bytes

_SAID = re.compile(r"made by urdfctl (gen-[a-z0-9-]+)(.*?)(?: -->)?$")
_PARTS = ("config", "urdf", "launch")
_FIRST = 1 << 16
_NOT_BY_A_FILE = re.compile(
    r"-o.*|--?(output|into|force|diff|check|trust|templates|package-path|workspace|config)(=.*)?"
)
"""What a file may not ask for: where to write, what to read besides, whom to trust."""


class Origin(NamedTuple):
    """A generated file, or a folder of a package, and the words that made it; the paths in them are from `home`."""

    path: str
    words: tuple[str, ...]
    home: str

    @property
    def command(self) -> tuple[str, ...]:
        """The words of the command that says where it goes."""
        return (*self.words, "-o", os.path.relpath(self.path, self.home))


def run_again(paths: Sequence[str], *, update: bool) -> int:
    """Check the generated files among some files and folders, or update them, and give the exit status."""
    from typer.main import get_command

    from urdfctl.cli.app import app

    stale = False
    for origin in dict.fromkeys(_origins(paths or ["."])):
        with _standing_in(origin.home):
            try:
                status = get_command(app).main(
                    [*origin.command, "--force" if update else "--check"], prog_name="urdfctl", standalone_mode=False
                )
            except UserError as error:
                raise UserError(f"'{os.path.relpath(origin.path)}' cannot be made again: {error}") from None
        stale = stale or bool(status)
    return int(stale)


def _origins(paths: Sequence[str]) -> Iterator[Origin]:
    for path in paths:
        if not os.path.exists(path):
            raise UserError(f"no such file or folder: '{path}'")
        for file in _files(path):
            words = words_that_made(file)
            origin = _origin(file, words) if words else None
            if origin:
                yield origin


def _files(path: str) -> Iterator[str]:
    if not os.path.isdir(path):
        yield path
        return
    check_readable(path)
    for folder, folders, names in os.walk(path):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        yield from (os.path.normpath(os.path.join(folder, name)) for name in sorted(names))


def words_that_made(file: str) -> tuple[str, ...] | None:
    """The words that made a file, as its first two lines say; None where they do not."""
    try:
        lines = first_bytes(file, _FIRST).decode("utf-8", "replace").splitlines()[:2]
    except OSError:
        return None
    for line in lines:
        said = _SAID.search(line)
        if said:
            try:
                return (said[1], *shlex.split(said[2]))
            except ValueError:
                return None
    return None


def _origin(file: str, words: tuple[str, ...]) -> Origin | None:
    """How to make a file again; None, and a line that says why, where that cannot be."""
    first = takewhile(lambda word: word == "-" or not word.startswith("-"), words[1:])
    read = [word for word in first if ":=" not in word]
    asked = next((word for word in words if _NOT_BY_A_FILE.fullmatch(word)), None)
    above = list(_above(file))
    if not read:
        above = [folder for folder in above if os.path.exists(os.path.join(folder, "package.xml"))]
    homes = [os.curdir, *above] if read or not above else above
    home = next((home for home in homes if all(os.path.exists(os.path.join(home, path)) for path in read)), None)
    if asked or home is None or "-" in read:
        why = f"its command has {asked}" if asked else f"there is no {' '.join(read)}"
        why = "it was made from standard input" if "-" in read else why
        tell(f"'{file}' is passed over: {why}")
        return None
    if words[0] != "gen-all":
        return Origin(os.path.abspath(file), words, os.path.abspath(home))
    folder = os.path.dirname(os.path.abspath(file))
    package = os.path.dirname(folder) if os.path.basename(folder) in _PARTS else folder
    return Origin(package, words, os.path.abspath(home))


def _above(file: str) -> Iterator[str]:
    """The folders that hold a file, the nearest first."""
    folder = os.path.dirname(os.path.abspath(file))
    while True:
        yield folder
        if os.path.dirname(folder) == folder:
            return
        folder = os.path.dirname(folder)


@contextmanager
def _standing_in(folder: str) -> Iterator[None]:
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
