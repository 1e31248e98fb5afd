"""What `gen-moveit` asks more of a robot than the other generators do."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.catalog.catalog import Catalog
from urdfctl.commands.generate.measuring import measure_links
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.words import split_arguments
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.generate.files.hardware import hosted_file, simulates, unplanned
from urdfctl.generate.files.planned_controllers import has_planned
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.generate.robot.job import measure_robot

_WITHOUT = "none"
_MASSLESS = "no link of the robot has an <inertial>, without which the simulator drops it"


def plans(options: GenerateOptions) -> bool:
    """Return whether a planner is configured."""
    return options.command == "gen-moveit" or options.moveit


def with_tested_links(robot: RobotFacts, options: GenerateOptions, settings: Settings) -> RobotFacts:
    """Return a robot with the pairs of its links that need no test for collisions. UserError if they are not known."""
    poses = {"samples": options.samples, "seed": options.seed}
    _, arguments = split_arguments(options.words)
    measured = measure_robot(robot.file or "", arguments, settings, measure_links, poses)
    if measured.facts is None:
        why = next((problem.message.rpartition(": ")[2] for problem in measured.problems), "the worker ended")
        raise UserError(f"the links cannot be tested for collisions: {why}; use fewer --samples, or a longer --timeout")
    return robot._replace(linkage=measured.facts.linkage)


def started(
    robot: RobotFacts | None,
    requested: Callable[[str], GeneratorOptions],
    simulator: str,
    catalog: Catalog,
    *,
    asked: GenerateOptions,
    is_set: bool,
) -> tuple[GeneratorOptions, list[str]]:
    """Return the options with which a robot is started, and what to say of it: of one that a planner starts.

    A simulator's plugin that loads controllers of its own, or runs them in a namespace, is not started if no hardware
    of the robot needs the simulator: the demo of MoveIt needs none, and a robot without hardware gets mock hardware. So
    it is with a robot without any mass, which a simulator drops.
    Otherwise a planner uses the plugin's controllers, unless the user asks for other ones.

    requested: returns the options for a simulator.
    is_set: whether an option or the configuration sets the simulator.
    """
    options = requested(simulator)
    if robot is None or not plans(asked):
        return options, []
    others = unplanned(robot, options, catalog)
    why = others or (_MASSLESS if options.simulated and not _has_mass(robot) else "")
    if why and not (is_set or simulates(robot, options.distro, catalog)):
        return requested(_WITHOUT), [f"written for {_hardware(robot, options)}, without a simulator: {why}"]
    own = options._replace(own=True)
    if others and has_planned(robot) and not (asked.types or asked.controller or unplanned(robot, own, catalog)):
        told = f"MoveIt uses the controllers of '{hosted_file(robot)}', which the simulator's plugin in the robot loads"
        return own, [told]
    return options, []


def _has_mass(robot: RobotFacts) -> bool:
    return any(joint.inertia for joint in robot.joints) or not robot.joints


def _hardware(robot: RobotFacts, options: GeneratorOptions) -> str:
    if options.ros == 1:
        return "MoveIt's fake controllers"
    return "the hardware in the robot" if robot.plugins else "mock hardware"
