"""Find the robots that the paths of a command line mean."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from copy import copy
from fnmatch import fnmatchcase

from urdfctl.discover.documented import Documentation, is_document
from urdfctl.discover.generated import written_by_xacro
from urdfctl.discover.launch_files import (
    is_broken,
    is_controllers_file,
    is_launch_file,
    launch_roots,
    may_launch,
    only_mentioned,
)
from urdfctl.discover.walk import DESCRIPTIONS, files_below, text_of
from urdfctl.errors import UserError
from urdfctl.names import nearest_path
from urdfctl.source.disk.files import is_launch, is_yaml
from urdfctl.source.disk.shown import remembered
from urdfctl.source.workspaces.packages import package_around, package_name

_INCLUDE = rb"(?s)<(?:xacro:)?include\s[^<>]*?filename\s*=\s*[\"']([^\"']+)[\"']"
_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_ROBOT = rb"<robot[\s>/]"
_ROOT = rb"(?s)<robot(?:\s[^<>]*)?>"
_NAMED = rb"\sname\s*="
_LINK = rb"(?s)<link\s[^<>]*?name\s*=\s*[\"']([^\"']*)[\"']"
_COMMON = (".urdf", ".xacro", ".yaml")
"""Files that exist and end so need no closer look."""
_PARENT = rb"(?s)<parent\s[^<>]*?link\s*=\s*[\"']([^\"']*)[\"']"


class DiscoveredFiles:
    """The files that the paths of a command name or contain.

    robots, controllers, launches: files that are named.
    candidates: descriptions in folders that no other one includes, and so may be robots.
    others: all descriptions in folders, except those that xacro wrote from another one.
    generated: the descriptions that xacro wrote from another one.
    launch_candidates: launch files in folders that may say which files belong together.
    mentioned: launch files in folders that others seem to include.
    controllers_candidates: files in folders that look like controller files.
    documents: texts in folders that may say how launch files are started.
    """

    def __init__(self) -> None:
        self.robots: list[str] = []
        self.candidates: list[str] = []
        self.others: list[str] = []
        self.generated: list[str] = []
        self.controllers: list[str] = []
        self.launches: list[str] = []
        self.launch_candidates: list[str] = []
        self.mentioned: list[str] = []
        self.controllers_candidates: list[str] = []
        self.documents: list[str] = []
        self.around: list[str] = []
        self.focus: list[str] = []
        self.despite: list[str] = []

    @property
    def documentation(self) -> Documentation:
        """Return what the documents say about starting launch files."""
        return Documentation(self.documents)

    def unread(self, files: Collection[str]) -> list[str]:
        """Return the descriptions in folders that are not among some files: unused libraries and fragments."""
        known = set(files)
        return [path for path in map(os.path.abspath, self.others) if path not in known]

    def paths(self) -> list[str]:
        """Return all files that may be read."""
        named = [*self.robots, *self.controllers, *self.launches]
        found = [*self.candidates, *self.others, *self.launch_candidates, *self.controllers_candidates]
        return [*named, *found, *self.around]

    def among(self, paths: Collection[str]) -> DiscoveredFiles:
        """Return only the files that are among some absolute paths."""
        part = DiscoveredFiles()
        for kind, files in vars(self).items():
            setattr(part, kind, [path for path in files if os.path.abspath(path) in paths])
        return part

    def with_generated(self) -> DiscoveredFiles:
        """Return the same files, with descriptions that xacro wrote among those that may be robots."""
        every = copy(self)
        every.candidates = [*self.candidates, *self.generated]
        every.others = [*self.others, *self.generated]
        every.generated = []
        return every

    def descriptions(self) -> list[tuple[str, bool]]:
        """Return each description once, with whether the user named it."""
        named = {os.path.abspath(path): True for path in self.robots}
        in_folders = {os.path.abspath(path): False for path in self.candidates}
        return list({**in_folders, **named}.items())


def discover_files(paths: Sequence[str], excluded: Callable[[str], bool] = lambda _: False) -> DiscoveredFiles:
    """Return the files that paths name or contain.

    Without paths: those of the package around the current folder, or of the current folder if there is no package.

    excluded: returns whether a file in a folder is skipped. Named files are never skipped.
    """
    files = DiscoveredFiles()
    for path in paths or (_enclosing_package(),):
        _check(path)
        if not os.path.lexists(path):
            raise UserError(f"file or folder '{path}' does not exist{nearest_path(path)}")
        if os.path.isdir(path):
            check_readable(path)
            _search(path, files, excluded)
        elif is_launch(path):
            files.launches.append(path)
        elif is_yaml(path):
            files.controllers.append(path)
        else:
            files.robots.append(path)
    return files


def _check(path: str) -> None:
    """Raise UserError, which says what is wrong, if a path cannot name a file of a robot."""
    if not (os.path.isdir(path) or (path.endswith(_COMMON) and os.path.exists(path))):
        from urdfctl.discover.paths import check_path

        check_path(path)


def check_readable(folder: str) -> None:
    """Raise UserError if a folder cannot be searched. Unreadable folders below it are skipped without a message."""
    if not os.access(folder, os.R_OK | os.X_OK):
        raise UserError(f"'{folder}' cannot be read: {os.strerror(errno.EACCES)}")


def _enclosing_package() -> str:
    folder = package_around(os.getcwd())
    return os.path.relpath(folder) if folder else os.curdir


def _search(folder: str, found: DiscoveredFiles, excluded: Callable[[str], bool]) -> None:
    """What may be worth linting below a folder. What is excluded still tells what others are included by."""
    if not _classify(sorted(files_below(folder)), found, excluded):
        despite: list[str] = []
        _classify(sorted(files_below(folder, ignored=despite)), found, excluded)
        found.despite += despite


def _classify(files: Sequence[str], found: DiscoveredFiles, excluded: Callable[[str], bool]) -> bool:
    """Add the files of a folder by what they are; return whether there are any."""
    before = len(found.paths())
    robots = {path: text for path in files if path.endswith(DESCRIPTIONS) and re.search(_ROBOT, text := text_of(path))}
    found.generated += written_by_xacro({path: text for path, text in robots.items() if not excluded(path)})
    generated = set(found.generated)
    found.others += (path for path in robots if not excluded(path) and path not in generated)
    launches = {path: text for path in files if may_launch(path) and is_launch_file(path, text := text_of(path))}
    started = set(launch_roots(launches))
    followed = (path for path, text in launches.items() if path in started or is_broken(path, text))
    found.launch_candidates += (path for path in followed if not excluded(path))
    found.mentioned += (path for path in only_mentioned(launches, started) if not excluded(path))
    found.documents += (path for path in files if is_document(path) and not excluded(path))
    left_out = _left_out(robots.values())
    whole = (path for path in roots(robots) if not is_fragment(path, robots[path], launches.values(), left_out))
    found.candidates += (path for path in whole if not excluded(path) and path not in generated)
    yamls = (path for path in files if is_yaml(path) and not excluded(path))
    found.controllers_candidates += (path for path in yamls if is_controllers_file(text_of(path)))
    return len(found.paths()) > before


def roots(texts: Mapping[str, bytes]) -> list[str]:
    """Return the descriptions that no other one includes, in order. Loading shows whether they are robots."""
    included = {(tail, package) for path, text in texts.items() for tail, package in _included(path, text)}
    named = {package for _, package in included if package}
    here = named & {_package_of(os.path.dirname(os.path.abspath(path))) for path in texts} if named else named

    def is_included(path: str, tail: str, package: str) -> bool:
        """A file outside of packages is not meant if the package is here."""
        folder = os.path.dirname(os.path.abspath(path))
        return is_match(path, tail, package) and not (package in here and _package_of(folder) is None)

    return [path for path in texts if not any(is_included(path, tail, package) for tail, package in included)]


def included_from(paths: Iterable[str], others: Iterable[str]) -> set[str]:
    """Return which of the other descriptions some descriptions include, themselves or by way of others.

    Conditions do not count: also what is included only with other arguments is among them. All paths are absolute.
    """
    left, found, open_paths = set(others), set[str](), [path for path in paths if path.endswith(DESCRIPTIONS)]
    while open_paths and left:
        path = open_paths.pop()
        for included, package in _included(path, text_of(path)):
            reached = {other for other in left if is_match(other, included, package)}
            left -= reached
            found |= reached
            open_paths += reached
    return found


def is_fragment(path: str, text: bytes, launches: Iterable[bytes], left_out: Collection[bytes] = ()) -> bool:
    """Return whether a description is meant to be included, though nothing here includes it.

    Its <robot> has no name, and no launch file mentions it. Either its include is commented out; or it includes nothing
    and a joint hangs on a link that is not in the file, an accessory whose include is named by the environment.

    left_out: the names of files whose include is commented out.
    """
    text = re.sub(_COMMENT, b"", text)
    root = re.search(_ROOT, text)
    if root is None or re.search(_NAMED, root[0]):
        return False
    links = set(re.findall(_LINK, text))
    hanging = any(b"$" not in parent and parent not in links for parent in re.findall(_PARENT, text))
    name = os.path.basename(path).encode()
    is_accessory = hanging and not re.search(_INCLUDE, text)
    return (is_accessory or name in left_out) and not any(name in launch for launch in launches)


def _left_out(texts: Iterable[bytes]) -> set[bytes]:
    """The names of the files that descriptions include only in comments."""
    comments = (comment for text in texts for comment in re.findall(_COMMENT, text))
    return {name.rpartition(b"/")[2] for comment in comments for name in re.findall(_INCLUDE, comment)}


def _included(path: str, text: bytes) -> Iterator[tuple[str, str]]:
    """Yield the files that a description includes, except itself, for `is_match`.

    A relative include gives a path. Any other gives a pattern for the end of the path, and the package if it is named.
    """
    for match in re.finditer(_INCLUDE, re.sub(_COMMENT, b"", text)):
        name = match.group(1).decode("utf-8", "replace")
        if "$" in name or os.path.isabs(name):
            package = re.match(r"\$\(find ([^)$]+)\)", name)
            yield "*" + re.sub(r"\$\{[^}]*\}|\$\([^)]*\)", "*", name), package.group(1).strip() if package else ""
        elif (relative := os.path.normpath(os.path.join(os.path.dirname(path), name))) != os.path.normpath(path):
            yield relative, ""


def is_match(path: str, included: str, package: str) -> bool:
    """Return whether an include means a path: it is that path, or a pattern for its end in the named package."""
    if not included.startswith("*"):
        return os.path.normpath(path) == included
    if not included.strip("*/") or not fnmatchcase(os.path.abspath(path).replace(os.sep, "/"), included):
        return False
    return not package or _package_of(os.path.dirname(os.path.abspath(path))) in (package, None)


@remembered
def _package_of(folder: str) -> str | None:
    """Return the name of the package around a folder; None if there is none."""
    package = package_around(folder)
    return package_name(os.path.join(package, "package.xml")) if package else None
