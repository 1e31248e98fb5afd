"""What the files of a repository say about its distro that no robot needs: containers, CI, what is built beside it.

The folders from a package up to its workspace are looked at; the nearest one with a file that names a distro counts.
Where a workspace is built, what it was built on counts before all that its repositories support. What a README tells
its readers to type counts only where there is nothing else, and its prose and launch files beside the robot least.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import ALL, since
from urdfctl.model.project import EvidenceItem
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import names_in
from urdfctl.source.disk.shown import remembered
from urdfctl.startup.records import NamedTuple

PROSE = "prose"
"""The kind of what a README only mentions."""
_WEIGHT_OF_BUILD, _WEIGHT, _WEIGHT_OF_README, _WEIGHT_OF_PROSE = 8, 5, 2, 1
_MOST_BYTES = 1 << 16
_MOST_FILES = 24
_MOST_LEVELS = 8
_COMPOSE = (*(("docker-compose", end) for end in (".yml", ".yaml")), ("compose", ".yml"), ("compose", ".yaml"))
_FILES = {
    "": (
        *(("Dockerfile", ""), ("", ".Dockerfile"), ("", ".dockerfile"), ("Containerfile", ""), *_COMPOSE),
        *(("", ".repos"), ("", ".rosinstall"), (".gitlab-ci.yml", ""), (".travis.yml", ""), (".env", "")),
    ),
    ".github/workflows": (("", ".yml"), ("", ".yaml")),
    ".devcontainer": (("", ""),),
    ".docker": (("", ""),),
    "docker": (("Dockerfile", ""), ("", ".Dockerfile"), ("", ".dockerfile"), *_COMPOSE, (".env", "")),
}
"""How the names of the files that name a distro begin and end, by their folder."""
_SETUP = (("setup.sh", ""),)
"""What colcon writes into `install` at every build. It sources the prefixes that the workspace was built on."""
_README = (("README", ""), ("readme.", ""), ("Readme.", ""), ("INSTALL.md", ""))
_NAMES = "|".join(sorted(ALL))
_LIST = rf"[\"'\[\s,-]*((?:(?:{_NAMES})\b[\"'\s,-]*(?:\n[\s-]*)?)+)"
_VARIABLE = rf"(?i)\b(?:ros_?)?distro(?:s|[\w-]*distributions?)?[\"']?\s*[:=]{_LIST}"
_NAMING = (
    _VARIABLE,
    rf"(?i)\brequired-ros-distributions\s*:{_LIST}",
    rf"\bros(?:-[a-z]+)*:({_NAMES})\b",
    rf"/opt/ros/({_NAMES})\b",
    rf"\bros-({_NAMES})-[a-z*$]",
    rf"(?m)^\s*version\s*:\s*[\"']?({_NAMES})(?:-devel)?[\"']?\s*$",
    rf"\b(?:ROS_DISTRO|rosdistro)\s+({_NAMES})\b",
)
_UNDERLAY = rf"(?m)^COLCON_CURRENT_PREFIX=[\"']?/opt/ros/({_NAMES})\b"
_MENTIONED = rf"(?i)\bROS[\s_-]*[12]?[\s,:(*_-]*({_NAMES})\b"


class _NamedDistro(NamedTuple):
    """A distro that a file names, and where."""

    distro: str
    place: str


def items_of_repository(folder: str, workspace: str) -> Iterator[EvidenceItem]:
    """Yield what the files around a package say about its distro: one item at most.

    folder: of the package, or of the robot. workspace: the outermost folder that is looked at.
    """
    levels = list(_levels(folder, workspace))
    for files, kind, weight in (
        (_built, "workspace", _WEIGHT_OF_BUILD),
        (_configuring, "repository", _WEIGHT),
        (_advising, "repository", _WEIGHT_OF_README),
        (_mentioning, PROSE, _WEIGHT_OF_PROSE),
        (_launching, "repository", _WEIGHT_OF_PROSE),
    ):
        named = next(filter(None, (files(level) for level in levels)), ())
        if named:
            found = {one.distro for one in named}
            distros = tuple(distro for distro in ALL if distro in found)
            place = next(one.place for one in named if one.distro in distros)
            path = os.path.relpath(place.rpartition(":")[0], workspace).replace(os.sep, "/")
            yield EvidenceItem(kind, f"{path}:{place.rpartition(':')[2]}", distros, weight, place.rpartition(":")[0])
            return


def _levels(folder: str, workspace: str) -> Iterator[str]:
    for _ in range(_MOST_LEVELS):
        yield folder
        if folder == workspace or not folder.startswith(workspace.rstrip(os.sep) + os.sep):
            return
        folder = os.path.dirname(folder)


@remembered
def _built(folder: str) -> tuple[_NamedDistro, ...]:
    """What a workspace was built on."""
    setups = _matching(os.path.join(folder, "install"), _SETUP)
    return tuple(one for path in setups for one in _named(path, (_UNDERLAY,)))


@remembered
def _configuring(folder: str) -> tuple[_NamedDistro, ...]:
    """What is named by the files that build or test a repository."""
    found: list[_NamedDistro] = []
    for inner, ends in _FILES.items():
        for path in _matching(os.path.join(folder, inner) if inner else folder, ends):
            found += _named(path, _NAMING)
    return tuple(found)


@remembered
def _advising(folder: str) -> tuple[_NamedDistro, ...]:
    """What the commands in a README name."""
    return tuple(one for path in _matching(folder, _README) for one in _named(path, _NAMING))


@remembered
def _mentioning(folder: str) -> tuple[_NamedDistro, ...]:
    """What the prose of a README names."""
    return tuple(one for path in _matching(folder, _README) for one in _named(path, (_MENTIONED,)))


@remembered
def _launching(folder: str) -> tuple[_NamedDistro, ...]:
    """What launch files in XML are for: roslaunch, if nothing in them is of ROS 2."""
    for path in _matching(os.path.join(folder, "launch"), (("", ".launch"),)):
        try:
            text = first_bytes(path, _MOST_BYTES)
        except OSError:
            continue
        node = re.search(rb"<node\b[^>]*\stype\s*=", text)
        if node and not re.search(rb"find-pkg-share|\bexec\s*=", text):
            line = text.count(b"\n", 0, node.start()) + 1
            return tuple(_NamedDistro(name, f"{path}:{line}") for name in since("indigo"))
    return ()


def _matching(folder: str, ends: Iterable[tuple[str, str]]) -> Iterator[str]:
    try:
        names = names_in(folder)
    except OSError:
        return
    matching = [name for name in names if any(name.startswith(start) and name.endswith(end) for start, end in ends)]
    yield from (os.path.join(folder, name) for name in matching[:_MOST_FILES])


def _named(path: str, patterns: Iterable[str]) -> Iterator[_NamedDistro]:
    try:
        text = first_bytes(path, _MOST_BYTES).decode("utf-8", "replace")
    except OSError:
        return
    for pattern in patterns:
        for match in re.finditer(pattern, text):
            line = text.count("\n", 0, match.start()) + 1
            yield from (_NamedDistro(name, f"{path}:{line}") for name in re.findall(_NAMES, match[1].lower()))
