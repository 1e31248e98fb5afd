"""Split the files of a run into independent shares, so that several machines can check them.

Files that may read each other stay in one share, so that all shares together find what a single run finds. The names in
their texts decide; nothing is expanded.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.discover.robots import DiscoveredFiles, is_match
from urdfctl.discover.walk import text_of
from urdfctl.errors import UserError
from urdfctl.source.disk.files import folders_upwards
from urdfctl.source.disk.gate import is_file
from urdfctl.source.disk.shown import remembered
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.startup.records import NamedTuple

_MOST = 1000
_WORD = rb"(?:\$\([^)\n]{0,200}\)|\$\{[^}\n]{0,200}\}|[^\s\"'<>=,;\[\]{}$]|\$)+"
_QUOTED = rb"(?<=['\"])[^'\"\n]{1,200}(?=['\"])"
_COMPUTED = rb"\$\{[^}\n]{0,500}\}"
_NAMES_A_FILE = re.compile(r"\.(?:xacro|urdf|xml|ya?ml|launch|inc|gazebo|trans|transmission|macro|control|srdf|sdf)\Z")
_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_IN_PACKAGE = r"(?:\$\(find[\w-]*\s+([^)$]+)\)|package://([^/$]+))"
_EXPRESSION = r"\$\{[^}]*\}|\$\([^)]*\)|\w+://"


class Shard(NamedTuple):
    """One of several shares.

    number: from 1.
    of: how many shares there are.
    """

    number: int
    of: int


def shard(text: str) -> Shard:
    """Return the share that a text such as `2/5` means. UserError if it is malformed."""
    number, _, of = text.partition("/")
    if number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of) <= _MOST:
        return Shard(int(number), int(of))
    raise UserError(f"--shard must be K/N with K from 1 to N and N up to {_MOST}, e.g. 2/5; not '{text}'")


def share(discovered: DiscoveredFiles, wanted: Shard, ties: Iterable[Sequence[str]] = ()) -> set[str]:
    """Return the absolute paths of one share. The largest groups are assigned first, each to the smallest share.

    ties: groups of files that belong together.
    """
    named = [*discovered.robots, *discovered.candidates, *discovered.controllers, *discovered.launches]
    groups = grouped(discovered.paths(), [*ties, *([named] if len(discovered.descriptions()) == 1 else [])])
    shares: list[list[str]] = [[] for _ in range(wanted.of)]
    for group in sorted(groups, key=lambda group: (-len(group), group)):
        min(shares, key=len).extend(group)
    return set(shares[wanted.number - 1])


def grouped(paths: Iterable[str], ties: Iterable[Sequence[str]] = ()) -> list[list[str]]:
    """Return absolute paths in groups of files that may read each other or the same other file.

    ties: groups of files that belong together whatever they name.
    """
    files = sorted({os.path.abspath(path) for path in paths})
    together = _Groups()
    naming = _Naming(files)
    waiting, seen = list(files), set(files)
    while waiting:
        file = waiting.pop()
        for other in naming.files_of(file):
            together.join(file, other)
            if other not in seen and is_file(other):
                seen.add(other)
                waiting.append(other)
    for tie in ties:
        for path in tie:
            together.join(os.path.abspath(tie[0]), os.path.abspath(path))
    groups: dict[str, list[str]] = {}
    for file in files:
        groups.setdefault(together.of(file), []).append(file)
    return list(groups.values())


class _Naming:
    """Which files the names in a run's files may mean."""

    def __init__(self, files: Sequence[str]) -> None:
        self._files = files
        self._by_name: dict[str, list[str]] = {}
        for file in files:
            self._by_name.setdefault(os.path.basename(file), []).append(file)
        self._packages: dict[str, set[str]] = {}
        for name, root in {_package_of(os.path.dirname(file)) for file in files}:
            self._packages.setdefault(name or "", set()).add(root)
        self._matching: dict[tuple[str, str], Sequence[str]] = {}

    def files_of(self, file: str) -> Iterator[str]:
        """Yield the files that a file may read; for a missing one, a text that stands for it."""
        text = re.sub(_COMMENT, b"", text_of(file))
        inside = (word for part in re.findall(_COMPUTED, text) for word in re.findall(_QUOTED, part))
        for word in {*re.findall(_WORD, text), *inside}:
            name = word.decode("utf-8", "replace")
            if _NAMES_A_FILE.search(name):
                yield from self._meant(name, os.path.dirname(file))

    def _meant(self, name: str, folder: str) -> Sequence[str]:
        match = re.match(_IN_PACKAGE, name)
        package, rest = ((match[1] or match[2]).strip(), name[match.end() :].lstrip("/")) if match else ("", name)
        if "$" not in rest:
            roots = self._packages.get(package, ()) if package else [folder]
            exact = [os.path.normpath(os.path.join(root, rest)) for root in roots]
            if existing := [path for path in exact if is_file(path)]:
                return existing
        end = re.sub(r"\A(?:\.\.?/)+", "", re.sub(_EXPRESSION, "*", rest))
        return self._ending(f"*/{end.removeprefix('*/')}" if match or not end.startswith("*") else f"*{end}", package)

    def _ending(self, end: str, package: str) -> Sequence[str]:
        if (end, package) not in self._matching:
            name = os.path.basename(end)
            known = self._files if "*" in name else self._by_name.get(name, [])
            matching = [path for path in known if is_match(path, end, package)]
            # launch files of other packages, such as gazebo_ros, do not belong to a robot
            elsewhere = [] if name.endswith((".launch", ".xml")) else [f"{end} in {package}"]
            self._matching[end, package] = matching or elsewhere
        return self._matching[end, package]


@remembered
def _package_of(folder: str) -> tuple[str | None, str]:
    """Return the name and folder of the package around a folder; None and the root folder if there is none."""
    package = package_around(folder)
    if package is None:
        *_, root = folders_upwards(folder)
        return None, root
    return package_name(os.path.join(package, "package.xml")), package


class _Groups:
    """Groups of names that belong together (union-find)."""

    def __init__(self) -> None:
        self._above: dict[str, str] = {}

    def of(self, name: str) -> str:
        """Return the name that identifies the group of a name."""
        above = self._above.get(name, name)
        while above != name:
            next_above = self._above.get(above, above)
            self._above[name] = next_above
            name, above = above, next_above
        return name

    def join(self, name: str, other: str) -> None:
        """Merge the groups of two names."""
        self._above[self.of(name)] = self.of(other)
