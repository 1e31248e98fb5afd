"""Run a command and watch what it opens, lists, looks at and starts, in all of its processes."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from folder import CHECKOUT, environment

_HOOK = """
import os, sys

def _watch():
    log = os.open({log!r}, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)
    kinds = {{"open": "opened", "os.listdir": "listed", "os.scandir": "listed", "subprocess.Popen": "started"}}
    is_noting = []

    def note(kind, what):
        if is_noting:
            return
        is_noting.append(True)
        try:
            if kind != "started":
                what = os.path.realpath(os.fsdecode(what))
            os.write(log, (repr((kind, what)) + chr(10)).encode("utf-8", "surrogatepass"))
        finally:
            is_noting.clear()

    def hook(event, arguments):
        kind = kinds.get(event)
        if kind == "started":
            note(kind, [os.fsdecode(word) for word in arguments[1]])
        elif kind and isinstance(arguments[0], (str, bytes, os.PathLike)):
            note(kind, arguments[0])

    sys.addaudithook(hook)
    stat = os.stat

    def noted_stat(path, *arguments, **options):
        if isinstance(path, (str, bytes, os.PathLike)) and options.get("follow_symlinks", True):
            try:
                note("looked at", path)
            except ValueError:
                pass
        return stat(path, *arguments, **options)

    os.stat = noted_stat

_watch()
import urdfctl.__main__
urdfctl.__main__.main()
"""
"""`os.stat` is no event of Python's audit; it is what `os.path.exists` and its like call. Forks inherit all of it."""


class Watched(NamedTuple):
    """What a command did.

    ran: the process, with its output.
    opened, listed, looked_at: real paths of files that were opened, of folders that were listed, and of what was asked
        for whether it exists.
    started: the programs that were started, with their arguments.
    """

    ran: subprocess.CompletedProcess[str]
    opened: set[str]
    listed: set[str]
    looked_at: set[str]
    started: list[list[str]]

    def read_outside(self, *folders: Path) -> set[str]:
        """Return what was opened or listed outside of some folders, of Python and of urdfctl."""
        own = [*folders, CHECKOUT, *map(Path, (sys.prefix, sys.base_prefix, *sys.path)), *_OF_THE_SYSTEM]
        roots = [os.path.realpath(root) for root in own if str(root) not in ("", ".")]
        return {path for path in self.opened | self.listed if not any(_is_in(path, root) for root in roots)}

    def read_in(self, folder: Path) -> set[str]:
        """Return what was opened or listed in a folder."""
        return {path for path in self.opened | self.listed if _is_in(path, os.path.realpath(folder))}

    def looked_at_in(self, folder: Path) -> set[str]:
        """Return what a command asked about in a folder: whether it exists, and what it is."""
        return {path for path in self.looked_at if _is_in(path, os.path.realpath(folder))}


_OF_THE_SYSTEM = tuple(map(Path, ("/proc", "/sys", "/dev/null", "/dev/urandom", "/usr/lib", "/usr/share/zoneinfo")))


def _is_in(path: str, folder: str) -> bool:
    return (path + os.sep).startswith(folder.rstrip(os.sep) + os.sep)


def watched(words: Sequence[str], cwd: Path, scratch: Path, environ: Mapping[str, str | None] | None = None) -> Watched:
    """Run `urdfctl` in a folder.

    scratch: a folder for the temporary files of the command, and for the notes about it.
    """
    scratch.mkdir(parents=True, exist_ok=True)
    log = scratch / "watched"
    log.write_bytes(b"")
    own = {"TMPDIR": str(scratch), "XDG_CACHE_HOME": str(scratch), **(environ or {})}
    ran = subprocess.run(
        [sys.executable, "-c", _HOOK.format(log=str(log)), *words],
        cwd=cwd,
        env=environment(own),
        capture_output=True,
        encoding="utf-8",
        errors="surrogateescape",
        stdin=subprocess.DEVNULL,
        timeout=120,
        check=False,
    )
    notes: dict[str, list[object]] = {"opened": [], "listed": [], "looked at": [], "started": []}
    for line in log.read_text(encoding="utf-8", errors="surrogateescape").splitlines():
        kind, what = _plain(line)
        notes[kind].append(what)
    paths = (set(map(str, notes[kind])) for kind in ("opened", "listed", "looked at"))
    return Watched(ran, *paths, started=[list(map(str, one)) for one in notes["started"] if isinstance(one, list)])


def _plain(line: str) -> tuple[str, object]:
    from ast import literal_eval

    kind, what = literal_eval(line)
    return str(kind), what
