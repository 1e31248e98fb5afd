"""Find the files that a robot's meshes name, without reading them."""

from __future__ import annotations

import os
from collections.abc import Callable

from urdfctl.model.robot import MeshFile
from urdfctl.names import nearest
from urdfctl.source.disk.gate import admits, is_file, names_in
from urdfctl.source.workspaces.packages import PackageNotFound, Packages


def mesh_finder(packages: Packages, robot_file: str) -> Callable[[str], MeshFile | None]:
    """Return a function that finds the file of a mesh address.

    It returns None for addresses that are not files, for files outside of what the run may read, and for missing files
    that git ignores: they are made later.
    """
    known: dict[str, MeshFile | None] = {}

    def find_mesh(address: str) -> MeshFile | None:
        if address not in known:
            known[address] = _mesh_file(address, packages, robot_file)
        return known[address]

    return find_mesh


def mesh_path(address: str, packages: Packages, robot_file: str) -> str | None:
    """Return the file of a mesh address; None if it is unknown or does not exist.

    A path outside of what the run may read is returned without a look at it: whoever opens it learns that.
    """
    if address.startswith("package://"):
        package, _, rest = address.removeprefix("package://").partition("/")
        try:
            path = os.path.join(packages.find(package), rest)
        except PackageNotFound:
            return None
    else:
        path = address.removeprefix("file://")
        if "://" in path or not path:
            return None
        path = os.path.join(os.path.dirname(robot_file), path)
    path = packages.source_of(path)
    return path if not admits(path) or os.path.isfile(path) else None


def _mesh_file(address: str, packages: Packages, robot_file: str) -> MeshFile | None:
    if address.startswith("package://"):
        return _in_package(address.removeprefix("package://"), packages)
    path = address.removeprefix("file://")
    if "://" in path or not path:
        return None
    if not os.path.isabs(path):
        path = os.path.join(os.path.dirname(robot_file), path)
    mesh = _file(packages.source_of(path), None, packages)
    return mesh._replace(address=packages.address_of(path)) if mesh else None


def _in_package(address: str, packages: Packages) -> MeshFile | None:
    package, _, path = address.partition("/")
    try:
        folder = packages.find(package)
    except PackageNotFound as error:
        own = os.path.join(packages.own() or "", address)
        return MeshFile(
            exists=False,
            package=package,
            package_found=False,
            nearest=nearest(package, error.known),
            meant=packages.address_of(own) if is_file(own) else None,
            package_declared=bool(packages.declares(package)),
        )
    return _file(packages.source_of(os.path.join(folder, path)), package, packages)


def _file(path: str, package: str | None, packages: Packages) -> MeshFile | None:
    if is_file(path):
        return MeshFile(True, package)  # noqa: FBT003
    if not admits(path) or packages.is_ignored_by_git(path):
        return None
    try:
        beside = names_in(os.path.dirname(path))
    except OSError:
        beside = []
    return MeshFile(False, package, nearest=nearest(os.path.basename(path), beside))  # noqa: FBT003
