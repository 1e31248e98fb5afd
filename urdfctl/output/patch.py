"""Show changes as a unified diff for `git apply` and `patch -p1`."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.output.change import Change
from urdfctl.source.disk.files import folders_upwards

_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"}


def patch(changes: Iterable[Change]) -> bytes:
    """Return the changes as a diff, with paths relative to the current folder, or to the repository of the files.

    `git apply` rejects paths that lead out of the folder in which it runs.
    """
    changes = list(changes)
    base = _base([change.file for change in changes])
    return b"".join(line for change in changes for line in _lines(change, base))


def _base(files: Sequence[str]) -> str:
    """The current folder if all files are below it, else their only repository if they have one."""
    here = os.path.realpath(os.curdir)
    repositories = {_repository(file) for file in files if not file.startswith(os.path.join(here, ""))}
    return repositories.pop() or here if len(repositories) == 1 else here


def _repository(file: str) -> str:
    """The repository that a file is in; empty if it is in none."""
    folders = folders_upwards(os.path.dirname(file))
    return next((folder for folder in folders if os.path.exists(os.path.join(folder, ".git"))), "")


def _lines(change: Change, base: str) -> Iterator[bytes]:
    from difflib import diff_bytes, unified_diff

    name = os.path.relpath(change.file, base).replace(os.sep, "/")
    old, new = _split(change.before or b""), _split(change.after or b"")
    header, new_header = _header("a", name), _header("b", name)
    if change.before is None or change.after is None:
        is_new = change.before is None
        yield b"diff --git %s %s\n" % (header.rstrip(b"\t"), new_header.rstrip(b"\t"))
        yield b"new file mode 100644\n" if is_new else b"deleted file mode 100644\n"
        header, new_header = (b"/dev/null", new_header) if is_new else (header, b"/dev/null")
    for line in diff_bytes(unified_diff, old, new, header, new_header):
        yield line if line.endswith(b"\n") else line + b"\n\\ No newline at end of file\n"


def _split(data: bytes) -> list[bytes]:
    """Return the lines as git splits them: only at LF."""
    lines = [line + b"\n" for line in data.split(b"\n")]
    lines[-1] = lines[-1][:-1]
    return lines if lines[-1] else lines[:-1]


def _header(side: str, name: str) -> bytes:
    """Return a path as git writes it: quoted if it has special characters, with a tab after it if it has spaces."""
    path = f"{side}/{name}"
    if any(character in path for character in _ESCAPES):
        path = '"' + "".join(_ESCAPES.get(character, character) for character in path) + '"'
    elif " " in path:
        path += "\t"
    return os.fsencode(path)
