"""The packages of a migration, as steps see them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from urdfctl.catalog.distros import ROS2, generation
from urdfctl.config.settings import Settings
from urdfctl.lint.results import TargetResult
from urdfctl.load.loader import LoadedTarget, Loader
from urdfctl.load.target import Target
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.origins import Origins
from urdfctl.migrate.trial.memory import Memory
from urdfctl.migrate.trial.scratch import Scratch, WrittenFile
from urdfctl.source.budget import OverBudget
from urdfctl.source.disk.files import MAX_BYTES, first_bytes
from urdfctl.source.disk.gate import exists
from urdfctl.source.span import SourceText

Value = TypeVar("Value")
OF_XML = (".xacro", ".urdf", ".gazebo", ".xml", ".inc")
"""The endings of files that robots are written in."""

Linted = Sequence[tuple[Target, TargetResult]]
Lint = Callable[[Settings], Linted]
"""Lints the packages as they are now, as `urdfctl lint` does, and returns every target with its result."""


class MigratedPackages:
    """The packages to migrate, as they are after the proposals so far. All paths are of the copy that is migrated.

    options: what the user wants.
    settings: the settings of the run, with the distro to migrate from if the user names it.
    linted: the targets before the migration, with their results.
    known: the targets that were read before.
    began: the targets at the beginning of the run, which say what is migrated; in a later pass they are not `linted`.
    robots_before: those targets with their models; none before they were loaded.
    origins: the distros that the packages come from.
    """

    def __init__(
        self,
        scratch: Scratch,
        options: MigrationOptions,
        settings: Settings,
        linted: Linted,
        known: Memory[LoadedTarget],
        began: Linted,
        origins: Origins,
    ) -> None:
        self.scratch = scratch
        self.options = options
        self.settings = settings
        self.linted = linted
        self._known, self._began, self._origins = known, began, origins
        self.robots_before: Sequence[LoadedTarget] = ()
        self._sources: dict[str, tuple[WrittenFile | None, SourceText]] = {}
        self._loaded: dict[str | None, list[LoadedTarget]] = {}
        self._loaders: dict[str | None, Loader] = {}
        self._files: list[str] = []
        self._real: dict[str, str] = {}
        self._found: dict[object, object] = {}

    @property
    def is_ros1(self) -> bool:
        """Whether a part of the packages is for ROS 1."""
        if self.options.source:
            return generation(self.options.source) == 1
        return any(result.ros == 1 for _, result in self._began)

    @property
    def was_in_gz(self) -> bool:
        """Whether gz simulates a robot of the packages before the migration."""
        return any(result.simulator == "gz" for _, result in self._began)

    def is_of_classic(self, robot: LoadedTarget) -> bool:
        """Return whether Gazebo Classic simulates a robot with its arguments before the migration, and nothing else."""
        key = os.path.realpath(robot.project.path), robot.arguments
        same = (one for _, one in self._began if (os.path.realpath(one.path), one.arguments) == key)
        return {one.simulator for one in same if one.simulator} == {"gazebo-classic"}

    def crosses(self, since: str, path: str = "") -> bool:
        """Return whether the migration leads from a distro before `since` to it or a later one.

        path: a file, whose package's distro counts; without it, the earliest of all packages.
        """
        source = self._origins.of(path) if path else self._origins.all
        return self.options._replace(source=None).crosses(since, source)

    def reaches(self, since: str) -> bool:
        """Return whether the target is a distro or a later one, whichever the migration comes from."""
        return ROS2.index(self.options.target) >= ROS2.index(since)

    @property
    def simulator(self) -> str | None:
        """The simulator after the migration: gz, gazebo-classic, mujoco or none; None if the robot has none now."""
        if self.options.simulator:
            return self.options.simulator
        now = {result.simulator for _, result in self.linted} - {None}
        if now <= {"none"}:
            return None
        if "gazebo-classic" not in now or ROS2.index(self.options.target) < ROS2.index("jazzy"):
            return min(filter(None, now))
        return "gz"

    def files(self, *endings: str) -> Iterator[str]:
        """Return the files to migrate whose names end so, in order; without endings, all of them.

        Those in hidden folders are none: colcon and catkin look for no packages there.
        """
        self._files = self._files or [path for path in self.scratch.files() if not self.scratch.is_hidden(path)]
        return (path for path in self._files if not endings or path.endswith(endings))

    def read(self, path: str) -> SourceText:
        """Return the content of a file; empty if it cannot be read or is too large. Each state is read once."""
        real = self._real.get(path)
        if real is None:
            real = self._real[path] = os.path.realpath(path)
        written = self.scratch.written.get(real)
        state, source = self._sources.get(path, (None, None))
        if source is None or state is not written:
            source = SourceText(path, _text(path))
            self._sources[path] = written, source
        return source

    def found(self, find: Callable[[MigratedPackages], Value]) -> Value:
        """Return what a function finds in the packages; it is called once for each state of them."""
        if find not in self._found:
            self._found[find] = find(self)
        return self._found[find]  # type: ignore[return-value]

    def targets(self) -> list[Target]:
        """Return the targets before the migration whose files still exist, and that lint read within its limits."""
        wanted = (target for target, result in self.linted if _was_read(result))
        return [target for target in wanted if exists(target.path)]

    def loaded(self, distro: str | None = None) -> list[LoadedTarget]:
        """Return all targets as they are read now: robot, controllers and launch file, each part with its place.

        distro: read them for this distro; None for the distro to migrate from, or the one that the files indicate.
        """
        if distro not in self._loaded:
            loader = self._loader(distro or self.options.source)
            found = (self._load(loader, target) for target in self.targets())
            self._loaded[distro] = [one for one in found if one is not None]
        return self._loaded[distro]

    def _loader(self, distro: str | None) -> Loader:
        """A loader that reads the files as they are now. Where packages are stays the same."""
        last = self._loaders.get(distro)
        loader = Loader(self.settings._replace(distro=distro)) if last is None else last.anew()
        self._loaders[distro] = loader
        return loader

    def _load(self, loader: Loader, target: Target) -> LoadedTarget | None:
        """The target, None if it exceeds the limits of reading."""
        key = loader.settings.distro, target
        loaded = self._known.get(key)
        if loaded is None:
            try:
                loaded = loader.load(target)
            except (OverBudget, MemoryError):
                return None
            self._known.put(key, loaded.sources, loaded)
        return loaded

    def forget(self) -> None:
        """Forget what was found, because files were changed."""
        self._loaded.clear()
        self._real.clear()
        self._files = []
        self._found.clear()

    def may_change(self, path: str) -> bool:
        """Return whether a file is among those to migrate; others, as of /opt/ros, are never changed."""
        return self.scratch.may_write(path)


def _text(path: str) -> bytes:
    """The content of a file; empty if it cannot be read or is too large."""
    try:
        data = first_bytes(path, MAX_BYTES + 1)
    except OSError:
        return b""
    return data if len(data) <= MAX_BYTES else b""


def _was_read(result: TargetResult) -> bool:
    """Whether a worker read a target within its limits."""
    return not {finding.code for finding in result.outcome.diagnostics} & {"UC000", "UC014"}
