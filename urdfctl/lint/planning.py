"""Turn paths into the targets of a run."""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from enum import Enum
from itertools import product
from typing import TYPE_CHECKING

from urdfctl.config.file import Config
from urdfctl.config.robots import ConfiguredRobot
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.discover.robots import DiscoveredFiles, discover_files
from urdfctl.lint.results import TargetResult, among
from urdfctl.load.target import Target
from urdfctl.source.disk.files import is_launch
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.discover.shards import Shard

Arguments = tuple[tuple[str, str], ...]


class TargetOrigin(Enum):
    """Why something is a target, which decides whether its result is reported."""

    NAMED = "named"
    """The user names it: reported."""
    FOUND = "found"
    """A description in a folder: reported if it is a robot."""
    DECLARED = "declared"
    """A description in a folder that the configuration names: reported, robot or not."""
    LAUNCHED = "launched"
    """A launch file in a folder: reported if it has to do with controllers or a robot without links, or has findings of
    its own."""
    AROUND = "around"
    """A launch file that may start what the user names: reported if it does."""


class PlannedTarget(NamedTuple):
    """A target, and why it is one.

    focus: the files and folders that the user names, by absolute path.
    """

    target: Target
    origin: TargetOrigin
    focus: tuple[str, ...] = ()

    @property
    def is_launched(self) -> bool:
        """Whether it is a launch file that the user did not name."""
        return self.origin in (TargetOrigin.LAUNCHED, TargetOrigin.AROUND)

    @property
    def must_read(self) -> tuple[str, ...]:
        """The files and folders of which something must be read for the target to be reported; empty if none."""
        return self.focus if self.origin is TargetOrigin.AROUND else ()

    def is_reported(self, result: TargetResult) -> bool:
        """Return whether the result of the target is reported."""
        if self.origin is TargetOrigin.FOUND:
            return is_robot(result)
        if self.origin is TargetOrigin.AROUND:
            return bool(self.read(result))
        if self.origin is TargetOrigin.LAUNCHED:
            findings = result.outcome.diagnostics
            return result.is_controlled or result.links == 0 or any(_is_own(finding) for finding in findings)
        return True

    def read(self, result: TargetResult) -> set[str]:
        """Return those files that the user names, or names the folder of, which were read for the target."""
        return among(result.files, self.focus)


class Plan(NamedTuple):
    """The targets of a run, and the files that they were planned from: more targets follow from what these start."""

    files: DiscoveredFiles
    targets: list[PlannedTarget]


def _is_own(finding: Diagnostic) -> bool:
    """Whether a finding belongs to a launch file: it is in one, is about launching, or stops the started robot."""
    return finding.code.startswith("UC6") or finding.severity == Severity.ERROR or is_launch(finding.at.file)


def discovered(paths: Sequence[str], config: Config) -> DiscoveredFiles:
    """Return the files that paths mean, and the robots of the configuration in them; without paths, all its robots.

    A robot of the configuration that is found anyway stays one that is found: what belongs to it is looked for.
    """
    files = discover_files(paths, config.excludes)
    folders = tuple(os.path.abspath(path).rstrip(os.sep) + os.sep for path in paths if os.path.isdir(path))
    found = set(map(os.path.abspath, files.candidates))
    for robot in config.robots:
        path = os.path.abspath(robot.path)
        is_meant = not paths or path.startswith(folders)
        if is_meant and (path not in found or robot.controllers or robot.launches) and robot.path not in files.robots:
            files.robots.append(robot.path)
    files.focus = _focus(paths, files, config)
    if files.focus:
        from urdfctl.discover.around import launch_files_around

        known = {os.path.abspath(path) for path in files.launch_candidates}
        around = launch_files_around(files.focus)
        files.around = [path for path in around if os.path.abspath(path) not in known and not config.excludes(path)]
    return files


def _focus(paths: Sequence[str], files: DiscoveredFiles, config: Config) -> list[str]:
    """What the user names without saying what belongs to it: files, and folders inside a package."""
    if files.launches or (files.robots and files.controllers):
        return []
    from urdfctl.discover.around import is_inside_package

    paired = {os.path.abspath(robot.path) for robot in config.robots if robot.launches or robot.controllers}
    named = (os.path.abspath(path) for path in paths if os.path.isfile(path) or is_inside_package(path))
    return [path for path in named if path not in paired]


def planned(
    files: DiscoveredFiles, arguments: Arguments, robots: Sequence[ConfiguredRobot] = ()
) -> list[PlannedTarget]:
    """Return what to load. Controller files and launch files named beside a single robot belong to it, otherwise those
    of its [[robot]] entry do."""
    descriptions = files.descriptions()
    targets: dict[Target, TargetOrigin] = {}
    is_single = len(descriptions) == 1
    controllers, launches = (tuple(files.controllers), tuple(files.launches)) if is_single else ((), ())
    for path, is_named in descriptions:
        declared = [entry for entry in robots if os.path.abspath(entry.path) == path]
        found = TargetOrigin.DECLARED if declared else TargetOrigin.FOUND
        for robot in declared or [ConfiguredRobot(path)]:
            for variant, launch in product(robot.variants, launches or robot.launches or (None,)):
                given = tuple({**dict(variant), **dict(arguments)}.items())
                target = Target(path, given, controllers=controllers or robot.controllers, launch=launch)
                targets[target] = TargetOrigin.NAMED if is_named else found
    if not is_single:
        targets.update({Target(path, arguments): TargetOrigin.NAMED for path in files.launches})
    configured = {os.path.abspath(path) for robot in robots for path in robot.launches}
    candidates = (path for path in files.launch_candidates if os.path.abspath(path) not in configured)
    texts = files.documentation
    targets.update({Target(path, documented=texts.starts(path)): TargetOrigin.LAUNCHED for path in candidates})
    targets.update({Target(path, documented=texts.starts(path)): TargetOrigin.AROUND for path in files.around})
    focus = tuple(files.focus)
    return [PlannedTarget(target, origin, focus) for target, origin in targets.items()]


def of_shard(
    files: DiscoveredFiles, plan: Sequence[PlannedTarget], shard: Shard, robots: Sequence[ConfiguredRobot]
) -> tuple[DiscoveredFiles, list[PlannedTarget]]:
    """Return the part of the files, and of the targets, that one share of a run checks."""
    from urdfctl.discover.shards import share

    mine = share(files, shard, [robot.files for robot in robots])
    return files.among(mine), [entry for entry in plan if os.path.abspath(entry.target.path) in mine]


def is_launched_already(entry: PlannedTarget, launched: Collection[tuple[str, Arguments]]) -> bool:
    """Return whether launch files already load a description from a folder with the same arguments."""
    target = entry.target
    is_paired = target.controllers or target.launch
    known = (os.path.abspath(target.path), target.arguments) in launched
    return entry.origin in (TargetOrigin.FOUND, TargetOrigin.DECLARED) and not is_paired and known


def with_bringups(
    plan: Sequence[PlannedTarget], launched: Sequence[tuple[PlannedTarget, TargetResult]]
) -> list[PlannedTarget]:
    """Return the plan without the files that launch files around them start; a description that the user gives
    arguments is planned with those, and with each launch file that starts it."""
    around = [(entry.read(result), result) for entry, result in launched if entry.origin is TargetOrigin.AROUND]
    started: list[PlannedTarget] = []
    for entry in plan:
        path = os.path.abspath(entry.target.path)
        launches = [result.launch for read, result in around if path in read and result.launch]
        if not launches or entry.origin is not TargetOrigin.NAMED or entry.target.launch:
            started.append(entry)
        elif entry.target.arguments:
            started += [entry._replace(target=entry.target._replace(launch=launch)) for launch in launches]
    return started


def is_robot(result: TargetResult) -> bool:
    """Return whether a description is a robot: complete with two links, or named with one; or unreadable.

    One that hangs on links of others is none.
    """
    if result.links is None:
        return True
    if result.joining.hangs:
        return False
    return result.links > 1 if result.complete else result.links > 0 and result.robot is not None
