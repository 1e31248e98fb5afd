"""Results of earlier runs, in the user's cache folder: a run without changes does nothing again.

A run is stored with a fingerprint of everything that it could read or look for: names, sizes and times of all files and
folders of its workspaces, package paths and configuration, the settings, and urdfctl itself. A file that appears,
vanishes or changes gives another fingerprint. In doubt (too many files, an installed ROS) nothing is stored.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from operator import sub
from typing import Any
from zlib import crc32

from urdfctl import __version__
from urdfctl.config.settings import Settings
from urdfctl.lint.judging import LintRun
from urdfctl.lint.results import Unjoined
from urdfctl.lint.serialising import result_from_json, result_to_json
from urdfctl.load.target import Target
from urdfctl.output.cache_folder import cache_folder
from urdfctl.rules.installed import installed_rules
from urdfctl.source.disk.gate import admits
from urdfctl.source.workspaces.packages import ELSEWHERE
from urdfctl.source.workspaces.workspace import workspace_of

STORE_FROM = 0.5
"""Seconds, of the clock or of all processors together, that a run has to take to be worth storing."""
_MAX_ENTRIES = 50_000
"""Files and folders that are looked at for a fingerprint."""
MAX_STORED = 50
"""Runs that are kept; older ones are deleted."""
_PRUNED = frozenset({"__pycache__", "node_modules", ".venv"})


class RunCache:
    """The stored results of one run, which is known by what was asked for."""

    def __init__(self, paths: Sequence[str], settings: Settings, request: object, *, extra: Iterable[str] = ()) -> None:
        """Prepare the cache for a run.

        paths: those of the command line. request: what else was asked for; its repr is part of the key.
        extra: files that the run reads besides, such as the configuration.
        """
        self._began = clocks(), time.time_ns()
        self._paths, self._settings, self._extra = paths, settings, tuple(extra)
        self._asked = repr((__version__, sys.version_info[:3], os.getcwd(), tuple(paths), settings.to_json(), request))

    @property
    def _file(self) -> str | None:
        """The file for what was asked; two questions may share one, so that it has the question in it."""
        folder = cache_folder()
        elsewhere = any(self._settings.environ.get(name) for name in ELSEWHERE)
        if folder is None or elsewhere:
            return None
        name = crc32(self._asked.encode("utf-8", "surrogatepass"))
        return os.path.join(folder, f"{name:08x}.json")

    def _fingerprint(self, before: int | None = None) -> str | None:
        """A hash of all that the run could read; None if that is too much, or if something changed after `before`."""
        from hashlib import blake2b

        named = [os.path.abspath(path) for path in self._paths or (os.curdir,)]
        inside = [os.path.join(path, "robot") if os.path.isdir(path) else path for path in named]
        roots = {*named, *(workspace_of(path, self._settings.workspace) for path in inside)}
        roots |= {os.path.abspath(path) for path in self._settings.package_paths}
        digest = blake2b()
        parents = {os.path.dirname(root) for root in roots}
        own = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
        lines = chain(
            *(_line(path) for path in sorted({*self._extra, *parents})),
            *(_entries(root) for root in _outermost([*roots, own, *_folders_of_installed_rules()])),
        )
        for count, (facts, changed) in enumerate(lines):
            if count >= _MAX_ENTRIES or (before is not None and changed >= before):
                return None
            digest.update(facts)
        return digest.hexdigest()

    def load(self) -> LintRun | None:
        """Return the stored run; None if there is none."""
        file_name = self._file
        if file_name is None or not os.path.isfile(file_name):
            return None
        try:
            with open(file_name, encoding="utf-8") as file:
                data: dict[str, Any] = json.load(file)
            if data["asked"] != self._asked or data["fingerprint"] != self._fingerprint():
                return None
            results = [(Target.from_json(target), result_from_json(result)) for target, result in data["results"]]
            robots = [results[index][1] for index in data["robots"]]
            silent = tuple(map(result_from_json, data["silent"]))
            unjoined = tuple(map(Unjoined.from_json, data["unjoined"]))
            covered = tuple((path, launch) for path, launch in data["covered"])
            return LintRun(robots, results, silent=silent, unjoined=unjoined, covered=covered)
        except (OSError, LookupError, ValueError, TypeError):
            return None

    def store(self, run: LintRun) -> None:
        """Store a run that took long enough and did not crash; silently nothing if that fails."""
        file_name = self._file
        if file_name is None or run.crashed or max(map(sub, clocks(), self._began[0])) < STORE_FROM:
            return
        fingerprint = self._fingerprint(before=self._began[1])
        if fingerprint is None:
            return
        robots = {id(result) for result in run.robots}
        data = {
            "asked": self._asked,
            "fingerprint": fingerprint,
            "results": [[target._asdict(), result_to_json(result)] for target, result in run.targets],
            "robots": [index for index, result in enumerate(run.results) if id(result) in robots],
            "silent": [result_to_json(result) for result in run.silent],
            "unjoined": [each._asdict() for each in run.unjoined],
            "covered": run.covered,
        }
        text = json.dumps(data)
        from urdfctl.output.temporary import remove_leftovers, write_beside

        folder = os.path.dirname(file_name)
        try:
            os.makedirs(folder, mode=0o700, exist_ok=True)
            remove_leftovers(folder)
            write_beside(file_name, text.encode(), lasting=False)
            _delete_old(folder)
        except (OSError, ValueError):
            return


def _folders_of_installed_rules() -> Iterator[str]:
    """Yield the folders or files of the packages that bring rules."""
    for installed in installed_rules():
        path = sys.modules[installed.module.partition(".")[0]].__file__ or ""
        yield os.path.dirname(path) if os.path.basename(path) == "__init__.py" else path


def clocks() -> tuple[float, float]:
    """Return the seconds that the clock shows, and those that processors have spent on this process and its workers."""
    return time.monotonic(), sum(os.times()[:4])


def _outermost(roots: Iterable[str]) -> list[str]:
    """The folders that are in no other one."""
    kept: list[str] = []
    for root in sorted(roots):
        if not any(root == other or root.startswith(other.rstrip(os.sep) + os.sep) for other in kept):
            kept.append(root)
    return kept


Line = tuple[bytes, int]
"""What is known of a file or folder, and when it changed last, in ns."""


def _entries(path: str) -> Iterator[Line]:
    """A line for a file; for a folder one for each entry below it. Links to folders are not followed."""
    pending = [path]
    while pending:
        current = pending.pop()
        yield from _line(current)
        try:
            with os.scandir(current) as found:
                entries = sorted(found, key=lambda entry: entry.name)
        except OSError:  # its line says whether it is a file, or cannot be read
            continue
        for entry in entries:
            if not entry.is_dir(follow_symlinks=False):
                yield from () if entry.name.endswith(".pyc") else _line(entry.path)
            elif entry.name == ".git":
                yield from _line(os.path.join(entry.path, "info", "exclude"))
            elif entry.name not in _PRUNED:
                pending.append(entry.path)


def _line(path: str) -> Iterator[Line]:
    try:
        info = os.stat(path, follow_symlinks=admits(path))
    except OSError as error:
        facts: tuple[object, ...] = (path, error.errno)
        changed = 0
    else:
        facts = (path, info.st_mtime_ns, info.st_ctime_ns, info.st_size, info.st_ino, info.st_mode)
        changed = max(info.st_mtime_ns, info.st_ctime_ns)
    yield repr(facts).encode("utf-8", "surrogatepass"), changed


def _delete_old(folder: str) -> None:
    files = [entry.path for entry in os.scandir(folder) if entry.name.endswith(".json")]
    for path in sorted(files, key=os.path.getmtime)[:-MAX_STORED]:
        os.unlink(path)
