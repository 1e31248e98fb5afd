"""Read one robot in a limited worker, and return what the generators need to know about it."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.generate.robot.facts import Linkage, RobotFacts
from urdfctl.generate.robot.mjcf_bodies import SurfaceOf, skeleton_of
from urdfctl.generate.robot.own_controllers import own_controllers, own_file
from urdfctl.generate.robot.sdf_bodies import sdf_of
from urdfctl.generate.robot.survey import facts_of
from urdfctl.lint.engine import lint
from urdfctl.lint.job import Work, WorkFunction, run_on_one
from urdfctl.lint.selection import Selection
from urdfctl.lint.serialising import outcome_to_json
from urdfctl.load.expansion.description import expansion_of
from urdfctl.load.meshes import mesh_path
from urdfctl.load.origin.distro import Beside, detect_distro
from urdfctl.load.target import Target
from urdfctl.model.geometry import Vector
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.source.workspaces.packages import package_name
from urdfctl.source.xacro.expanded import HARMLESS, Expansion
from urdfctl.startup.records import NamedTuple


class MeasuredRobot(NamedTuple):
    """A robot as the generators see it.

    facts: None if the robot cannot be read.
    problems: why not, or what else was found while reading it.
    crashed: True if urdfctl itself failed.
    """

    facts: RobotFacts | None
    problems: tuple[Diagnostic, ...]
    crashed: bool = False


Linked = Callable[[Robot, Callable[[str], str | None]], Linkage]
"""Returns the links of a robot, given a function that finds its meshes. Raises UserError if they cannot be tested."""


def measure_robot(
    path: str,
    arguments: Mapping[str, str],
    settings: Settings,
    measure: WorkFunction,
    details: Mapping[str, int] | None = None,
) -> MeasuredRobot:
    """Return the facts of the robot in a file. `measure` gives them in a worker, which gets the details.

    Raises UserError if the robot does not have what was asked for.
    """
    target = Target(path, tuple(arguments.items()))
    result, outcome = run_on_one(measure, target, settings, dict(details or {}))
    if result is None:
        return MeasuredRobot(None, tuple(outcome.diagnostics), outcome.crashed)
    if result.get("refused"):
        raise UserError(result["refused"])
    facts = RobotFacts.from_json(result["facts"]) if result["facts"] else None
    return MeasuredRobot(facts, tuple(outcome.diagnostics))


def measured_facts(
    work: Work,
    corners_of: Callable[[str], Sequence[Vector]],
    linked: Linked | None = None,
    surface_of: SurfaceOf | None = None,
) -> dict[str, Any]:
    """Return the facts of a robot as plain data.

    corners_of: returns corners of the mesh in a file. surface_of: reads what MuJoCo does not.
    """
    path = os.path.abspath(work.target.path)
    expander = work.loader.expander(path)
    expansion = expansion_of(expander, path, dict(work.target.arguments))
    root = expansion.document.documentElement if expansion.document is not None else None
    outcome = lint(Project(None, path, problems=tuple(expansion.problems), complete=False), [], Selection(("UC0",)))
    if root is None:
        return {"facts": None, "outcome": outcome_to_json(outcome)}
    robot = robot_of(root, whole=expansion.complete)
    folder = expander.packages.own()
    evidence = detect_distro(robot, Beside(folder), work.loader.settings)
    find = partial(mesh_path, packages=expander.packages, robot_file=path)
    facts = facts_of(robot, lambda address: corners_of(found) if (found := find(address)) else ())._replace(
        file=work.target.path,
        package=package_name(os.path.join(folder, "package.xml")) if folder else None,
        package_path=os.path.relpath(path, folder).replace(os.sep, "/") if folder else None,
        distro=evidence.distro,
        distros=evidence.distros,
        arguments={name: node.attrs.get("default", "") for name, node in expander.declared.items()},
        ros=evidence.ros,
        simulator=evidence.simulator,
    )
    if (work.loader.settings.simulator or evidence.simulator) == "mujoco":
        facts = facts._replace(skeleton=skeleton_of(robot, facts.joints, find, surface_of))
    if work.details.get("sdf"):
        facts = facts._replace(skeleton=sdf_of(robot, facts.joints))
    if linked is not None:
        try:
            facts = facts._replace(linkage=linked(_whole(robot, expansion), find))
            own = tuple(own_controllers(robot, expander.files))
            facts = facts._replace(own=own, own_file=own_file(facts.hosted) if own else None)
        except UserError as error:
            return {"facts": None, "refused": str(error), "outcome": outcome_to_json(outcome)}
    return {"facts": facts.to_json(), "outcome": outcome_to_json(outcome)}


def _whole(robot: Robot, expansion: Expansion) -> Robot:
    """A robot that is expanded completely. UserError that says why if it is not."""
    if expansion.complete:
        return robot
    why = next((problem for problem in expansion.problems if problem.kind not in HARMLESS), None)
    told = "a part of it is unknown"
    if why:
        at = why.at.span
        told = f"{os.path.relpath(at.file)}:{at.source.position(at.start).line}: {why.message}"
    raise UserError(f"MoveIt needs a whole robot, and this one cannot be expanded: {told}")
