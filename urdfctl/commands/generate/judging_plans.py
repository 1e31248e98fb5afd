"""Lint MoveIt's configuration of a package before it is written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.engine import lint
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import LintedTarget
from urdfctl.load.loader import Loader
from urdfctl.load.moveit_files import moveit_in
from urdfctl.rule import Rule

_ENDINGS = (".srdf", "kinematics.yaml", "joint_limits.yaml", "moveit_controllers.yaml", "_planning.yaml")


def is_of_moveit(name: str) -> bool:
    """Return whether a file is one that MoveIt reads, by its name."""
    return name.endswith(_ENDINGS)


def faults_of_plans(seen: LintedTarget, loader: Loader, paths: Sequence[str]) -> list[Diagnostic]:
    """Return the errors in some files, as if a launch file gave them to MoveIt with a robot that was linted."""
    files, _ = loader.reading(seen.result.path)
    found = moveit_in(paths, files, partial(loader.expander, seen.result.path), seen.project.ros or 2)
    outcome = lint(seen.project._replace(moveit=found), [], Selection(), rules=_rules())
    return [one for one in outcome.diagnostics if one.severity is Severity.ERROR]


def _rules() -> Iterator[Rule]:
    from urdfctl.rules.moveit.family import FAULTS

    return (fault for fault in FAULTS if isinstance(fault, Rule))
