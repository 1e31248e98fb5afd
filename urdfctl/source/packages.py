"""Finds ROS packages without ROS: `$(find pkg)` and `package://pkg`.

The order: `--package-path`, the prefixes of a sourced environment, the file's own package and its siblings on the way
up, and then, on the first miss only, one walk through the enclosing workspace. The nearest package of a name wins.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.hints import TYPE_CHECKING
from urdfctl.source.files import first_bytes

if TYPE_CHECKING:
    from urdfctl.source.install_maps import InstallMap

_NAME = rb"<name[^>]*>\s*([^<\s]+)\s*</name>"
_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_IGNORE_FILES = frozenset({"COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE"})
_PRUNED = frozenset({"build", "install", "log", "devel", "node_modules", "__pycache__", "site-packages"})
_MOST_FOLDERS = 100_000
_AMENT_INDEX = "share/ament_index/resource_index/packages"


class PackageNotFound(Exception):
    """No package of a name, where packages were looked for."""

    def __init__(self, name: str, known: Sequence[str]) -> None:
        super().__init__(f"package '{name}' not found")
        self.name = name
        self.known = known


def package_name(manifest: str) -> str | None:
    """The `<name>` that a package.xml gives; None where it gives none or cannot be read."""
    try:
        data = first_bytes(manifest, 65536)
    except OSError:
        return None
    found = re.search(_NAME, data)
    if found and b"<!--" in data[: found.start()]:
        found = re.search(_NAME, re.sub(_COMMENT, b"", data))
    return found.group(1).decode("utf-8", "replace") if found else None


class Crawl:
    """The packages below one folder, found by one pruned walk, on first use. Symlinked folders are not followed."""

    def __init__(self, root: str) -> None:
        self.root = root
        self._found: dict[str, list[str]] | None = None

    def packages(self) -> dict[str, list[str]]:
        """The folders of each package name."""
        if self._found is None:
            self._found = {}
            for folder in package_folders(self.root):
                name = package_name(os.path.join(folder, "package.xml"))
                if name:
                    self._found.setdefault(name, []).append(folder)
        return self._found


def package_folders(root: str) -> Iterator[str]:
    """The folders below `root` that hold a package.xml; a package is not searched for further ones, as colcon does."""
    pending, walked = [root], 0
    while pending and walked < _MOST_FOLDERS:
        folder = pending.pop()
        walked += 1
        try:
            with os.scandir(folder) as entries:
                listed = list(entries)
        except OSError:
            continue
        names = {entry.name for entry in listed}
        if names & _IGNORE_FILES:
            continue
        if "package.xml" in names:
            yield folder
            if folder != root:
                continue
        pending.extend(entry.path for entry in listed if _is_walked(entry))


def _is_walked(entry: os.DirEntry[str]) -> bool:
    if entry.name.startswith(".") or entry.name in _PRUNED:
        return False
    try:
        return entry.is_dir(follow_symlinks=False)
    except OSError:
        return False


class PackageIndex:
    """What is shared between the robots of one run: the walks, the manifests and the install maps that were read."""

    def __init__(self, workspace: str, extra: Sequence[str] = (), environ: Mapping[str, str] | None = None) -> None:
        self.workspace = os.path.abspath(workspace)
        self.extra = [os.path.abspath(path) for path in extra]
        self.environ = os.environ if environ is None else environ
        self.named = [Crawl(path) for path in self.extra]
        self.around = [Crawl(path) for path in [self.workspace, *self.prefixes("ROS_PACKAGE_PATH")]]
        self.crawls = [*self.named, *self.around]
        self._names: dict[str, str | None] = {}
        self._maps: dict[str, InstallMap] = {}

    def name_of(self, folder: str) -> str | None:
        """The name of the package whose manifest lies in a folder; None where none lies there."""
        if folder not in self._names:
            manifest = os.path.join(folder, "package.xml")
            self._names[folder] = package_name(manifest) if os.path.exists(manifest) else None
        return self._names[folder]

    def install_map(self, folder: str, name: str) -> InstallMap:
        """What a source package installs where."""
        from urdfctl.source.install_maps import read_install_map

        if folder not in self._maps:
            self._maps[folder] = read_install_map(folder, name)
        return self._maps[folder]

    def prefixes(self, *variables: str) -> Iterator[str]:
        """The folders that environment variables of the ROS kind list."""
        for variable in variables:
            for path in self.environ.get(variable, "").split(os.pathsep):
                if path:
                    yield path


class Packages:
    """The packages as one robot's file sees them."""

    def __init__(self, file: str, index: PackageIndex) -> None:
        self._folder = os.path.dirname(os.path.abspath(file))
        self._index = index
        self._found: dict[str, str] = {}
        self.assumed: set[str] = set()
        """The names for which only a folder without a package.xml was found."""

    def own(self) -> str | None:
        """The folder of the package that the file lies in, within the workspace."""
        return next((folder for folder in self._ancestors() if self._index.name_of(folder)), None)

    def beside(self) -> list[str]:
        """The packages beside the folder whose config/ the file lies in: that one has lost its manifest, or is to get
        one."""
        around = list(self._ancestors())[2:3]
        if os.path.basename(self._folder) != "config" or not around:
            return []
        try:
            with os.scandir(around[0]) as entries:
                inside = sorted(entry.path for entry in entries if _is_walked(entry))
        except OSError:
            return []
        return [path for path in inside if self._index.name_of(path)]

    def find(self, name: str) -> str:
        """The folder of a package. PackageNotFound where there is none."""
        if name in ("", os.curdir, os.pardir) or os.sep in name:  # a path would lead anywhere
            raise PackageNotFound(name, self.known())
        if name not in self._found:
            folder = (
                self._nearest(name, self._index.named)
                or self._from_environment(name)
                or self._from_nearby(name)
                or self._nearest(name, self._index.around)
                or self._without_manifest(name)
            )
            if folder is None:
                raise PackageNotFound(name, self.known())
            self._found[name] = folder
        return self._found[name]

    def address_of(self, path: str) -> str | None:
        """The package:// address of a file in the package that the robot's file lies in; None for any other."""
        own, path = self.own(), os.path.normpath(path)
        if own is None or not path.startswith(own + os.sep):
            return None
        return f"package://{self._index.name_of(own)}/{path[len(own) + 1 :].replace(os.sep, '/')}"

    def known(self) -> list[str]:
        """The names that a walk has found, for did-you-mean."""
        return [name for crawl in self._index.crawls for name in crawl.packages()]

    def source_of(self, path: str) -> str:
        """Where the source of an installed path lies: the path itself where it exists or no install rule makes it."""
        if os.path.exists(path):
            return path
        for name, folder in self._found.items():
            if path.startswith(folder + os.sep):
                relative = os.path.normpath(path[len(folder) + 1 :])
                return self._index.install_map(folder, name).source_of(relative) or path
        return path

    def install_map(self, folder: str, name: str) -> InstallMap:
        """What a source package installs where."""
        return self._index.install_map(folder, name)

    def may_be_made(self, path: str) -> bool:
        """Whether a file of a source package that is not there may come to be when the package is built: its build
        files do not surely tell what they install, and its folder is not there either, or they make files."""
        for name, folder in self._found.items():
            if path.startswith(folder + os.sep):
                build = self._index.install_map(folder, name)
                return build.makes or not (build.whole or os.path.isdir(os.path.dirname(path)))
        return False

    def _from_environment(self, name: str) -> str | None:
        for prefix in self._index.prefixes("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "CMAKE_PREFIX_PATH"):
            share = os.path.join(prefix, "share", name)
            if os.path.exists(os.path.join(prefix, _AMENT_INDEX, name)) or self._index.name_of(share) == name:
                return share
        for root in self._index.prefixes("ROS_PACKAGE_PATH"):
            folder = os.path.join(root, name)
            if self._index.name_of(folder) == name:
                return folder
        return None

    def _from_nearby(self, name: str) -> str | None:
        for folder in self._ancestors():
            if self._index.name_of(folder) == name:
                return folder
            sibling = os.path.join(folder, name)
            if self._index.name_of(sibling) == name:
                return sibling
        return None

    def _nearest(self, name: str, crawls: Iterable[Crawl]) -> str | None:
        for crawl in crawls:
            folders = crawl.packages().get(name)
            if folders:
                return min(folders, key=self._distance)
        return None

    def _without_manifest(self, name: str) -> str | None:
        """A folder of that name on the way up, though it has no package.xml: half a checkout, or one to be."""
        for folder in self._ancestors():
            for candidate in (folder, os.path.join(folder, name)):
                if os.path.basename(candidate) == name and os.path.isdir(candidate) and not os.path.islink(candidate):
                    self.assumed.add(name)
                    return candidate
        return None

    def _distance(self, folder: str) -> tuple[int, str]:
        """How far a folder lies: the steps up to what both share count most, then the steps down."""
        steps = os.path.relpath(folder, self._folder).split(os.sep)
        up = steps.count(os.pardir)
        return up * 1000 + len(steps) - up, folder

    def _ancestors(self) -> Iterator[str]:
        """The file's folder and those above it, up to the workspace; it alone where it lies outside."""
        folder, top = self._folder, self._index.workspace
        yield folder
        if not (folder + os.sep).startswith(top.rstrip(os.sep) + os.sep):
            return
        while folder != top:
            folder = os.path.dirname(folder)
            yield folder
