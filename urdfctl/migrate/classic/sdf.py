"""The files in SDF of the packages: worlds and models."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.migrate.edits.markup import elements, root_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.xml.dom import Element

OF_SDF = (".sdf", ".world")
_MAY_BE_SDF = (*OF_SDF, ".xacro")
_OF_MODELS = (*_MAY_BE_SDF, ".urdf", ".gazebo")
_USED = re.compile(rb"model://([^/<>\s'\"]+)")
MODELS = "models"


def sdf_elements(packages: MigratedPackages, mark: bytes) -> Iterator[Element]:
    """Yield the elements of the files in SDF that contain a text, in order."""
    for path in packages.files(*_MAY_BE_SDF):
        source = packages.read(path)
        root = root_of(source) if mark in source.data and packages.may_change(path) else None
        if root is not None and root.tagName == "sdf":
            yield from elements(root)


def own_models(packages: MigratedPackages) -> set[str]:
    """Return the names that `model://` finds in the packages: models, files in folders of models, and packages."""
    names = {package_name(path) or "" for path in packages.files("package.xml")}
    for path in packages.files():
        folder, name = os.path.split(path)
        if name.endswith(("model.config", ".sdf", ".urdf")):
            names.add(os.path.basename(folder))
        elif os.path.basename(folder) == MODELS:
            names.add(name)
    return names - {""}


def model_folders(packages: MigratedPackages) -> dict[str, list[str]]:
    """Return the folders, beside models/, in which files of the packages find models by `model://NAME`: relative to a
    package, by its folder."""
    used = {
        found[1].decode() for path in packages.files(*_OF_MODELS) for found in _USED.finditer(packages.read(path).data)
    }
    places: dict[str, list[tuple[str, str]]] = {}
    for path in packages.files("/model.config"):
        around, name = os.path.split(os.path.dirname(path))
        package = package_around(around) if name in used else None
        if package is not None and packages.may_change(path):
            places.setdefault(name, []).append((package, os.path.relpath(around, package).replace(os.sep, "/")))
    found: dict[str, list[str]] = {}
    for models in places.values():
        if not any(relative == MODELS for _, relative in models):
            package, relative = models[0]
            found[package] = sorted({*found.get(package, ()), relative})
    return found
