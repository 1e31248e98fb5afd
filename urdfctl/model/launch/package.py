"""The model of a package, from its manifest and its build files."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from functools import partial

from urdfctl.model.robot import text_of
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import is_file
from urdfctl.source.span import Place
from urdfctl.source.workspaces.packages import PackageNotFound, Packages, package_name
from urdfctl.source.workspaces.packages import package_around as folder_around
from urdfctl.source.xml.dom import Document, Element
from urdfctl.startup.records import NamedTuple


class LeftOut(NamedTuple):
    """A file that its package does not install.

    folder: that of the package. inner: the path of the file in it, and above: of the folder with the file; empty for
    the package's own. build: the name of the build file.
    """

    folder: str
    inner: str
    above: str
    build: str

    @property
    def package(self) -> str:
        """The name of the package's folder."""
        return os.path.basename(self.folder)


class Package(NamedTuple):
    """The package that contains a launch file.

    at: the root element of the manifest.
    ros: the ROS generation of its build system; None if unknown, or if it is built for both.
    dependencies: its run dependencies, as the manifest lists them.
    reaches: returns whether a package is among its run dependencies, directly or through other source packages.
    installs: returns whether a source file, by its path, is installed to the share folder; None if unknown.
    left_out: returns a file if the source package that contains it does not install it; None if it does, or if that is
        unknown.
    shares_models: returns whether a package, by its name, adds its folder to Gazebo's model path; None if unknown.
    """

    name: str
    folder: str
    at: Place
    ros: int | None
    dependencies: frozenset[str]
    reaches: Callable[[str], bool]
    installs: Callable[[str], bool | None]
    left_out: Callable[[str], LeftOut | None] = lambda _: None
    shares_models: Callable[[str], bool | None] = lambda _: None
    tag: str = "exec_depend"
    """The element for a run dependency in the manifest's format."""

    def holds(self, place: Place) -> bool:
        """Return whether a place is in a file of the package."""
        return place.source.path.startswith(f"{self.folder}/")


_RUNNING = ("depend", "exec_depend", "run_depend", "build_export_depend")
_MOST_MANIFESTS = 300
_DEPEND = re.compile(r"<(?:depend|exec_depend|run_depend)\b[^>]*>\s*([^<\s]+)\s*<")
_COMMENT = re.compile(r"(?s)<!--.*?-->")


def package_around(packages: Packages, tree: Callable[[str], Document | None]) -> Package | None:
    """Return the package that contains a file; None if there is none, or its manifest cannot be read.

    packages: the packages as the file sees them.
    tree: returns the tree of an XML file; None if it cannot be read.
    """
    folder = packages.own()
    document = tree(os.path.join(folder, "package.xml")) if folder else None
    root = document.documentElement if document else None
    if folder is None or root is None or root.tagName != "package":
        return None
    name = next(_texts(root, "name"), "")
    running = frozenset(text for tag in _RUNNING for text in _texts(root, tag))
    built = " ".join(_texts(root, "buildtool_depend"))
    exports = (element for export in root.elements() if export.tagName == "export" for element in export.elements())
    kind = " ".join(text_of(element).value for element in exports if element.tagName == "build_type")
    generations = [number for number, tool in ((1, "catkin"), (2, "ament")) if tool in built + kind]
    return Package(
        name=name,
        folder=folder,
        at=root.at,
        ros=generations[0] if len(generations) == 1 else None,
        dependencies=running,
        reaches=partial(_reaches, packages, running),
        installs=partial(_installs, packages, folder, name),
        left_out=partial(_left_out, packages),
        shares_models=partial(_shares_models, packages),
        tag=run_dependency_tag(root),
    )


def run_dependency_tag(root: Element) -> str:
    """Return the element for a run dependency in a manifest: format 1 has no <exec_depend> (catkin_pkg, REP 127)."""
    return "run_depend" if root.attrs.get("format", "1").strip() == "1" else "exec_depend"


def _texts(root: Element, tag: str) -> Iterator[str]:
    for element in root.elements():
        if element.tagName == tag:
            yield text_of(element).value


def _installs(packages: Packages, folder: str, name: str, path: str) -> bool | None:
    """Whether a file of the package is installed; None if unknown."""
    relative = os.path.relpath(path, folder)
    return packages.install_map(folder, name).installs(relative) if not relative.startswith(os.pardir) else None


def _left_out(packages: Packages, path: str) -> LeftOut | None:
    """A file, if the package that contains it surely does not install it."""
    folder = folder_around(os.path.dirname(path))
    name = package_name(os.path.join(folder, "package.xml")) if folder else None
    if folder is None or name is None or _installs(packages, folder, name, path) is not False:
        return None
    inner = os.path.relpath(path, folder)
    builds = (name for name in ("CMakeLists.txt", "setup.py") if is_file(os.path.join(folder, name)))
    return next((LeftOut(folder, inner, os.path.dirname(inner), build) for build in builds), None)


def _reaches(packages: Packages, running: frozenset[str], name: str) -> bool:
    """Whether a package is among the run dependencies, directly or through other source packages."""
    return name in running or name in packages.once(running, partial(_reached, packages, running))


def _reached(packages: Packages, running: frozenset[str]) -> frozenset[str]:
    """The run dependencies, and those of source packages among them."""
    seen = set(running)
    pending = sorted(running)
    while pending and len(seen) < _MOST_MANIFESTS:
        new = _needed_by(packages, pending.pop()) - seen
        seen |= new
        pending += sorted(new)
    return frozenset(seen)


def _shares_models(packages: Packages, name: str) -> bool | None:
    """Whether a package exports a model path for Gazebo, or may set environment variables; None if it is not here."""
    try:
        folder = packages.find(name)
        manifest = first_bytes(os.path.join(folder, "package.xml"), 65536)
    except (PackageNotFound, OSError):
        return None
    if b"model_path" in _COMMENT.sub("", manifest.decode("utf-8", "replace")).encode():
        return True
    for build_file in ("CMakeLists.txt", "setup.py"):
        path = os.path.join(folder, build_file)
        if is_file(path) and re.search(rb"environment_hooks|\bhook", first_bytes(path, 1 << 18)):
            return True
    return False


def _needed_by(packages: Packages, name: str) -> set[str]:
    try:
        manifest = os.path.join(packages.find(name), "package.xml")
        text = first_bytes(manifest, 65536).decode("utf-8", "replace")
        return set(_DEPEND.findall(_COMMENT.sub("", text)))
    except (PackageNotFound, OSError):
        return set()
