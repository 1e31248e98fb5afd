"""Robots and controller files that belong together by elimination; and descriptions that nobody starts as they are
linted: findings in these are warnings at most."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.discover.backups import is_backup
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target
from urdfctl.model.project import Project
from urdfctl.source.span import SourceText
from urdfctl.source.workspaces.packages import package_around


def pairs_by_elimination(
    robots: Iterable[tuple[Target, TargetResult]], controller_files: Sequence[str]
) -> Iterator[tuple[Target, Target]]:
    """Yield each target to replace, with its replacement: the only robot and the only controller file of a package, or
    of a folder outside of packages.

    robots: those that were linted. controller_files: those that nothing uses.
    """
    by_package: dict[str, list[str]] = {}
    for path in controller_files:
        if not is_backup(path):
            by_package.setdefault(_package_of(path), []).append(path)
    alone: dict[str, dict[str, tuple[Target, TargetResult]]] = {}
    for target, result in robots:
        if result.links:
            alone.setdefault(_package_of(result.path), {})[result.path] = (target, result)
    for package, files in by_package.items():
        of_package = list(alone.get(package, {}).values())
        if len(files) == 1 and len(of_package) == 1:
            target, result = of_package[0]
            has_controllers = result.controllers or result.joining.declared
            if not has_controllers and not target.by_elimination:
                yield target, target._replace(controllers=(files[0],), by_elimination=True)


def shares_joints(project: Project, sources: Mapping[str, SourceText]) -> bool:
    """Return whether a controller file of a project names one of the robot's joints."""
    if project.robot is None or project.controllers is None:
        return False
    names = [re.escape(name.encode()) for name in project.robot.joint_names if name]
    pattern = rb"(?<![\w])(?:%b)(?![\w])" % b"|".join(names)
    texts = (sources[file.path].data for file in project.controllers.files if file.path in sources)
    return bool(names) and any(re.search(pattern, text) for text in texts)


def _package_of(path: str) -> str:
    """The folder of the package that a file is in; its folder if it is in none."""
    folder = os.path.dirname(os.path.abspath(path))
    return package_around(folder) or folder
