"""The two sides of a comparison: files, folders, variants or git revisions."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from urdfctl.compare.revisions import is_revision, lay_out
from urdfctl.errors import UserError
from urdfctl.names import nearest_path
from urdfctl.output.scratch import scratch_folder
from urdfctl.run.git import repository_of
from urdfctl.source.workspaces.packages import package_around
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.startup.records import NamedTuple

HOW = "urdfctl diff A B; each is a file, a folder, or a revision such as HEAD~1:urdf/robot.xacro"


class Side(NamedTuple):
    """One side of a comparison.

    word: what the user named.
    path: the file or folder.
    arguments: `name:=value` words.
    roots: folders whose paths say nothing of the robot, the innermost first.
    is_laid_out: whether the files are those of a git revision.
    """

    word: str
    path: str
    arguments: tuple[str, ...]
    roots: tuple[str, ...]
    is_laid_out: bool = False

    @property
    def shown(self) -> str:
        """How the user named it."""
        return " ".join([self.word, *self.arguments])


@contextmanager
def sides_of(words: Sequence[str], workspace: str | None) -> Iterator[tuple[Side, Side]]:
    """Give the two sides that words name; the files of a git revision exist only meanwhile.

    Raises UserError if there are not two, or one does not exist.
    """
    named = _named(words)
    paths = [_path_in(word) for word, _ in named]
    with scratch_folder() as temporary:
        folder = os.path.realpath(temporary)
        sides = []
        for number, (word, arguments) in enumerate(named):
            if is_revision(word):
                path = paths[number] or paths[1 - number]
                if not path:
                    raise UserError(f"'{word}' needs a path, or another side that has one: {HOW}")
                sides.append(_revision(word, path, arguments, os.path.join(folder, str(number))))
            else:
                sides.append(_plain(word, arguments, workspace))
        yield sides[0], sides[1]


def _named(words: Sequence[str]) -> list[tuple[str, tuple[str, ...]]]:
    """The two words that are no arguments, each with those behind it; those before the first are for both."""
    both: list[str] = []
    named: list[tuple[str, list[str]]] = []
    for word in words:
        if ":=" in word:
            (named[-1][1] if named else both).append(word)
        else:
            named.append((word, []))
    if len(named) != 2:  # noqa: PLR2004
        raise UserError(f"diff needs two robots: {HOW}")
    return [(word, (*both, *own)) for word, own in named]


def _path_in(word: str) -> str:
    return word.partition(":")[2] if is_revision(word) else word


def _plain(word: str, arguments: tuple[str, ...], workspace: str | None) -> Side:
    if not os.path.lexists(word):
        raise UserError(f"file or folder '{word}' does not exist{nearest_path(word)}")
    path = os.path.abspath(word)
    return Side(word, path, arguments, _roots(path, workspace_of(path, workspace)))


def _revision(word: str, path: str, arguments: tuple[str, ...], folder: str) -> Side:
    existing = os.path.abspath(path)
    while not os.path.isdir(existing):
        existing = os.path.dirname(existing)
    repository = repository_of(existing)
    os.mkdir(folder)
    lay_out(repository, word.partition(":")[0], folder)
    beside = os.path.relpath(os.path.realpath(os.path.abspath(path)), repository)
    for inside in (beside, path):
        found = os.path.normpath(os.path.join(folder, inside))
        if os.path.exists(found) and (found + os.sep).startswith(folder + os.sep):
            return Side(word, found, arguments, _roots(found, folder), is_laid_out=True)
    raise UserError(f"git revision '{word.partition(':')[0]}' has no '{path}'")


def _roots(path: str, workspace: str) -> tuple[str, ...]:
    folder = path if os.path.isdir(path) else os.path.dirname(path)
    return tuple(dict.fromkeys([package_around(folder) or folder, workspace]))
