"""The types of controllers and hardware that the packages of a workspace define, beside those of the catalogue."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from urdfctl.model.project import OwnTypes, Project
from urdfctl.source.disk.files import Files
from urdfctl.source.workspaces.packages import PackageIndex

if TYPE_CHECKING:
    from urdfctl.load.own_types import ExportedClasses


class WorkspaceTypes:
    """The types that packages define, by workspace. What the packages export is read once for a run."""

    def __init__(self) -> None:
        self._exports: dict[str, list[ExportedClasses]] = {}
        self._own_types: dict[tuple[str, frozenset[str]], OwnTypes] = {}

    def with_same_exports(self) -> WorkspaceTypes:
        """Return other types of the same packages, for texts that have changed."""
        other = WorkspaceTypes()
        other._exports = self._exports
        return other

    def added_to(self, project: Project, index: PackageIndex, files: Files) -> Project:
        """Return a project with the types that the workspace's packages define, if the catalogue lacks one of its
        types, or has one that such a package may define in another way."""
        robot = project.robot
        if not project.controllers and not (robot and (robot.ros2_controls or robot.plugins)):
            return project
        from urdfctl.load.unknown_types import shared_types, unknown_types

        unknown = unknown_types(project)
        wanted = unknown | shared_types(project, lambda name: any(name in each.packages() for each in index.crawls))
        if not wanted:
            return project
        key = index.workspace, frozenset(wanted)
        if key not in self._own_types:
            self._own_types[key] = self._defined_in(index, files, wanted, unknown)
        return project._replace(own=self._own_types[key]._replace(nodes=project.own.nodes))

    def _defined_in(
        self, index: PackageIndex, files: Files, wanted: Collection[str], unknown: Collection[str]
    ) -> OwnTypes:
        """What the packages of a workspace define of some types.

        unknown: those that the catalogue lacks: unless the packages that they are named after have them, all are read.
        """
        from urdfctl.load.own_types import exports_in, own_types, prefixes_of, without_copies

        exports = self._exports.get(index.workspace)
        if exports is None:
            exports = exports_in(_packages_of(index, prefixes_of(wanted)), files)
            if not {one.name for each in exports for one in each.classes}.issuperset(unknown):
                exports = self.exports_in(index, files)
        return without_copies(own_types(wanted, exports, files))

    def exports_in(self, index: PackageIndex, files: Files) -> list[ExportedClasses]:
        """Return what the packages of a workspace export."""
        from urdfctl.load.own_types import exports_in

        if index.workspace not in self._exports:
            self._exports[index.workspace] = exports_in(_packages_of(index), files)
        return self._exports[index.workspace]


def _packages_of(index: PackageIndex, names: Collection[str] | None = None) -> list[tuple[str, str]]:
    """The packages of a workspace with some names, or all, each with its folder."""
    found = (pair for crawl in index.crawls for pair in crawl.packages().items())
    return [(name, folder) for name, folders in found if names is None or name in names for folder in folders]
