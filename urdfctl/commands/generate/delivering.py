"""Write, show or check what a generator made, and say what to know about it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.commands.generate.judging import Judgement
from urdfctl.commands.generate.options import PACKAGES, GenerateOptions
from urdfctl.generate.controllers.cautions import cautions
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.files.next_steps import steps_after
from urdfctl.generate.files.package import around_package, nested_in
from urdfctl.generate.files.writing import Writing, deliver
from urdfctl.generate.options import File, GeneratorOptions
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.output.answer import CommandAnswer
from urdfctl.smoke.engines import installed
from urdfctl.startup.records import NamedTuple


class Made(NamedTuple):
    """Generated files with the options, controllers and robot that they are made from, and the proposal of controllers.

    notices: what the user should know about the choices that were made.
    judgement: what the smoke test says of a package.
    """

    options: GeneratorOptions
    files: list[File]
    controllers: tuple[GeneratedController, ...]
    proposal: str
    robot: RobotFacts | None
    notices: tuple[str, ...]
    judgement: Judgement = Judgement()


def delivered(options: GenerateOptions, made: Made, answer: CommandAnswer) -> int:
    """Write, show or check what was made, and return the exit status."""
    command, output = options.command, options.output
    if not options.check:
        answer.messages(made.notices)
    answer.messages(made.judgement.lines())
    if made.judgement.refusal and output and not options.force:
        answer.message(f"nothing was written, because this robot {made.judgement.refusal}: {_remedy(made)}")
        return 1
    answer.messages(_remarks(options, made))
    writing = Writing(output, options.force, options.diff, options.check, options.into)
    steps = tuple(steps_after(command, made.controllers, made.options, output or "", can_smoke=bool(installed())))
    files = made.files
    if command in PACKAGES and output:
        files, to_add = around_package(files, output)
        steps = (*to_add, *steps)
    return deliver(files, writing, answer, many=command in PACKAGES, steps=steps)


def _remarks(options: GenerateOptions, made: Made) -> Iterator[str]:
    """Yield what to know about the choices that were made for the user, and about the place of the files."""
    command, robot = options.command, made.robot
    if made.proposal and not options.check:
        yield made.proposal
    if command not in PACKAGES:
        return
    if robot and not robot.package and not made.options.robot_text:
        yield f"'{robot.file}' is not in a package, so installed files cannot find it"
    nested = nested_in(options.output) if options.output and not options.check else ""
    if nested:
        yield nested
    if robot and not options.check:
        yield from cautions(made.controllers, robot, made.options)


def _remedy(made: Made) -> str:
    inertial = any("<inertia>" in finding.message for finding in made.judgement.fatal)
    fix = ", add --fix-inertia for the nearest valid inertia in a copy" if inertial else ""
    if made.judgement.fatal and made.robot and made.robot.components:
        return (
            "it has a <ros2_control> already. Name a file of the robot without it, or write only what is missing, by "
            "gen-controllers and gen-launch; --force writes the package all the same"
        )
    return f"correct what is named{fix}, or add --force"
