"""`urdfctl diff`: what changed between two robots."""

from __future__ import annotations

import os
from collections.abc import Sequence

from urdfctl.commands.declaring import EXIT, OUTPUT, Command, argument, option
from urdfctl.commands.options import FORMAT, ReadingOptions
from urdfctl.commands.robot_targets import Pair, best_of, robots_of
from urdfctl.commands.words import configured, output_of, settings_from, split_arguments
from urdfctl.compare.changes import AREAS, changes
from urdfctl.compare.reports import FORMATS, ComparedRobot, Comparison, rendered
from urdfctl.compare.sides import Side, sides_of
from urdfctl.compare.snapshot import Snapshot, snapshots
from urdfctl.discover.paths import check_path
from urdfctl.errors import UserError
from urdfctl.load.target import Target
from urdfctl.names import did_you_mean, enumerated
from urdfctl.output.printing import print_text
from urdfctl.output.writing import write_file

_ANY = "any"


class DiffOptions(ReadingOptions):
    """Show what changed between two robots: their models, not their text. Order, blanks and macros are no difference.

    \b
    Example: urdfctl diff urdf/robot.xacro reach:=0.5 urdf/robot.xacro reach:=0.6
             urdfctl diff HEAD: urdf/robot.xacro --format markdown
    """

    words: tuple[str, ...] = argument(
        "Two files, folders, or git revisions with a path (HEAD~1:urdf/robot.xacro; HEAD~1: takes the path of the "
        "other side), each with its name:=value arguments.",
        metavar="A [NAME:=VALUE]... B [NAME:=VALUE]...",
        is_required=True,
    )
    formats: tuple[str, ...] = option(OUTPUT, FORMAT, "--format", choices=FORMATS)
    areas: str | None = option(
        EXIT,
        "Exit with status 1 on changes in these areas, e.g. limits,joints,interfaces; or any.",
        "--fail-on",
        metavar="AREA,...",
    )


def run_diff(options: DiffOptions) -> int:
    """Print what changed, and return the exit status: 1 if --fail-on names an area with a change, otherwise 0."""
    outputs = [output_of(text, FORMATS) for text in options.formats or ("text",)]
    areas = _areas(options.areas)
    for word in options.words:
        if os.path.lexists(word):
            check_path(word)
    with sides_of(options.words, options.workspace) as (before, after):
        comparison = _compared(before, after, options)
    for name, file in outputs:
        text = rendered(comparison, name)
        if file is not None:
            write_file(file, text, force=True)
        else:
            print_text(text)
    found = {change.area for robot in comparison.robots for change in robot.changes}
    return int(bool(found & areas))


def _areas(named: str | None) -> set[str]:
    """The areas that --fail-on names. UserError if there is no such area."""
    names = [name.strip() for name in (named or "").split(",") if name.strip()]
    for name in names:
        if name not in {*AREAS, _ANY}:
            known = f"{did_you_mean(name, AREAS)}; known are {enumerated(AREAS)}, or {_ANY}"
            raise UserError(f"unknown area '{name}' in --fail-on{known}")
    return set(AREAS) if _ANY in names else set(names)


def _compared(before: Side, after: Side, options: ReadingOptions) -> Comparison:
    if os.path.isdir(before.path) != os.path.isdir(after.path):
        raise UserError(f"'{before.word}' and '{after.word}' must both be files, or both be folders")
    old, new = _robots(before, options), _robots(after, options)
    if len(old) == len(new) == 1:
        [name] = new
        old = {name: old.popitem()[1]}
    common = [name for name in new if name in old]
    one, other = [
        _taken(side, [robots[name] for name in common], options) for side, robots in ((before, old), (after, new))
    ]
    robots = [
        ComparedRobot(name, changes(left.node, right.node), left.complete and right.complete)
        for name, left, right in zip(common, one, other, strict=True)
    ]
    gone, come = [name for name in old if name not in new], [name for name in new if name not in old]
    return Comparison(before.shown, after.shown, robots, gone, come)


def _taken(side: Side, targets: Sequence[Target], options: ReadingOptions) -> list[Snapshot]:
    settings = settings_from(configured([side.path], options), options)
    if side.is_laid_out:
        settings = settings._replace(workspace=side.roots[-1])
    return snapshots(list(targets), settings, side.roots)


def _robots(side: Side, options: ReadingOptions) -> dict[str, Target]:
    """The robots of one side by name: their path in the folder, and their arguments."""
    config = configured([side.path], options)
    settings = settings_from(config, options)
    if side.is_laid_out:
        settings = settings._replace(workspace=side.roots[-1])
    pairs = robots_of([side.path, *side.arguments], config, settings)
    if not os.path.isdir(side.path):
        found = best_of(pairs)
        given = tuple(split_arguments(side.arguments)[1].items())
        return {os.path.basename(side.path): found[0] if found else Target(side.path, given)}
    groups: dict[str, list[Pair]] = {}
    for pair in pairs:
        words = [f"{name}:={value}" for name, value in pair[1].arguments]
        name = " ".join([os.path.relpath(pair[1].path, side.path).replace(os.sep, "/"), *words])
        groups.setdefault(name, []).append(pair)
    if not groups:
        raise UserError(f"no robot in '{side.word}'")
    return {name: best[0] for name, group in sorted(groups.items()) if (best := best_of(group)) is not None}


command = Command(DiffOptions, run_diff)
