"""`urdfctl gen-...`: read the robot and the options, then generate the files."""

from __future__ import annotations

import os
import re
import shlex
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from urdfctl.catalog.catalog import catalog_with
from urdfctl.commands.answering import answered
from urdfctl.commands.declaring import Option
from urdfctl.commands.generate.delivering import Made, delivered
from urdfctl.commands.generate.judging import RATES, judged, with_motion
from urdfctl.commands.generate.measuring import measure_tree, measure_work
from urdfctl.commands.generate.model_check import loaded_model
from urdfctl.commands.generate.options import PACKAGES, GenerateOptions
from urdfctl.commands.generate.planning import plans, started, with_tested_links
from urdfctl.commands.robot_targets import best_of, robots_of
from urdfctl.commands.words import configured, contradictions, settings_from, split_arguments
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.discover.paths import check_description
from urdfctl.errors import UserError
from urdfctl.generate.controllers.wanted import needs_joints, way_out, with_requests
from urdfctl.generate.everything import Order, files
from urdfctl.generate.files.again import words_of_generated_file
from urdfctl.generate.files.bringup import plain_name
from urdfctl.generate.files.package import check_other_package
from urdfctl.generate.options import GeneratorOptions, Roles
from urdfctl.generate.request.choice import chosen, stuck
from urdfctl.generate.request.joint_list import joints_listed
from urdfctl.generate.robot.distro import known_distro, made_for_newest, simulator_of
from urdfctl.generate.robot.facts import NO_ROBOT, JointFacts, RobotFacts
from urdfctl.generate.robot.inertia_repair import with_valid_inertia
from urdfctl.generate.robot.job import measure_robot
from urdfctl.generate.text.scalars import xacro_text
from urdfctl.generate.text.templates import Templates, template_names
from urdfctl.lint.planning import discovered
from urdfctl.lint.results import Report
from urdfctl.output.answer import CommandAnswer
from urdfctl.output.journal import restore_unfinished
from urdfctl.output.links import check_output
from urdfctl.report.common import relative
from urdfctl.report.json_report import finding
from urdfctl.report.text import render
from urdfctl.source.disk.files import MAX_BYTES, named_bytes
from urdfctl.source.disk.gate import admit, admits
from urdfctl.source.workspaces.packages import package_name
from urdfctl.source.workspaces.workspace import workspace_of

_LISTS = (".txt", ".csv", ".tsv", ".yaml", ".yml", ".json", ".list")
_NOT_REPEATED = frozenset(
    {
        "words",
        "output",
        "force",
        "diff",
        "check",
        "into",
        "timeout",
        "memory",
        "distro",
        "simulator",
        "list_templates",
        "trust",
        "output_format",
    }
)
_OWN_NAMES = ("robot.urdf.xacro", "control.xacro")
_ANY_DISTRO = "rolling"
"""For what does not depend on the distro."""
_PARTS = ("gen-transmissions", "gen-ros2-control", "gen-gazebo")


class UnreadableRobot(Exception):
    """The robot cannot be read. The message contains its problems.

    findings: these, as in the JSON of lint.
    """

    def __init__(self, text: str, findings: Sequence[dict[str, Any]] = ()) -> None:
        super().__init__(text)
        self.findings = list(findings)


def run_generate(options: GenerateOptions) -> int:
    """Generate files; write, show or check them; and return the exit status."""
    return answered(options.command, options, lambda answer: generate(options, answer))


def generate(options: GenerateOptions, answer: CommandAnswer) -> int:
    """Generate files, say in an answer what was made, and return the exit status."""
    check_output(options.output, options.into)
    if options.list_templates:
        answer.text("".join(f"{name}\n" for name in template_names(options.templates)))
        return 0
    if options.output and not (options.check or options.diff):
        answer.messages(restore_unfinished())
    try:
        made = generated(options)
    except UnreadableRobot as error:
        if not answer.is_kept:
            sys.stderr.write(str(error))
        answer.add(findings=error.findings)
        return 1
    return delivered(options, made, answer)


def generated(options: GenerateOptions) -> Made:
    """Return the files that a command generates. Raises UserError for bad options, UnreadableRobot."""
    command = options.command
    admit(workspace_of(os.path.abspath("robot"), options.workspace))  # the configuration of the current folder counts
    config = configured([], options)
    settings = settings_from(config, options, distro=options.distro, simulator=options.simulator)
    if command == "convert":
        settings = settings._replace(simulator="gz" if options.to == "sdf" else "mujoco")
    robot, listed = _sources(options, settings, config)
    words = list(options.words)
    if robot and robot.file and not split_arguments(words)[0]:  # the generated files may hide it next time
        words = [os.path.relpath(robot.file), *words]
    joints = chosen(robot, listed, options.joints, options.exclude)
    notices = () if options.check else tuple(contradictions(config, options.distro))
    if robot:
        notices += tuple(_about(robot, joints, options, is_listed=bool(listed)))
    catalog, templates = catalog_with(settings.additions), Templates(options.templates)

    def make(distro: str, options: GenerateOptions = options) -> Made:
        simulator = settings.simulator or (robot.simulator if robot else None) or simulator_of(distro, command, catalog)

        def request(simulator: str) -> GeneratorOptions:
            return _requested(options, words, robot, distro, simulator)

        is_set = settings.simulator is not None
        requested, told = started(robot, request, simulator, catalog, asked=options, is_set=is_set)
        requested, proposal = with_requests(requested, command, options.controller, joints, robot)
        is_rigid = command == "gen-gazebo" or (command == "convert" and robot is not None)  # it needs no joint
        if not (joints or is_rigid) and needs_joints(requested, catalog):
            raise UserError(_no_joints(robot))
        order = Order(
            joints=joints,
            options=requested,
            catalog=catalog,
            robot=robot or NO_ROBOT,
            templates=templates,
            told=told,
        )
        try:
            made_files = files(command, order)
        except UserError as error:
            raise UserError(f"{error}{way_out(requested, proposal)}") from None
        return Made(
            options=requested,
            files=made_files,
            controllers=order.made_if_typed(),
            proposal=proposal,
            robot=robot,
            notices=(*notices, *dict.fromkeys(told)),
        )

    distro, chosen_distro = _ANY_DISTRO if command == "convert" else known_distro(settings, robot), ""
    if distro:
        made = make(distro)
    else:
        made, chosen_distro = made_for_newest(robot, make)
    if robot and plans(options):  # only now: what is asked wrongly is told without MuJoCo, and at once
        robot = with_tested_links(robot, options, settings)
        made = make(made.options.distro)
    made = made._replace(notices=(*made.notices, *filter(None, [chosen_distro])))
    if command == "convert" and not options.check:
        return _loaded(made, options, settings)
    if command not in PACKAGES or options.check or robot is None or listed:
        return made
    return _judged(made, options, settings, lambda faster: make(made.options.distro, faster))


def _about(
    robot: RobotFacts, joints: Sequence[JointFacts], options: GenerateOptions, *, is_listed: bool
) -> Iterator[str]:
    """What is left out or changed of a robot."""
    immovable = () if is_listed or options.joints else stuck(robot, joints)
    if immovable:
        yield f"left out because their limits allow no motion: {', '.join(immovable)}. Include them with --joint"
    if options.fix_inertia and robot.file:
        yield from with_valid_inertia(_text(robot.file)).changes


def _loaded(made: Made, options: GenerateOptions, settings: Settings) -> Made:
    """A model without what MuJoCo does not load. UnreadableRobot if it does not load at all."""
    skeleton = made.robot.skeleton if made.robot else None
    notes = skeleton.notes if skeleton else ()
    if options.to == "sdf":
        return made._replace(notices=(*made.notices, *notes))
    model = loaded_model(made.files[0], options.output, settings)
    if model.fault:
        raise UnreadableRobot(f"urdfctl: MuJoCo does not load the model, which is not written: {model.fault}\n")
    notices = (*made.notices, *notes, *model.left_out)
    return made._replace(files=[model.file], notices=notices)


def _judged(made: Made, options: GenerateOptions, settings: Settings, make: Callable[[GenerateOptions], Made]) -> Made:
    """A package with what the smoke test says of it; made again for a higher update rate if its gains need one."""
    asked = settings._replace(distro=made.options.distro, simulator=made.options.simulator)
    judgement = judged(made.files, made.robot or NO_ROBOT, asked, repaired=options.fix_inertia)
    for rate in RATES if judgement.gains and not judgement.fatal and options.rate is None else ():
        faster = make(options.changed(rate=rate))
        tried = judged(faster.files, faster.robot or NO_ROBOT, asked, repaired=options.fix_inertia)
        if not tried.gains:
            made, judgement = faster._replace(notices=made.notices), tried
            break
    return made._replace(judgement=with_motion(judgement, made.robot or NO_ROBOT, asked))


def _no_joints(robot: RobotFacts | None) -> str:
    if robot is None:
        return "no joints: name a robot, a list of joints, or --joint NAME,NAME"
    excluded = ", or is excluded" if robot.joints else ""
    return f"the robot has no joint to control: each is fixed or mimics another{excluded}"


def _sources(
    options: GenerateOptions, settings: Settings, config: Config
) -> tuple[RobotFacts | None, list[JointFacts]]:
    """Return the robot, or None, and the listed joints."""
    paths, arguments = split_arguments(options.words)
    listed = [JointFacts(name) for name in _split(options.joint)]
    lists = [path for path in paths if path == "-" or path.endswith(_LISTS)]
    robots = [path for path in paths if path not in lists]
    for path in paths:
        if path != "-" and not admits(path):  # the words may be those of a generated file
            raise UserError(f"'{path}' is outside the workspace")
    for path in lists:
        listed += joints_listed(_text(path), "standard input" if path == "-" else path)
    if not robots and (listed or lists):
        return None, listed
    for path in robots:
        check_description(path)
    found = discovered(robots, config)
    descriptions = [path for path, _ in found.descriptions() if robots or not _is_part(path)]
    if len(descriptions) != 1:
        shown = ", ".join(sorted(os.path.relpath(path) for path in descriptions))
        raise UserError(
            f"several robots found: {shown}" if descriptions else "no robot found; name one, or a list of joints"
        )
    path = robots[0] if robots and not os.path.isdir(robots[0]) else os.path.relpath(descriptions[0])
    details = {"sdf": 1} if options.command == "convert" and options.to == "sdf" else None
    measured = measure_robot(path, arguments, settings, measure_tree if plans(options) else measure_work, details)
    if measured.facts is None or (options.command == "convert" and _has_errors(measured.problems)):
        text = "\n".join(render(Report((), measured.problems)).splitlines()[:-1]) + "\n"
        raise UnreadableRobot(text, [finding(relative(problem)) for problem in measured.problems])
    facts = measured.facts
    if known_distro(settings, facts) is None:
        facts = facts._replace(distro=_started_for(path, arguments, settings, config))
    return facts, listed


def _has_errors(problems: Iterable[Diagnostic]) -> bool:
    return any(problem.severity is Severity.ERROR for problem in problems)


def _started_for(path: str, arguments: Mapping[str, str], settings: Settings, config: Config) -> str | None:
    """The distro that lint detects from what is started with the robot, which generators do not read."""
    words = [path, *(f"{name}:={value}" for name, value in arguments.items())]
    found = best_of(robots_of(words, config, settings))
    return found[1].distro if found else None


def _is_part(path: str) -> bool:
    """Return whether a file was generated to be included by a robot."""
    made_by = (words_of_generated_file(path) or ("",))[0]
    return made_by in _PARTS or (made_by in PACKAGES and os.path.basename(path) == "control.xacro")


def _text(path: str) -> str:
    try:
        if path == "-":
            data = sys.stdin.buffer.read(MAX_BYTES + 1)
            if len(data) > MAX_BYTES:
                raise UserError(f"standard input cannot be read: it is larger than {MAX_BYTES >> 20} MiB")
            return data.decode("utf-8-sig")
        return named_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError:
        raise UserError(f"'{path}' cannot be read: it is not UTF-8") from None


def _requested(
    options: GenerateOptions, words: Sequence[str], robot: RobotFacts | None, distro: str, simulator: str
) -> GeneratorOptions:
    """What the options ask for, with what follows from the robot. words: those of a command that names the robot."""
    defaults = GeneratorOptions(distro)
    package, copied = _package(options, robot), _copied(options, robot)
    states = None if not options.state else tuple(name for name in _split([options.state]) if name != "none")
    return GeneratorOptions(
        distro=distro,
        simulator=simulator,
        types=tuple(_split(options.types)),
        interfaces=tuple(_split([options.interface or options.command_interface or ""])),
        states=states,
        hardware=options.hardware,
        group=options.group,
        namespace=(options.namespace or "").strip("/"),
        name=options.name,
        roles=Roles(
            *(tuple(_split(side)) for side in (options.left, options.right, options.traction, options.steering))
        ),
        sensor=options.sensor,
        frame=options.frame,
        broadcaster=options.broadcaster,
        rate=options.rate,
        package=package,
        controllers_file=options.controllers or defaults.controllers_file,
        description=robot.package_path if robot else None,
        robot_file=f"$(find {package})/{copied[0]}" if copied else _included(options.output, robot),
        robot_text=copied,
        model_path=options.output if options.command == "convert" else None,
        to=options.to,
        arguments=tuple(split_arguments(words)[1].items()),
        macro=options.macro,
        form=options.form or defaults.form,
        chain=options.chain,
        base=options.base,
        moveit=plans(options),
        planning_groups=options.planning_groups,
        output=options.output if options.command in PACKAGES else None,
        launch=plain_name(options.output) if options.command == "gen-launch" else None,
        command=_repeatable_command(options, words, distro, simulator),
    )


def _package(options: GenerateOptions, robot: RobotFacts | None) -> str | None:
    """Return the package that the files will be in: the one that gen-all writes, or the robot's."""
    if options.package:
        return options.package
    if options.command not in PACKAGES or options.output is None:
        return robot.package if robot else None
    manifest = os.path.join(options.output, "package.xml")
    folder = os.path.basename(os.path.abspath(options.output))
    name = package_name(manifest) or re.sub(r"[^a-z0-9_]+", "_", folder.lower()).strip("_") or "my_robot_control"
    check_other_package(name, options.output, robot or NO_ROBOT)
    return name


def _included(output: str | None, robot: RobotFacts | None) -> str:
    """Return how a file in the folder `urdf` of the output includes the robot."""
    if robot is None or robot.file is None:
        return "robot.urdf"
    if robot.package:
        return f"$(find {robot.package})/{xacro_text(robot.package_path)}"
    return xacro_text(os.path.relpath(robot.file, os.path.join(output or "", "urdf")).replace(os.sep, "/"))


def _copied(options: GenerateOptions, robot: RobotFacts | None) -> tuple[str, str] | None:
    """Return the path and text of a robot's copy in the package: of one that is in no package and includes no files.

    With `--fix-inertia` it is a copy with the nearest valid inertia. UserError if that is not given in numbers there.
    """
    repairs = options.command == "gen-all" and options.fix_inertia
    if options.command not in PACKAGES or robot is None or robot.file is None or (robot.package and not repairs):
        return None
    text = _text(robot.file)
    if repairs:
        repair = with_valid_inertia(text)
        if not repair.changes:
            raise UserError(f"--fix-inertia: no inertia in '{robot.file}' is given in numbers and impossible")
        text = repair.text
    elif "xacro:include" in text:
        return None
    name = os.path.basename(robot.file)
    return f"urdf/{'base_' if name in _OWN_NAMES else ''}{name}", text


def _split(given: Iterable[str]) -> list[str]:
    return [name.strip() for item in given for name in item.split(",") if name.strip()]


def _repeatable_command(options: GenerateOptions, words: Sequence[str], distro: str, simulator: str) -> str:
    """Return the command that generates the same files: with the detected distro and simulator."""
    repeated = ["urdfctl", options.command, *words]
    plain = GeneratorOptions(distro)
    for name, option in options.declared.items():
        value = getattr(options, name)
        if name not in _NOT_REPEATED and value not in (option.default, "", getattr(plain, name, option.default)):
            repeated += _flagged(option, value)
    if options.command != "convert":
        repeated += ["--distro", distro, *(["--simulator", simulator] if simulator != "none" else [])]
    return shlex.join(repeated)


def _flagged(option: Option, value: object) -> list[str]:
    """The words that give an option a value."""
    if isinstance(value, bool):
        return [(option.flags if value else option.negatives)[-1]]
    values = value if isinstance(value, tuple) else (value,)
    return [word for one in values for word in (option.flags[-1], str(one))]
