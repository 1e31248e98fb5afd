"""Reads one robot in a limited worker, and gives what the generators need to know of it."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfctl.diagnostic import Diagnostic
from urdfctl.evidence import judged
from urdfctl.generate.facts import RobotFacts
from urdfctl.generate.survey import facts_of
from urdfctl.hints import Any
from urdfctl.jobs import dead
from urdfctl.lint import Selection, lint
from urdfctl.load import Loader, Target, expansion_of
from urdfctl.model.build_robot import robot_of
from urdfctl.model.project import Project
from urdfctl.record import NamedTuple
from urdfctl.serialise import outcome_from_json, outcome_to_json
from urdfctl.settings import Settings
from urdfctl.source.packages import package_name
from urdfctl.worker import Limits, run


class Read(NamedTuple):
    """A robot's facts, None where it cannot be read; then the problems say why."""

    facts: RobotFacts | None
    problems: tuple[Diagnostic, ...]
    crashed: bool = False


def facts_from(path: str, arguments: Mapping[str, str], settings: Settings) -> Read:
    """The facts of the robot in a file."""
    limits = Limits(settings.timeout, settings.memory, settings.environ)
    job = {"path": path, "arguments": dict(arguments), "settings": settings.to_json()}
    result = next(iter(run([job], perform, limits, 1, fresh="urdfctl.measure:perform")))
    if not isinstance(result, dict):
        outcome = dead(Target(path, tuple(arguments.items())), settings, result).outcome
        return Read(None, tuple(outcome.diagnostics), outcome.crashed)
    outcome = outcome_from_json(result["outcome"])
    return Read(RobotFacts.from_json(result["facts"]) if result["facts"] else None, tuple(outcome.diagnostics))


def perform(job: dict[str, Any]) -> dict[str, Any]:
    """Measure the robot of a job that came as JSON."""
    path, settings = os.path.abspath(job["path"]), Settings.from_json(job["settings"])
    expander = Loader(settings, Selection()).expander(path)
    expansion = expansion_of(expander, path, job["arguments"])
    root = expansion.document.documentElement if expansion.document is not None else None
    outcome = lint(Project(None, path, problems=tuple(expansion.problems), complete=False), [], Selection(("UC0",)))
    if root is None:
        return {"facts": None, "outcome": outcome_to_json(outcome)}
    robot = robot_of(root, whole=expansion.complete)
    folder = expander.packages.own()
    evidence = judged(robot, folder, settings)
    facts = facts_of(robot)._replace(
        file=job["path"],
        package=package_name(os.path.join(folder, "package.xml")) if folder else None,
        package_path=os.path.relpath(path, folder).replace(os.sep, "/") if folder else None,
        distro=evidence.distro,
        ros=evidence.ros,
        simulator=evidence.simulator,
    )
    return {"facts": facts.to_json(), "outcome": outcome_to_json(outcome)}
