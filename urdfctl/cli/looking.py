"""Lints what the words of a lint command mean: the robots, and what of their folders no robot uses."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import NamedTuple

from urdfctl.cli.progress import watched
from urdfctl.cli.wanted import Wanted
from urdfctl.discover import Found
from urdfctl.lint import Linted
from urdfctl.load import Target, lint_all
from urdfctl.settings import Settings


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


def look_at(found: Found, arguments: tuple[tuple[str, str], ...], settings: Settings, wanted: Wanted) -> LookedAt:
    """What the words mean, linted."""

    def linted(targets: list[Target]) -> Iterator[tuple[Target, Linted]]:
        found = lint_all(targets, settings, wanted.selection, wanted.jobs or None)
        return zip(targets, watched(found, len(targets)), strict=True)

    targets, kept = targets_of(found, arguments)
    if wanted.shard is not None:
        from urdfctl.shards import share

        mine = share(found, wanted.shard)
        found = found.among(mine)
        pairs = [pair for pair in zip(targets, kept, strict=True) if os.path.abspath(pair[0].path) in mine]
        targets, kept = [target for target, _ in pairs], [keep for _, keep in pairs]
    all_kept = [pair for pair, keep in zip(linted(targets), kept, strict=True) if keep(pair[1])]
    read = {file for _, one in all_kept for file in one.files}
    all_kept += linted([Target(path) for path in found.controllers if os.path.abspath(path) not in read])
    read |= {os.path.abspath(path) for path in found.controllers}
    alone = [Target(path) for path in found.controllers_candidates if os.path.abspath(path) not in read]
    rest = [Target(path, fragment=True) for path in found.unread(read)]
    robotless = {os.path.abspath(path) for path in found.launch_candidates}
    robots = [one for _, one in all_kept if one.path not in robotless]
    return LookedAt(robots, [*all_kept, *linted([*rest, *alone])])


def targets_of(
    found: Found, arguments: tuple[tuple[str, str], ...]
) -> tuple[list[Target], list[Callable[[Linted], bool]]]:
    """What is to be linted, and of each what tells whether it is worth to be told of. What is named beside a single
    robot belongs to it."""
    descriptions = found.descriptions()
    targets: list[Target] = []
    kept: list[Callable[[Linted], bool]] = []
    single = len(descriptions) == 1
    controllers = tuple(found.controllers) if single else ()
    for path, named in descriptions:
        for launch in (found.launches if single else ()) or (None,):
            targets.append(Target(path, arguments, controllers=controllers, launch=launch))
            kept.append(_always if named else _is_robot)
    if not single:
        targets += [Target(path, arguments) for path in found.launches]
        kept += [_always] * len(found.launches)
    targets += [Target(path) for path in found.launch_candidates]
    kept += [_has_controllers] * len(found.launch_candidates)
    return targets, kept


def _always(_: Linted) -> bool:
    return True


def _has_controllers(linted: Linted) -> bool:
    return bool(linted.controllers)


def _is_robot(linted: Linted) -> bool:
    """Whether a file found in a folder is a robot: two links or more, whole or at least named; or nothing that could be
    read at all."""
    if linted.links is None:
        return True
    return linted.links > 1 and (linted.complete or linted.robot is not None)
