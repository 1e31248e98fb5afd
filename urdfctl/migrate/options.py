"""The options of a migration."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType

from urdfctl.catalog.distros import ALL
from urdfctl.startup.records import NamedTuple


class Part(Enum):
    """A part of a package that can be migrated on its own, by its name for `--only`."""

    URDF = "urdf"
    YAML = "yaml"
    LAUNCH = "launch"
    MANIFEST = "manifest"
    MOVEIT = "moveit"


class MigrationOptions(NamedTuple):
    """The options of a migration.

    target: the distro to migrate to.
    source: the distro to migrate from; None to detect it.
    simulator: the simulator of the migrated robot; None to keep it, or to take its successor.
    hardware: the plugin for real hardware; None if it is unknown.
    launch: how new launch files are written: py or xml.
    keep_classic: keep Gazebo Classic beside gz, behind a xacro argument.
    only: the parts to migrate; all if empty.
    steps: the names of the steps to take; all if empty.
    skipped: the names of the steps to leave out.
    successors: names of the project's own with those that replace them: types, plugins, topics, packages.
    """

    target: str
    source: str | None = None
    simulator: str | None = None
    hardware: str | None = None
    launch: str = "py"
    keep_classic: bool = False
    only: frozenset[Part] = frozenset()
    steps: frozenset[str] = frozenset()
    skipped: frozenset[str] = frozenset()
    successors: Mapping[str, str] = MappingProxyType({})

    def takes(self, name: str, part: Part) -> bool:
        """Return whether the user wants a step."""
        is_named = (not self.only or part in self.only) and (not self.steps or name in self.steps)
        return is_named and name not in self.skipped

    def crosses(self, since: str, source: str | None = None) -> bool:
        """Return whether the migration leads from a distro before `since` to it or a later one.

        source: the distro to migrate from, if the user does not name it; None if unknown, which counts as earlier.
        """
        order = ALL.index
        start = self.source or source
        return order(self.target) >= order(since) and (start is None or order(start) < order(since))
