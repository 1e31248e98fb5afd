"""Finds the robots that the paths of a command line mean."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import lru_cache

from urdfctl.errors import UserError
from urdfctl.gitignore import GitIgnore
from urdfctl.launches import is_controllers_file, is_launch_file, launch_roots
from urdfctl.source.files import first_bytes, is_launch, is_yaml
from urdfctl.source.packages import package_name
from urdfctl.suggest import nearest_path

_DESCRIPTIONS = (".urdf", ".xacro")
_LAUNCHES = (".launch", ".launch.xml", "_launch.xml", ".launch.py", "_launch.py", ".launch.yaml", ".launch.yml")
_LOOKED_AT = (*_DESCRIPTIONS, *_LAUNCHES, ".yaml", ".yml")
_PRUNED = frozenset({"build", "install", "log", "devel", "node_modules", "__pycache__"})
_IGNORE_FILES = frozenset({"COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE"})
_INCLUDE = rb"(?s)<(?:xacro:)?include\s[^<>]*?filename\s*=\s*[\"']([^\"']+)[\"']"
_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_ROBOT = rb"<robot[\s>/]"
_MAX_BYTES = 16 << 20


class Found:
    """What the paths of a command mean: robots, controllers' files and launch files named one by one; and in folders
    what may be a robot, launch files that may tell what belongs together, and what looks like a controllers' file."""

    def __init__(self) -> None:
        self.robots: list[str] = []
        self.candidates: list[str] = []
        self.others: list[str] = []
        self.controllers: list[str] = []
        self.launches: list[str] = []
        self.launch_candidates: list[str] = []
        self.controllers_candidates: list[str] = []

    def unread(self, files: Collection[str]) -> list[str]:
        """The descriptions in the folders that are not among some files: libraries and fragments that nothing used."""
        known = set(files)
        return [path for path in map(os.path.abspath, self.others) if path not in known]

    def paths(self) -> list[str]:
        """All files that may be looked at."""
        named = [*self.robots, *self.controllers, *self.launches]
        return [*named, *self.candidates, *self.others, *self.launch_candidates, *self.controllers_candidates]

    def among(self, paths: Collection[str]) -> Found:
        """The part of it that is among some absolute paths."""
        part = Found()
        for kind, found in vars(self).items():
            setattr(part, kind, [path for path in found if os.path.abspath(path) in paths])
        return part

    def descriptions(self) -> list[tuple[str, bool]]:
        """Each description once, and whether it was named by the user."""
        named = {os.path.abspath(path): True for path in self.robots}
        found = {os.path.abspath(path): False for path in self.candidates}
        return list({**found, **named}.items())


def find(paths: Sequence[str], excluded: Callable[[str], bool] = lambda _: False) -> Found:
    """What the paths mean; with none, what the package (else the folder) holds that encloses the current folder.

    Files in folders may be excluded, those that are named are not.
    """
    found = Found()
    for path in paths or (_enclosing_package(),):
        if not os.path.lexists(path):
            raise UserError(f"no such file or folder: '{path}'{nearest_path(path)}")
        if os.path.isdir(path):
            check_readable(path)
            _search(path, found, excluded)
        elif is_launch(path):
            found.launches.append(path)
        elif is_yaml(path):
            found.controllers.append(path)
        else:
            found.robots.append(path)
    return found


def check_readable(folder: str) -> None:
    """UserError where a folder that is to be looked through cannot be; those below it are passed over silently."""
    if not os.access(folder, os.R_OK | os.X_OK):
        raise UserError(f"'{folder}' cannot be read: {os.strerror(errno.EACCES)}")


def _enclosing_package() -> str:
    folder = os.getcwd()
    while not os.path.exists(os.path.join(folder, "package.xml")):
        above = os.path.dirname(folder)
        if above == folder:
            return os.curdir
        folder = above
    return os.path.relpath(folder)


def _search(folder: str, found: Found, excluded: Callable[[str], bool]) -> None:
    """What may be worth linting below a folder. What is excluded still tells what others are included by."""
    files = sorted(_files(folder))
    robots = {path: text for path in files if path.endswith(_DESCRIPTIONS) and re.search(_ROBOT, text := text_of(path))}
    found.others += (path for path in robots if not excluded(path))
    found.candidates += (path for path in roots(robots) if not excluded(path))
    launches = {path: text for path in files if _may_launch(path) and is_launch_file(path, text := text_of(path))}
    found.launch_candidates += (path for path in launch_roots(launches) if not excluded(path))
    yamls = (path for path in files if is_yaml(path) and not excluded(path))
    found.controllers_candidates += (path for path in yamls if is_controllers_file(text_of(path)))


def roots(texts: Mapping[str, bytes]) -> list[str]:
    """The descriptions that no other one includes, in order. Whether one is a robot shows when it is read."""
    included = {(tail, package) for path, text in texts.items() for tail, package in _included(path, text)}
    return [path for path in texts if not any(fits(path, tail, package) for tail, package in included)]


def _files(folder: str) -> Iterator[str]:
    """The files below a folder that may be looked at, but for those that git, colcon or catkin ignore."""
    git = GitIgnore(folder)
    for current, folders, files in os.walk(folder):
        if _IGNORE_FILES & set(files):
            folders.clear()
            continue
        folders[:] = sorted(
            name
            for name in folders
            if not (name.startswith(".") or name in _PRUNED or git.ignores(os.path.join(current, name), is_folder=True))
        )
        for name in files:
            if name.endswith(_LOOKED_AT) or (name.endswith(".py") and os.path.basename(current) == "launch"):
                path = os.path.join(current, name)
                if not git.ignores(path, is_folder=False):
                    yield path


def _may_launch(path: str) -> bool:
    """Whether a file may be a launch file: by its name, or as Python in a folder of that name."""
    return path.endswith((*_LAUNCHES, ".py"))


def text_of(path: str) -> bytes:
    """The text of a file, as far as it tells what the file is."""
    try:
        if os.path.getsize(path) > _MAX_BYTES:
            return b"<robot "  # reading it tells what is wrong with it
        return first_bytes(path, _MAX_BYTES)
    except OSError:
        return b"<robot "


def _included(path: str, text: bytes) -> Iterator[tuple[str, str]]:
    """The files that a description includes, but for itself: a path where it is relative, else the end of one and the
    package it is in, where that is named."""
    for match in re.finditer(_INCLUDE, re.sub(_COMMENT, b"", text)):
        name = match.group(1).decode("utf-8", "replace")
        if "$" in name or os.path.isabs(name):
            found = re.match(r"\$\(find ([^)$]+)\)", name)
            yield "*" + re.sub(r"\$\{[^}]*\}|\$\([^)]*\)", "*", name), found.group(1).strip() if found else ""
        elif (relative := os.path.normpath(os.path.join(os.path.dirname(path), name))) != os.path.normpath(path):
            yield relative, ""


def fits(path: str, included: str, package: str) -> bool:
    """Whether a path is the one that an include means, or ends as it does in the package that it names."""
    if not included.startswith("*"):
        return os.path.normpath(path) == included
    if not included.strip("*/") or not fnmatchcase(os.path.abspath(path).replace(os.sep, "/"), included):
        return False
    return not package or _package_of(os.path.dirname(os.path.abspath(path))) in (package, None)


@lru_cache(4096)
def _package_of(folder: str) -> str | None:
    """The name of the package that a folder lies in; None where it lies in none."""
    manifest = os.path.join(folder, "package.xml")
    if os.path.exists(manifest):
        return package_name(manifest)
    above = os.path.dirname(folder)
    return None if above == folder else _package_of(above)
