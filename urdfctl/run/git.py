"""Ask git about a repository whose files, objects and configuration strangers may have written.

git only reads: it runs no program that the repository's configuration names (hooks, filters, a monitor of the file
system, ssh), fetches nothing, and writes nothing but the commits that a user asks for. What it prints is read up to a
limit.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from tempfile import TemporaryFile
from threading import Timer
from typing import IO

from urdfctl.errors import UserError
from urdfctl.startup.records import NamedTuple

MOST_ENTRIES = 200_000
"""A tree with more files is not listed: a few objects can describe a tree with more files than atoms."""
_MOST_OUTPUT = 16 << 20
_MOST_LINE = 4096
_SECONDS = 120.0
"""git is ended after this time: it may wait for a pipe in the place of a file."""
_SETTINGS = (
    "core.fsmonitor=false",
    f"core.hooksPath={os.devnull}",
    "protocol.allow=never",
    "safe.bareRepository=explicit",
    "maintenance.auto=false",
    "gc.auto=0",
)
_ENVIRONMENT = {
    "GIT_NO_LAZY_FETCH": "1",
    "GIT_OPTIONAL_LOCKS": "0",
    "GIT_TERMINAL_PROMPT": "0",
    "LC_ALL": "C",
}
_OF_REPOSITORY = (
    *("GIT_DIR", "GIT_WORK_TREE", "GIT_COMMON_DIR", "GIT_INDEX_FILE", "GIT_PREFIX", "GIT_NAMESPACE", "GIT_GRAFT_FILE"),
    *("GIT_OBJECT_DIRECTORY", "GIT_ALTERNATE_OBJECT_DIRECTORIES", "GIT_SHALLOW_FILE", "GIT_REPLACE_REF_BASE"),
)
"""Variables that a hook of another repository may have set."""
_FILTERS = r"^filter\..*\.(clean|smudge|process|required)$"


class TreeEntry(NamedTuple):
    """A file in a tree.

    mode: 100644 or 100755 for a file, 120000 for a symbolic link, 160000 for a submodule; in octal digits.
    key: the hash of its object.
    name: its path, with forward slashes; not checked.
    """

    mode: str
    key: str
    name: str


class Blobs:
    """The objects of files, by their hashes."""

    def __init__(self, sizes: _Process, contents: _Process) -> None:
        self._sizes, self._contents = sizes, contents

    def size(self, key: str) -> int | None:
        """Return the size of a file in bytes; None if its object is missing, or is none of a file."""
        return _size_in(self._sizes.answer(key))

    def content(self, key: str) -> bytes | None:
        """Return the content of a file; None if its object is missing, or is none of a file."""
        size = _size_in(self._contents.answer(key))
        if size is None:
            return None
        data = self._contents.answers.read(size)
        self._contents.answers.read(1)  # a line end
        return data if len(data) == size else None


def _size_in(answer: bytes) -> int | None:
    """The size in `HASH blob SIZE`; None in another answer, such as `HASH missing`."""
    words = answer.split()
    return int(words[2]) if words[1:2] == [b"blob"] and words[2:3] and words[2].isdigit() else None


def repository_of(folder: str) -> str:
    """Return the top folder of the repository around a folder. UserError if there is none."""
    status, found, why = _ask(folder, ["rev-parse", "--show-toplevel"])
    if status != 0 or not found.strip():
        is_none = "not a git repository" in why or not why
        raise UserError(f"'{folder}' is in no git repository" if is_none else f"git cannot read '{folder}': {why}")
    return os.path.realpath(found.strip("\n"))


def commit_of(repository: str, revision: str) -> str | None:
    """Return the hash of the commit that a revision names; None if there is no such revision."""
    words = ["rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}"]
    status, found, _ = _ask(repository, words)
    return found.strip() if status == 0 else None


def remote_of(repository: str) -> str:
    """Return the URL of the remote `origin`; empty if there is none."""
    status, found, _ = _ask(repository, ["config", "--get", "remote.origin.url"])
    return found.strip() if status == 0 else ""


def names_of_revisions(repository: str) -> list[str]:
    """Return the names of branches and tags, for hints."""
    return _ask(repository, ["for-each-ref", "--format=%(refname:short)"])[1].split()


def entries_of(repository: str, commit: str) -> list[TreeEntry]:
    """Return the files of a commit. UserError if they cannot be read, or are more than MOST_ENTRIES."""
    with started_git(repository, ["ls-tree", "-r", "-z", "--full-tree", commit]) as process:
        entries: list[TreeEntry] = []
        for line in _parts(process.answers, b"\0"):
            facts, _, name = line.partition(b"\t")
            mode, _, key = facts.decode("ascii", "replace").split()
            entries.append(TreeEntry(mode, key, os.fsdecode(name)))
            if len(entries) > MOST_ENTRIES:
                raise UserError(f"commit {commit[:10]} has more than {MOST_ENTRIES} files")
        process.check()
    return entries


@contextmanager
def blobs_of(repository: str) -> Iterator[Blobs]:
    """Give a reader of objects. UserError if git fails."""
    with (
        started_git(repository, ["cat-file", "--batch-check"]) as sizes,
        started_git(repository, ["cat-file", "--batch"]) as contents,
    ):
        yield Blobs(sizes, contents)
        sizes.check()
        contents.check()


def has_changes(folder: str) -> bool:
    """Return whether git knows of uncommitted changes in a folder; False without git or a repository."""
    try:
        filters = _filters_of(folder)
        if any(mark in name for name in filters for mark in "=\n"):
            return True  # no option can switch it off, so git is not asked
        settings = [word for name in filters for word in ("-c", f"{name}=")]
        words = ["status", "--porcelain", "--ignore-submodules=all", "--", "."]
        status, found, _ = _ask(folder, words, settings)
    except UserError:
        return False
    return status == 0 and bool(found.strip())


def add_commit(repository: str, files: Sequence[str], message: str) -> None:
    """Commit some files of a repository as they are now, and nothing else. UserError if git does not.

    Neither hooks nor filters of the repository run, and nothing is signed.
    """
    filters = _filters_of(repository)
    if any(mark in name for name in filters for mark in "=\n"):
        raise UserError(f"'{repository}' has a filter of files whose name git cannot switch off; commit by hand")
    settings = [word for name in filters for word in ("-c", f"{name}=")]
    settings += ["-c", "commit.gpgSign=false"]
    names = [os.path.relpath(file, repository) for file in files]
    for words in (["add", "--all", "--force"], ["commit", "--quiet", "--no-verify", "--message", message]):
        with started_git(repository, [*words, "--", *names], settings) as process:
            process.check()


def _filters_of(folder: str) -> list[str]:
    """The settings of a repository that make git run programs on the content of files, by name."""
    _, found, _ = _ask(folder, ["config", "--local", "--includes", "--name-only", "-z", "--get-regexp", _FILTERS])
    return [name for name in dict.fromkeys(found.split("\0")) if name]


# -- processes ---------------------------------------------------------------------------------------------------------


class _Process:
    """git, with its standard input and output, and a file with its errors."""

    def __init__(self, words: Sequence[str], environment: Mapping[str, str], errors: IO[bytes]) -> None:
        self._errors = errors
        self._process = subprocess.Popen(  # noqa: S603 (git itself, with words of ours)
            words, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors
        )
        assert self._process.stdin is not None  # noqa: S101 (for mypy)
        assert self._process.stdout is not None  # noqa: S101 (for mypy)
        self.requests, self.answers = self._process.stdin, self._process.stdout
        self._timer = Timer(_SECONDS, self._process.kill)
        self._timer.daemon = True
        self._timer.start()

    def answer(self, request: str) -> bytes:
        """Return the line that it answers to a line; empty if it has ended."""
        with suppress(OSError):
            self.requests.write(f"{request}\n".encode())
            self.requests.flush()
        return self.answers.readline(_MOST_LINE)

    def end(self) -> None:
        """End it."""
        self._timer.cancel()
        self._process.kill()
        self.status()
        self.answers.close()

    def status(self) -> int:
        """Return its exit status, after its end."""
        with suppress(OSError):
            self.requests.close()
        return self._process.wait()

    def why(self) -> str:
        """The last line that it printed to standard error."""
        self._errors.seek(0)
        lines = self._errors.read(_MOST_OUTPUT).decode("utf-8", "replace").strip().splitlines()
        return lines[-1] if lines else ""

    def check(self) -> None:
        """Wait for its end. UserError if it fails."""
        status = self.status()
        if status != 0:
            raise UserError(f"git fails: {self.why() or f'status {status}'}")


def _ask(folder: str, words: Sequence[str], settings: Sequence[str] = ()) -> tuple[int, str, str]:
    """The exit status of git, what it prints, and the last line of its errors."""
    with started_git(folder, words, settings) as process:
        data = process.answers.read(_MOST_OUTPUT + 1)
        if len(data) > _MOST_OUTPUT:
            raise UserError(f"git prints more than {_MOST_OUTPUT >> 20} MiB about '{folder}'")
        return process.status(), os.fsdecode(data), process.why()


@contextmanager
def started_git(folder: str, words: Sequence[str], settings: Sequence[str] = ()) -> Iterator[_Process]:
    """Start git in a folder; end it afterwards, and when its time is over."""
    own = [word for setting in _SETTINGS for word in ("-c", setting)]
    environment = {name: value for name, value in os.environ.items() if name not in _OF_REPOSITORY} | _ENVIRONMENT
    with TemporaryFile() as errors:
        process = _Process([_program(), "--no-pager", "-C", folder, *own, *settings, *words], environment, errors)
        try:
            yield process
        finally:
            process.end()


def _program() -> str:
    """The path of git. Windows would look in the current folder first.

    Raises UserError if it is not installed.
    """
    name = "git.exe" if sys.platform == "win32" else "git"
    for folder in os.environ.get("PATH", os.defpath).split(os.pathsep):
        path = os.path.join(folder, name)
        if os.path.isabs(path) and os.path.isfile(path) and os.access(path, os.X_OK):
            return path
    raise UserError("git is not installed; without it, no revisions can be compared")


def _parts(stream: IO[bytes], end: bytes) -> Iterator[bytes]:
    """Yield the parts of a stream, which `end` ends. UserError if one is larger than the limit of the output."""
    rest = b""
    while piece := stream.read(1 << 16):
        *parts, rest = (rest + piece).split(end)
        yield from parts
        if len(rest) > _MOST_OUTPUT:
            raise UserError(f"git prints a name of more than {_MOST_OUTPUT >> 20} MiB")
