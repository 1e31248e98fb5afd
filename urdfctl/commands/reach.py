"""What a command may read: what follows from its words and the environment, never from what a file contains."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.commands.declaring import Command, Options, Reads
from urdfctl.config.file import package_folders_in
from urdfctl.errors import UserError
from urdfctl.source.disk.gate import is_limited, reading_within
from urdfctl.source.workspaces.packages import package_around
from urdfctl.source.workspaces.workspace import workspace_of

_LINE = r"(?::\d+){1,2}\Z"


def run_command(command: Command, options: Options) -> int:
    """Run a command within what it may read, and return the exit status."""
    with within_reach(options):
        return command.run(options)


def within_reach(options: Options) -> reading_within:
    """Return a context in which this process reads nothing but what a command with these options may read.

    A command that another one runs, as gen-check does, may read what that one may. Raises UserError for a link in a
    workspace that leads out of it: it may be a stranger's.
    """
    is_free = getattr(options, "trust", False) or (is_limited() and options.is_bounded)
    return reading_within(None if is_free else _roots(options) if options.is_bounded else [], in_all_threads=True)


def _named_places(options: Options) -> list[str]:
    """The files and folders that a command is about, by its options; by default the package around the current folder,
    or this folder. A missing one is named all the same."""
    words = [*_words(options, Reads.WORKSPACE), " ".join(_words(options, Reads.WORKSPACE_OF_LINE))]
    named = [_path_in(word) for word in words if ":=" not in word and word not in ("", "-")]
    return named or [package_around(os.getcwd()) or os.curdir]


def is_in_workspace(file: str, places: Sequence[str]) -> bool:
    """Return whether a file is in the workspace of some paths, of the current folder if there are none: whoever wrote
    these may have written it."""
    around = _workspaces(places or [os.curdir])
    return _is_within(_place(file), around) or _is_within(os.path.realpath(file), around)


def _roots(options: Options) -> list[str]:
    places = _named_places(options)
    around, named_workspace = _workspaces(places), getattr(options, "workspace", None)
    roots = _workspaces(places, named_workspace) if named_workspace else [*around]
    targets = [*_words(options, Reads.TARGET)]
    others = [*targets, *_words(options, Reads.PLACE)]
    others += [word.partition("=")[2] for word in _words(options, Reads.PLACE_AFTER_NAME)]
    variables = package_folders_in(os.environ)
    named = {path: os.path.realpath(path) for path in (*places, *others, *variables) if path}
    linked = {path: real for path, real in named.items() if _is_within(_place(path), around)}
    roots += [real for path, real in named.items() if path not in linked or _is_within(real, around)]
    for path, real in linked.items():
        if not _is_within(real, roots) and path not in targets:
            raise UserError(f"'{path}' leads outside the workspace; name what it leads to")
    return roots


def _workspaces(places: Iterable[str], named: str | None = None) -> list[str]:
    """The workspaces of some files and folders, by their real paths; the one that the user names, if any."""
    return list(dict.fromkeys(os.path.realpath(workspace_of(_inside(place), named)) for place in places))


def _words(options: Options, reads: Reads) -> Iterator[str]:
    """The values of the options because of which a command may read something."""
    for name, option in options.declared.items():
        if option.reads is reads:
            value = getattr(options, name)
            yield from (value if option.is_list else () if value is None else (value,))


def _path_in(word: str) -> str:
    """The path in a word: without a line or a git revision, if there is such a file; otherwise the word itself."""
    if os.path.lexists(word):
        return word
    paths = (re.sub(_LINE, "", word), word.partition(":")[2])
    return next((path for path in paths if path and os.path.lexists(path)), word)


def _inside(path: str) -> str:
    """A path whose workspace is that of a file or a folder."""
    path = os.path.abspath(path)
    return os.path.join(path, "robot") if os.path.isdir(path) else path


def _place(path: str) -> str:
    """Where a path is, whatever it leads to."""
    folder, name = os.path.split(os.path.abspath(path))
    return os.path.join(os.path.realpath(folder), name)


def _is_within(path: str, folders: Iterable[str]) -> bool:
    return any((path + os.sep).startswith(folder.rstrip(os.sep) + os.sep) for folder in folders)
