"""Lints what the words of a lint command mean: the robots, and what of their folders no robot uses."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import product

from urdfctl.cli.progress import watched
from urdfctl.cli.wanted import Wanted
from urdfctl.config import Config
from urdfctl.discover import Found, find
from urdfctl.jobs import lint_all
from urdfctl.lint import Linted
from urdfctl.load import Target
from urdfctl.record import NamedTuple
from urdfctl.settings import Settings
from urdfctl.variants import ConfiguredRobot


class LookedAt(NamedTuple):
    """The robots, and all that was looked at: in folders also the macro libraries, fragments and controllers' files
    that no robot uses."""

    robots: list[Linted]
    all: list[tuple[Target, Linted]]

    @property
    def linted(self) -> list[Linted]:
        """What came of each."""
        return [one for _, one in self.all]

    @property
    def crashed(self) -> bool:
        """Whether urdfctl itself was at fault anywhere."""
        return any(one.outcome.crashed for one in self.linted)


def found_by(paths: Sequence[str], config: Config) -> Found:
    """What some paths mean; with none, the robots that the configuration tells of, if it does."""
    robots = [robot.path for robot in config.robots]
    if robots and not paths:
        found = Found()
        found.robots += dict.fromkeys(robots)
        return found
    found = find(paths, config.excludes)
    folders = [os.path.abspath(path).rstrip(os.sep) + os.sep for path in paths if os.path.isdir(path)]
    found.robots += (path for path in dict.fromkeys(robots) if os.path.abspath(path).startswith(tuple(folders)))
    return found


def look_at(found: Found, arguments: tuple[tuple[str, str], ...], settings: Settings, wanted: Wanted) -> LookedAt:
    """What the words mean, linted."""

    def linted(targets: list[Target]) -> Iterator[tuple[Target, Linted]]:
        found = lint_all(targets, settings, wanted.selection, wanted.jobs or None, wanted.prepare_to_tell)
        return zip(targets, watched(found, len(targets)), strict=True)

    told_of = wanted.config.robots
    pairs = list(zip(*targets_of(found, arguments, told_of), strict=True))
    if wanted.shard is not None:
        from urdfctl.shards import share

        mine = share(found, wanted.shard, [robot.files for robot in told_of])
        found = found.among(mine)
        pairs = [pair for pair in pairs if os.path.abspath(pair[0].path) in mine]
    launched = [pair for pair in linted([target for target, keep in pairs if keep is _has_controllers]) if _tells(pair)]
    brought = {(one.path, one.arguments) for _, one in launched if one.controllers}
    pairs = [pair for pair in pairs if pair[1] is not _has_controllers and not _is_brought(*pair, brought)]
    looked = zip(linted([target for target, _ in pairs]), pairs, strict=True)
    all_kept = [one for one, (_, keep) in looked if keep(one[1])] + launched
    read = {file for _, one in all_kept for file in one.files}
    all_kept += linted([Target(path) for path in found.controllers if os.path.abspath(path) not in read])
    read |= {os.path.abspath(path) for path in found.controllers}
    alone = [Target(path) for path in found.controllers_candidates if os.path.abspath(path) not in read]
    rest = [Target(path, fragment=True) for path in found.unread(read)]
    robotless = {os.path.abspath(path) for path in found.launch_candidates}
    robots = [one for _, one in all_kept if one.path not in robotless]
    return LookedAt(robots, [*all_kept, *linted([*rest, *alone])])


def targets_of(
    found: Found, arguments: tuple[tuple[str, str], ...], robots: Sequence[ConfiguredRobot] = ()
) -> tuple[list[Target], list[Callable[[Linted], bool]]]:
    """What is to be linted, and of each what tells whether it is worth to be told of. What is named beside a single
    robot belongs to it, and else what the configuration says."""
    descriptions = found.descriptions()
    targets: dict[Target, Callable[[Linted], bool]] = {}
    single = len(descriptions) == 1
    controllers, launches = (tuple(found.controllers), tuple(found.launches)) if single else ((), ())
    for path, named in descriptions:
        for robot in [one for one in robots if os.path.abspath(one.path) == path] or [ConfiguredRobot(path)]:
            for variant, launch in product(robot.variants, launches or robot.launches or (None,)):
                given = tuple({**dict(variant), **dict(arguments)}.items())
                target = Target(path, given, controllers=controllers or robot.controllers, launch=launch)
                targets[target] = _always if named else _is_robot
    if not single:
        targets.update({Target(path, arguments): _always for path in found.launches})
    told = {os.path.abspath(path) for robot in robots for path in robot.launches}
    candidates = (path for path in found.launch_candidates if os.path.abspath(path) not in told)
    targets.update({Target(path): _has_controllers for path in candidates})
    return list(targets), list(targets.values())


def _always(_: Linted) -> bool:
    return True


def _has_controllers(linted: Linted) -> bool:
    return bool(linted.controllers)


def _tells(launched: tuple[Target, Linted]) -> bool:
    """Whether a launch file that is found in a folder has something to do with controllers, or is itself at fault."""
    linted = launched[1]
    return _has_controllers(linted) or any(one.code.startswith("UC6") for one in linted.outcome.diagnostics)


def _is_brought(
    target: Target, keep: Callable[[Linted], bool], brought: Collection[tuple[str, tuple[tuple[str, str], ...]]]
) -> bool:
    """Whether launch files have brought a robot that is found in a folder already, with the same arguments."""
    paired = target.controllers or target.launch
    return keep is _is_robot and not paired and (os.path.abspath(target.path), target.arguments) in brought


def _is_robot(linted: Linted) -> bool:
    """Whether a file found in a folder is a robot: two links or more, whole or at least named; or nothing that could be
    read at all."""
    if linted.links is None:
        return True
    return linted.links > 1 and (linted.complete or linted.robot is not None)
