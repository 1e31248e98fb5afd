"""The files in SDF of the packages: worlds and models."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.migrate.edits.markup import elements, root_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.source.workspaces.packages import package_name
from urdfctl.source.xml.dom import Element

OF_SDF = (".sdf", ".world")
_MAY_BE_SDF = (*OF_SDF, ".xacro")


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
        elif os.path.basename(folder) == "models":
            names.add(name)
    return names - {""}
