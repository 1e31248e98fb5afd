"""Splits what a run looks at into shares that know nothing of each other, so that several machines do the work of one.

Files that one may read from another stay together: what they name is looked at, and nothing is expanded. So what the
shares find is, put together, what one run would find.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache

from urdfctl.discover import Found, fits, text_of
from urdfctl.errors import UserError
from urdfctl.record import NamedTuple
from urdfctl.source.packages import package_name

_MOST = 1000
_WORD = rb"(?:\$\([^)\n]{0,200}\)|\$\{[^}\n]{0,200}\}|[^\s\"'<>=,;\[\]{}$]|\$)+"
_QUOTED = rb"(?<=['\"])[^'\"\n]{1,200}(?=['\"])"
_COMPUTED = rb"\$\{[^}\n]{0,500}\}"
_NAMES_A_FILE = re.compile(r"\.(?:xacro|urdf|xml|ya?ml|launch|inc|gazebo|trans|transmission|macro|control|srdf|sdf)\Z")
_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_IN_PACKAGE = r"(?:\$\(find[\w-]*\s+([^)$]+)\)|package://([^/$]+))"
_EXPRESSION = r"\$\{[^}]*\}|\$\([^)]*\)|\w+://"


class Shard(NamedTuple):
    """One of several shares, from 1."""

    number: int
    of: int


def shard(text: str) -> Shard:
    """What `2/5` means. UserError where it is no share."""
    number, _, of = text.partition("/")
    if number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of) <= _MOST:
        return Shard(int(number), int(of))
    raise UserError(f"--shard is written K/N, K from 1 to N and N up to {_MOST}, such as 2/5; not '{text}'")


def share(found: Found, wanted: Shard, ties: Iterable[Sequence[str]] = ()) -> set[str]:
    """The absolute paths of one share: the largest groups are dealt first, each to the share that has least. `ties` are
    files that belong together."""
    named = [*found.robots, *found.candidates, *found.controllers, *found.launches]
    groups = grouped(found.paths(), [*ties, *([named] if len(found.descriptions()) == 1 else [])])
    shares: list[list[str]] = [[] for _ in range(wanted.of)]
    for group in sorted(groups, key=lambda group: (-len(group), group)):
        min(shares, key=len).extend(group)
    return set(shares[wanted.number - 1])


def grouped(paths: Iterable[str], ties: Iterable[Sequence[str]] = ()) -> list[list[str]]:
    """The files, by absolute path, in groups of those that may read one another, or a file that is not among them;
    the files of a tie are in one group whatever they name."""
    files = sorted({os.path.abspath(path) for path in paths})
    together = _Together()
    naming = _Naming(files)
    waiting, seen = list(files), set(files)
    while waiting:
        file = waiting.pop()
        for other in naming.files_of(file):
            together.join(file, other)
            if other not in seen and os.path.isfile(other):
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
    """What the files that a run looks at may mean when they name a file."""

    def __init__(self, files: Sequence[str]) -> None:
        self._files = files
        self._by_name: dict[str, list[str]] = {}
        for file in files:
            self._by_name.setdefault(os.path.basename(file), []).append(file)
        self._packages: dict[str, set[str]] = {}
        for name, root in {_package_of(os.path.dirname(file)) for file in files}:
            self._packages.setdefault(name or "", set()).add(root)
        self._fitting: dict[tuple[str, str], Sequence[str]] = {}

    def files_of(self, file: str) -> Iterator[str]:
        """The files that a file may read: those that are there, else a word for one that is not."""
        text = re.sub(_COMMENT, b"", text_of(file))
        inside = (word for part in re.findall(_COMPUTED, text) for word in re.findall(_QUOTED, part))
        for word in {*re.findall(_WORD, text), *inside}:
            name = word.decode("utf-8", "replace")
            if _NAMES_A_FILE.search(name):
                yield from self._meant(name, os.path.dirname(file))

    def _meant(self, name: str, folder: str) -> Sequence[str]:
        found = re.match(_IN_PACKAGE, name)
        package, rest = ((found[1] or found[2]).strip(), name[found.end() :].lstrip("/")) if found else ("", name)
        if "$" not in rest:
            roots = self._packages.get(package, ()) if package else [folder]
            exact = [os.path.normpath(os.path.join(root, rest)) for root in roots]
            if there := [path for path in exact if os.path.isfile(path)]:
                return there
        end = re.sub(r"\A(?:\.\.?/)+", "", re.sub(_EXPRESSION, "*", rest))
        return self._ending(f"*/{end.removeprefix('*/')}" if found or not end.startswith("*") else f"*{end}", package)

    def _ending(self, end: str, package: str) -> Sequence[str]:
        if (end, package) not in self._fitting:
            name = os.path.basename(end)
            known = self._files if "*" in name else self._by_name.get(name, [])
            fitting = [path for path in known if fits(path, end, package)]
            # the launch files of other packages, such as gazebo_ros', are no part of a robot
            elsewhere = [] if name.endswith((".launch", ".xml")) else [f"{end} in {package}"]
            self._fitting[end, package] = fitting or elsewhere
        return self._fitting[end, package]


@lru_cache(4096)
def _package_of(folder: str) -> tuple[str | None, str]:
    """The package that a folder lies in, and its folder; None where it lies in none."""
    manifest = os.path.join(folder, "package.xml")
    if os.path.exists(manifest):
        return package_name(manifest), folder
    above = os.path.dirname(folder)
    return (None, folder) if above == folder else _package_of(above)


class _Together:
    """Which of some names belong together."""

    def __init__(self) -> None:
        self._above: dict[str, str] = {}

    def of(self, name: str) -> str:
        """The name that stands for all those that a name belongs to."""
        above = self._above.get(name, name)
        while above != name:
            next_above = self._above.get(above, above)
            self._above[name] = next_above
            name, above = above, next_above
        return name

    def join(self, one: str, other: str) -> None:
        self._above[self.of(one)] = self.of(other)
