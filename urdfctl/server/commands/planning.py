"""A package that plans with MoveIt for the robot of the open file, as `urdfctl gen-moveit` writes it."""

from __future__ import annotations

import os
from collections.abc import Sequence

from urdfctl.load.target import Target
from urdfctl.server.analysis.folders import folder_of
from urdfctl.source.workspaces.packages import package_around, package_name

_ENDING = "_moveit"


def output_for(target: Target, folder: str) -> str:
    """Return the folder of the package: beside the package of the robot, or else in the folder that is linted."""
    package = package_around(os.path.dirname(target.path))
    name = package_name(os.path.join(package, "package.xml")) if package else None
    stem = name or os.path.basename(target.path).partition(".")[0]
    beside = os.path.join(os.path.dirname(package) if package else folder, f"{stem}{_ENDING}")
    return beside if folder_of(beside, [folder]) is not None else os.path.join(folder, f"{stem}{_ENDING}")


def words_for_planning(target: Target, output: str, distro: str | None, *, is_there: bool) -> list[str]:
    """Return the words of the command that writes the package.

    distro: None for the one that is detected. is_there: whether the folder has a package, which is written again.
    The names of arguments come from files that may be a stranger's: no word after `--` is an option.
    """
    given = [f"{name}:={value}" for name, value in target.arguments]
    options = ["-o", output, *(["--distro", distro] if distro else []), *(["--force"] if is_there else [])]
    return ["gen-moveit", *options, "--", os.path.abspath(target.path), *given]


def summary_of(problems: Sequence[str]) -> str:
    """Return the line of the command that says what was written; empty if nothing was."""
    lines = (line.removeprefix("urdfctl: ") for line in problems)
    return next((line for line in lines if " written to " in line), "")
