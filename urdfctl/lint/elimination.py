"""Robots and controller files that belong together by elimination, and descriptions that nobody starts as they are
linted: a weak link, so findings are warnings at most."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.diagnostic import Diagnostic, Remark, Severity
from urdfctl.lint.planning import PlannedTarget, TargetOrigin
from urdfctl.lint.results import Outcome, TargetResult
from urdfctl.load.target import Target
from urdfctl.model.project import Project
from urdfctl.source.span import SourceText
from urdfctl.source.workspaces.packages import package_around


def pairs_by_elimination(
    robots: Iterable[tuple[Target, TargetResult]], controller_files: Sequence[str]
) -> Iterator[tuple[Target, Target]]:
    """Yield each target to replace, with its replacement: the only robot and the only controller file of a package.

    robots: those that were linted. controller_files: those that nothing uses.
    """
    by_package: dict[str, list[str]] = {}
    for path in controller_files:
        by_package.setdefault(_package_of(path), []).append(path)
    alone: dict[str, dict[str, tuple[Target, TargetResult]]] = {}
    for target, result in robots:
        if result.links:
            alone.setdefault(_package_of(result.path), {})[result.path] = (target, result)
    for package, files in by_package.items():
        of_package = list(alone.get(package, {}).values())
        if package and len(files) == 1 and len(of_package) == 1:
            target, result = of_package[0]
            if not result.controllers and not target.by_elimination:
                yield target, target._replace(controllers=(files[0],), by_elimination=True)


def shares_joints(project: Project, sources: Mapping[str, SourceText]) -> bool:
    """Return whether a controller file of a project names one of the robot's joints."""
    if project.robot is None or project.controllers is None:
        return False
    names = [re.escape(name.encode()) for name in project.robot.joint_names if name]
    pattern = rb"(?<![\w])(?:%b)(?![\w])" % b"|".join(names)
    texts = (sources[file.path].data for file in project.controllers.files if file.path in sources)
    return bool(names) and any(re.search(pattern, text) for text in texts)


GUESSED = "the launch file needs arguments; their values are guessed from the files that exist"
UNSTARTED = "only without xacro arguments; every launch file that starts this robot gives it some"
OF_PROSE = "only in the distro that the prose of a README names; set `distro` in urdfctl.toml if it is right"
_ELIMINATED = "no file says that this robot and controller file belong together; the package has no others"


def weakened(together: Outcome, apart: Iterable[Outcome], why: str = _ELIMINATED) -> Outcome:
    """Return an outcome in which what its parts do not show apart is a warning at most, with a note that says why."""
    known = {_key(diagnostic) for outcome in apart for diagnostic in outcome.diagnostics}
    return together._replace(
        diagnostics=[
            diagnostic if _key(diagnostic) in known else _weakened(diagnostic, why)
            for diagnostic in together.diagnostics
        ]
    )


def is_weakened(diagnostic: Diagnostic) -> bool:
    """Return whether `weakened` made a diagnostic less severe."""
    return any(note.message in (GUESSED, UNSTARTED, OF_PROSE, _ELIMINATED) for note in diagnostic.notes)


def _weakened(diagnostic: Diagnostic, why: str) -> Diagnostic:
    note = Remark(why)
    severity = Severity.WARNING if diagnostic.severity is Severity.ERROR else diagnostic.severity
    return diagnostic._replace(severity=severity, notes=(*diagnostic.notes, note))


def _key(diagnostic: Diagnostic) -> tuple[str, str, int, int]:
    return diagnostic.code, diagnostic.at.file, diagnostic.at.start, diagnostic.at.end


def _package_of(path: str) -> str:
    """The folder of the package that a file is in; empty if it is in none."""
    return package_around(os.path.dirname(os.path.abspath(path))) or ""


def as_started(entry: PlannedTarget, result: TargetResult, launched: Iterable[TargetResult]) -> TargetResult:
    """Return the result of a description; its own findings are warnings at most if nobody starts it like that.

    This is so for a description in a folder that is linted with the defaults of its arguments, if all launch files that
    start it give it arguments. What is found there too keeps its severity.
    """
    starts = [each for each in launched if each.path == result.path] if _is_with_defaults(entry) else []
    if not starts or not all(each.arguments for each in starts):
        return result
    return result._replace(outcome=weakened(result.outcome, [each.outcome for each in starts], UNSTARTED))


def _is_with_defaults(entry: PlannedTarget) -> bool:
    target = entry.target
    settings: Sequence[object] = (target.arguments, target.controllers, target.launch)
    return entry.origin is TargetOrigin.FOUND and not any(settings)
