"""Find ROS packages without ROS, for `$(find pkg)` and `package://pkg`.

The search order is `--package-path`, the prefixes of a sourced environment, and the ancestors of the file with the
folders directly in them. Only if all of these fail, the whole workspace is searched, once per run. Of several packages
with the same name, the nearest one is used.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Collection, Hashable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from urdfctl.source.disk import gate
from urdfctl.source.disk.files import first_bytes, folders_upwards
from urdfctl.source.disk.gitignore import GitIgnore
from urdfctl.source.workspaces.families import may_be_meant
from urdfctl.source.workspaces.package_folders import is_searched, package_folders

if TYPE_CHECKING:
    from urdfctl.source.workspaces.install_maps import InstallMap

_T = TypeVar("_T")
_NAME = rb"<name[^<>]*>\s*([^<\s]+)\s*</name>"
_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_DEPENDENCY = rb"<(?:[a-z_]+_)?depend\b[^<>]*>\s*([^<\s]+)\s*</"
PREFIXES = ("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "CMAKE_PREFIX_PATH")
"""The environment variables that list where packages are installed."""
_ROOTS = "ROS_PACKAGE_PATH"
ELSEWHERE = (*PREFIXES, _ROOTS)
"""The environment variables that list folders with packages."""
_AMENT_INDEX = "share/ament_index/resource_index/packages"


class PackageNotFound(Exception):
    """No package has this name.

    known: the names of the packages found so far, for "did you mean" hints.
    own: the name of the package that contains the file; empty if there is none.
    """

    def __init__(self, name: str, known: Sequence[str], own: str = "") -> None:
        super().__init__(f"package '{name}' was not found")
        self.name = name
        self.known = known
        self.own = own


def package_around(folder: str) -> str | None:
    """Return the nearest folder with a package.xml: the folder itself or one above it; None if there is none."""
    return next((each for each in folders_upwards(folder) if gate.exists(os.path.join(each, "package.xml"))), None)


def package_name(manifest: str) -> str | None:
    """Return the `<name>` in a package.xml; None if it has none or cannot be read."""
    try:
        data = first_bytes(manifest, 65536)
    except OSError:
        return None
    match = re.search(_NAME, data)
    if match and b"<!--" in data[: match.start()]:
        match = re.search(_NAME, re.sub(_COMMENT, b"", data))
    return match.group(1).decode("utf-8", "replace") if match else None


def dependencies_of(manifest: str) -> frozenset[str]:
    """Return the names in all `<*depend>` of a package.xml; empty if it cannot be read."""
    try:
        data = first_bytes(manifest, 65536)
    except OSError:
        return frozenset()
    return frozenset(name.decode("utf-8", "replace") for name in re.findall(_DEPENDENCY, re.sub(_COMMENT, b"", data)))


class Crawl:
    """The packages below one folder, found by one walk on first use. Symbolic links to folders are not followed."""

    def __init__(self, root: str) -> None:
        self.root = root
        self._found: dict[str, list[str]] | None = None

    def packages(self) -> dict[str, list[str]]:
        """Return the folders of each package, by package name."""
        if self._found is None:
            self._found = {}
            for folder in package_folders(self.root):
                name = package_name(os.path.join(folder, "package.xml"))
                if name:
                    self._found.setdefault(name, []).append(folder)
        return self._found


class PackageIndex:
    """State shared by all robots of a run: the package walks, manifests and install maps that were read."""

    def __init__(self, workspace: str, extra: Sequence[str] = (), environ: Mapping[str, str] | None = None) -> None:
        self.workspace = os.path.abspath(workspace)
        self.extra = [os.path.abspath(path) for path in extra]
        self.environ = os.environ if environ is None else environ
        self.named = list(map(Crawl, self.extra))
        self.around = list(map(Crawl, [self.workspace, *self.prefixes(_ROOTS)]))
        self.crawls = [*self.named, *self.around]
        self._names: dict[str, str | None] = {}
        self._maps: dict[str, InstallMap] = {}
        self._dependencies: dict[str, frozenset[str]] = {}
        self._files: dict[str, frozenset[str]] = {}
        self._git: GitIgnore | None = None
        self._once: dict[Hashable, Any] = {}

    def once(self, key: Hashable, compute: Callable[[], _T]) -> _T:
        """Return what a function returned when it was first given with a key: one result for all robots of a run."""
        if key not in self._once:
            self._once[key] = compute()
        result: _T = self._once[key]
        return result

    def anew(self) -> PackageIndex:
        """Return an index of the same packages, which reads their files anew."""
        other = PackageIndex(self.workspace, self.extra, self.environ)
        other.named, other.around, other.crawls = self.named, self.around, self.crawls
        return other

    def dependencies(self, folder: str) -> frozenset[str]:
        """Return the names of the packages that the package.xml in a folder declares."""
        if folder not in self._dependencies:
            self._dependencies[folder] = dependencies_of(os.path.join(folder, "package.xml"))
        return self._dependencies[folder]

    def declared(self) -> Collection[str]:
        """Return the names of the packages that any package.xml declares."""
        folders = {folder for crawl in self.crawls for each in crawl.packages().values() for folder in each}
        return self.once("declared", lambda: frozenset().union(*map(self.dependencies, folders)))

    def name_of(self, folder: str) -> str | None:
        """Return the name of the package in a folder; None if the folder has no package.xml."""
        if folder not in self._names:
            manifest = os.path.join(folder, "package.xml")
            self._names[folder] = package_name(manifest) if gate.exists(manifest) else None
        return self._names[folder]

    def install_map(self, folder: str, name: str) -> InstallMap:
        """Return the install rules of a source package."""
        from urdfctl.source.workspaces.install_maps import read_install_map

        if folder not in self._maps:
            self._maps[folder] = read_install_map(folder, name)
        return self._maps[folder]

    def file_names(self, folder: str) -> frozenset[str]:
        """Return the names of all files in a folder and below it."""
        if folder not in self._files:
            self._files[folder] = frozenset(name for _, _, files in gate.walk(folder) for name in files)
        return self._files[folder]

    def is_ignored_by_git(self, path: str) -> bool:
        """Return whether a .gitignore of the workspace names a file, or a folder around it: it is made later."""
        self._git = self._git or GitIgnore(self.workspace, top=self.workspace)
        return self._git.expects(path)

    def elsewhere(self) -> Iterator[str]:
        """Yield the folders of the environment in which packages may be, outside of the workspace."""
        return self.prefixes(*ELSEWHERE)

    def prefixes(self, *variables: str) -> Iterator[str]:
        """Yield the folders that path-like environment variables, such as AMENT_PREFIX_PATH, list."""
        for variable in variables:
            for path in self.environ.get(variable, "").split(os.pathsep):
                if path:
                    yield path


class Packages:
    """Finds packages for one robot's file."""

    def __init__(self, file: str, index: PackageIndex) -> None:
        self._folder = os.path.dirname(os.path.abspath(file))
        self._index = index
        self._found: dict[str, str] = {}
        self.assumed: set[str] = set()
        """Names for which `find` returned a folder without a package.xml."""

    def own(self) -> str | None:
        """Return the folder of the package that contains the file; None if the workspace has none."""
        return next((folder for folder in self._ancestors() if self._index.name_of(folder)), None)

    def around(self, folder: str) -> str | None:
        """Return the folder of the package that a folder is in; None if it is in none."""
        return Packages(os.path.join(folder, "package.xml"), self._index).own()

    def _own_name(self) -> str:
        folder = self.own()
        return (folder and self._index.name_of(folder)) or ""

    def once(self, key: Hashable, compute: Callable[[], _T]) -> _T:
        """Return what a function returned for the first file of the same package that gave this key."""
        return self._index.once((self.own(), key), compute)

    def declares(self, name: str, file: str = "") -> bool | None:
        """Return whether package.xml declares a package: that of the robot file, or that of the file that uses it.

        None if neither file is in a package.
        """
        used = Packages(file, self._index).own() if file else None
        folders = [folder for folder in (self.own(), used) if folder]
        return any(name in self._index.dependencies(folder) for folder in folders) if folders else None

    def is_guessed(self, path: str) -> bool:
        """Return whether a path is in a folder that was only taken for a package because of its name."""
        return any(path.startswith(self._found[name] + os.sep) for name in self.assumed)

    def beside(self) -> list[str]:
        """Return the packages beside the folder whose config/ contains the file.

        For a folder that should be a package, but has no package.xml.
        """
        around = list(self._ancestors())[2:3]
        if os.path.basename(self._folder) != "config" or not around:
            return []
        beside = (
            entry.path for entry in gate.entries_in(around[0]) if is_searched(entry.name) and not entry.is_symlink()
        )
        return [folder for folder in sorted(beside) if self._index.name_of(folder)]

    def find(self, name: str) -> str:
        """Return the folder of a package. Raises PackageNotFound if no package has this name."""
        if name in ("", os.curdir, os.pardir) or {os.sep, "/"} & {*name}:  # a path could lead out of the search folders
            raise self._not_found(name)
        if name not in self._found:
            folder, is_assumed = self._index.once(("find", self._folder, name), lambda: self._looked_for(name))
            if folder is None:
                raise self._not_found(name)
            self._found[name] = folder
            self.assumed.update([name] if is_assumed else [])
        return self._found[name]

    def _not_found(self, name: str) -> PackageNotFound:
        """The error for a package, with the packages that may be meant."""
        return PackageNotFound(name, *may_be_meant(name, self.known(), self._own_name(), self._index.declared))

    def _looked_for(self, name: str) -> tuple[str | None, bool]:
        """The folder of a package, and whether it has no package.xml."""
        folder = (
            self._nearest(name, self._index.named)
            or self._from_environment(name)
            or self._from_nearby(name)
            or self._nearest(name, self._index.around)
        )
        assumed = None if folder else self._without_manifest(name)
        return folder or assumed, assumed is not None

    def is_of_workspace(self, name: str) -> bool:
        """Return whether a package of this name is in the workspace."""
        return name in self._found or any(name in crawl.packages() for crawl in self._index.crawls)

    def address_of(self, path: str) -> str | None:
        """Return the package:// address of a file in the robot file's own package; None for other files."""
        own, path = self.own(), os.path.normpath(path)
        if own is None or not path.startswith(own + os.sep):
            return None
        return f"package://{self._index.name_of(own)}/{path[len(own) + 1 :].replace(os.sep, '/')}"

    def known(self) -> list[str]:
        """Return the names of all packages in the package paths and the workspace, for "did you mean" hints."""
        return [name for crawl in self._index.crawls for name in crawl.packages()]

    def source_of(self, path: str) -> str:
        """Return the source file of an installed path; the path itself if it exists or no file is installed there."""
        if gate.exists(path):
            return path
        for name, folder in self._around(path):
            return self._source_in(folder, name, path[len(folder) + 1 :]) or path
        return self._of_other_machine(path) or path

    def _around(self, path: str) -> list[tuple[str, str]]:
        """The packages with a path in them, by name: those that were found, and the robot file's own one."""
        own = self.own()
        folders = {**({self._own_name(): own} if own else {}), **self._found}
        return [(name, folder) for name, folder in folders.items() if path.startswith(folder + os.sep)]

    def _source_in(self, folder: str, name: str, relative: str) -> str | None:
        return self._index.install_map(folder, name).source_of(os.path.normpath(relative))

    def _of_other_machine(self, path: str) -> str | None:
        """The file that an absolute path of another machine means: it goes through a package of the workspace."""
        is_inside = path.startswith(self._index.workspace + os.sep)
        parts = path.split(os.sep) if os.path.isabs(path) and not is_inside else []
        for index in range(len(parts) - 2, 0, -1):
            if self.is_of_workspace(parts[index]):
                folder, relative = self.find(parts[index]), os.path.join(*parts[index + 1 :])
                candidate = os.path.join(folder, relative)
                found = candidate if gate.is_file(candidate) else self._source_in(folder, parts[index], relative)
                if found is not None:
                    return found
        return None

    def install_map(self, folder: str, name: str) -> InstallMap:
        """Return the install rules of a source package."""
        return self._index.install_map(folder, name)

    def may_be_made(self, path: str) -> bool:
        """Return whether a missing file may be created later, by the build of a source package or by other tools.

        True if .gitignore names it, if the build generates files, or if its install rules are not all known and the
        file's folder is missing too, or the package has a file of that name elsewhere.
        """
        if self.is_ignored_by_git(path):
            return True
        for name, folder in self._around(path):
            build = self._index.install_map(folder, name)
            return build.makes or not (build.whole or self._is_missing_from(folder, path))
        return False

    def _is_missing_from(self, package: str, path: str) -> bool:
        """Whether the folder of a missing file exists, and the package has no other file of that name."""
        return gate.is_folder(os.path.dirname(path)) and os.path.basename(path) not in self._index.file_names(package)

    def is_made_by_build(self, path: str) -> bool:
        """Return whether the CMakeLists.txt of a source package mentions a missing file of it, and may make files."""
        builds = (self._index.install_map(folder, name) for name, folder in self._around(path))
        return any(build.makes_named(os.path.basename(path)) for build in builds)

    def is_ignored_by_git(self, path: str) -> bool:
        """Return whether git ignores a missing file: it is created later, and never committed."""
        return self._index.is_ignored_by_git(path)

    def _from_environment(self, name: str) -> str | None:
        for prefix in self._index.prefixes(*PREFIXES):
            share = os.path.join(prefix, "share", name)
            if gate.exists(os.path.join(prefix, _AMENT_INDEX, name)) or self._index.name_of(share) == name:
                return share
        for root in self._index.prefixes(_ROOTS):
            folder = os.path.join(root, name)
            if self._index.name_of(folder) == name:
                return folder
        return None

    def _from_nearby(self, name: str) -> str | None:
        """A package among or beside the ancestors. Inside another package it is only used if there is no other one."""
        nested: str | None = None
        for folder in self._ancestors():
            own = self._index.name_of(folder)
            if own == name:
                return folder
            sibling = os.path.join(folder, name)
            if self._index.name_of(sibling) == name:
                if own is None or folder == self._index.workspace:
                    return sibling
                nested = nested or sibling
        return nested and (self._nearest(name, self._index.around) or nested)

    def _nearest(self, name: str, crawls: Iterable[Crawl]) -> str | None:
        for crawl in crawls:
            folders = crawl.packages().get(name)
            if folders:
                return min(folders, key=self._distance)
        return None

    def _without_manifest(self, name: str) -> str | None:
        """A folder of that name among or beside the ancestors, although it has no package.xml. Not one in a package."""
        own = self.own()
        for folder in self._ancestors():
            for candidate in (folder, os.path.join(folder, name)):
                if own and candidate.startswith(own + os.sep):
                    continue
                if os.path.basename(candidate) == name and gate.is_folder(candidate) and not os.path.islink(candidate):
                    return candidate
        return None

    def _distance(self, folder: str) -> tuple[int, str]:
        """A sort key for the distance of a folder: steps up to the common ancestor, then steps down, then the path."""
        steps = os.path.relpath(folder, self._folder).split(os.sep)
        up = steps.count(os.pardir)
        return up * 1000 + len(steps) - up, folder

    def _ancestors(self) -> Iterator[str]:
        """The file's folder and its ancestors up to the workspace; only the folder if it is outside the workspace."""
        folder, top = self._folder, self._index.workspace
        yield folder
        if not (folder + os.sep).startswith(top.rstrip(os.sep) + os.sep):
            return
        while folder != top:
            folder = os.path.dirname(folder)
            yield folder
