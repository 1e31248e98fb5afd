"""`urdfctl gen-...`: read the robot and the options, then generate the files."""

from __future__ import annotations

import os
import re
import shlex
import sys
from collections.abc import Iterable, Mapping

from urdfctl.catalog.catalog import catalog_with
from urdfctl.cli.generate_again import words_of_generated_file
from urdfctl.cli.generate_distro import known_distro, made_for_newest, simulator_of
from urdfctl.cli.generate_measuring import measure_work
from urdfctl.cli.generate_package import around_package
from urdfctl.cli.generate_requests import needs_joints, with_requests
from urdfctl.cli.generate_writing import Writing, deliver
from urdfctl.cli.slips import check_description
from urdfctl.cli.targets import discovered
from urdfctl.cli.words import configured, settings_from, split_arguments
from urdfctl.cli.writing import print_message, print_text
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.generate.cautions import cautions
from urdfctl.generate.choice import chosen, stuck
from urdfctl.generate.everything import Order, files
from urdfctl.generate.facts import NO_ROBOT, JointFacts, RobotFacts
from urdfctl.generate.job import measure_robot
from urdfctl.generate.joint_list import joints_listed
from urdfctl.generate.next_steps import steps_after
from urdfctl.generate.options import File, Options, Roles
from urdfctl.generate.parameters import Controller
from urdfctl.generate.scalars import xacro_text
from urdfctl.generate.templates import Templates, template_names
from urdfctl.report.common import Report
from urdfctl.report.text import render
from urdfctl.source.files import MAX_BYTES, named_bytes
from urdfctl.source.packages import package_name
from urdfctl.startup.hints import TYPE_CHECKING, Any
from urdfctl.startup.records import NamedTuple

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
    }
)
_OWN_NAMES = ("robot.urdf.xacro", "control.xacro")
_ANY_DISTRO = "rolling"
"""For what does not depend on the distro."""
_PARTS = ("gen-transmissions", "gen-ros2-control", "gen-gazebo")
_NAMES = {"types": "type", "command_interface": "command"}


if TYPE_CHECKING:
    from urdfctl.cli.generate_options import GenerateOptions


class Unreadable(Exception):
    """The robot cannot be read. The message contains its problems."""


def run_generate(options: GenerateOptions) -> int:
    """Generate files; write, show or check them; and return the exit status."""
    command, given = options.command, dict(vars(options))
    if given["list_templates"]:
        print_text("".join(f"{name}\n" for name in template_names(given["templates"])))
        return 0
    words = given["words"] or []
    config = configured([], options)
    settings = settings_from(config, options, distro=options.distro, simulator=options.simulator)
    if command == "convert":
        settings = settings._replace(simulator="mujoco")
    try:
        robot, listed = _sources(words, given, settings, config)
    except Unreadable as error:
        sys.stderr.write(str(error))
        return 1
    if robot and robot.file and not split_arguments(words)[0]:
        given = {
            **given,
            "words": [os.path.relpath(robot.file), *words],
        }  # name the robot: the generated files may hide it next time
    joints = chosen(robot, listed, given.get("joints") or (), given.get("exclude") or ())
    immovable = stuck(robot, joints) if robot and not (listed or given.get("joints")) else ()
    if immovable:
        print_message(
            f"left out because their limits allow no motion: {', '.join(immovable)}. Include them with --joint"
        )
    catalog, templates = catalog_with(settings.additions), Templates(given["templates"])

    def make(distro: str) -> Made:
        simulator = settings.simulator or (robot.simulator if robot else None) or simulator_of(distro, command, catalog)
        requested = _options(command, given, robot, distro, simulator)
        requested, proposal = with_requests(requested, command, given.get("controller") or (), joints, robot)
        if not joints and command != "gen-gazebo" and needs_joints(requested, catalog):
            raise UserError(_no_joints(robot))
        order = Order(joints, requested, catalog, robot or NO_ROBOT, templates)
        return Made(requested, files(command, order), order.made_if_typed(), proposal)

    distro = known_distro(settings, robot) or (_ANY_DISTRO if command == "convert" else None)
    made = make(distro) if distro else made_for_newest(robot, make)
    return _delivered(command, given, robot, made)


def _delivered(command: str, given: Mapping[str, Any], robot: RobotFacts | None, made: Made) -> int:
    """Write, show or check what was made, and return the exit status."""
    if made.proposal and not given["check"]:
        print_message(made.proposal)
    if command == "gen-all" and robot and not robot.package and not made.options.robot_text:
        print_message(f"'{robot.file}' is not in a package, so installed files cannot find it")
    if command == "gen-all" and robot and not given["check"]:
        for caution in cautions(made.controllers, robot, made.options):
            print_message(caution)
    writing = Writing(given["output"], given["force"], given["diff"], given["check"], given.get("into"))
    steps = tuple(steps_after(command, made.controllers, made.options, given["output"] or ""))
    files = made.files
    if command == "gen-all" and given["output"]:
        files, to_add = around_package(files, given["output"])
        steps = (*to_add, *steps)
    return deliver(files, writing, many=command == "gen-all", steps=steps)


class Made(NamedTuple):
    """Generated files with the options and controllers that they are made from, and the proposal of controllers."""

    options: Options
    files: list[File]
    controllers: tuple[Controller, ...]
    proposal: str


def _no_joints(robot: RobotFacts | None) -> str:
    if robot is None:
        return "no joints: name a robot, a list of joints, or --joint NAME,NAME"
    excluded = ", or is excluded" if robot.joints else ""
    return f"the robot has no joint to control: each is fixed or mimics another{excluded}"


def _sources(
    words: list[str], given: Mapping[str, Any], settings: Settings, config: Config
) -> tuple[RobotFacts | None, list[JointFacts]]:
    """Return the robot, or None, and the listed joints."""
    paths, arguments = split_arguments(words)
    listed = [JointFacts(name) for name in _split(given.get("joint"))]
    lists = [path for path in paths if path == "-" or path.endswith(_LISTS)]
    robots = [path for path in paths if path not in lists]
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
    measured = measure_robot(path, arguments, settings, measure_work)
    if measured.facts is None:
        raise Unreadable("\n".join(render(Report((), measured.problems)).splitlines()[:-1]) + "\n")
    return measured.facts, listed


def _is_part(path: str) -> bool:
    """Return whether a file was generated to be included by a robot."""
    made_by = (words_of_generated_file(path) or ("",))[0]
    return made_by in _PARTS or (made_by == "gen-all" and os.path.basename(path) == "control.xacro")


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


def _options(command: str, given: Mapping[str, Any], robot: RobotFacts | None, distro: str, simulator: str) -> Options:
    defaults = Options(distro)
    copied = _copied(command, robot)
    states = given.get("state")
    return Options(
        distro=distro,
        simulator=simulator,
        types=tuple(_split(given.get("types"))),
        interfaces=tuple(_split([given.get("interface") or given.get("command_interface") or ""])),
        states=tuple(name for name in _split([states]) if name != "none") if states else None,
        hardware=given.get("hardware"),
        group=bool(given.get("group")),
        namespace=(given.get("namespace") or "").strip("/"),
        name=given.get("name"),
        roles=Roles(*(tuple(_split(given.get(role))) for role in Roles._fields)),
        sensor=given.get("sensor"),
        frame=given.get("frame"),
        broadcaster=given.get("broadcaster", True),
        rate=given.get("rate", defaults.rate),
        package=_package(command, given, robot),
        controllers_file=given.get("controllers") or defaults.controllers_file,
        description=robot.package_path if robot else None,
        robot_file=_included(given, robot) if not copied else f"$(find {_package(command, given, robot)})/{copied[0]}",
        robot_text=copied,
        model_path=given["output"] if command == "convert" else None,
        to=given.get("to"),
        arguments=tuple(split_arguments(given["words"] or ())[1].items()),
        macro=bool(given.get("macro")),
        form=given.get("form") or defaults.form,
        chain=bool(given.get("chain")),
        base=given.get("base"),
        command=_repeatable_command(command, given, distro, simulator),
    )


def _package(command: str, given: Mapping[str, Any], robot: RobotFacts | None) -> str | None:
    """Return the package that the files will be in: the one that gen-all writes, or the robot's."""
    if given.get("package"):
        return str(given["package"])
    if command != "gen-all" or given["output"] is None:
        return robot.package if robot else None
    manifest = os.path.join(given["output"], "package.xml")
    folder = os.path.basename(os.path.abspath(given["output"]))
    return package_name(manifest) or re.sub(r"[^a-z0-9_]+", "_", folder.lower()).strip("_") or "my_robot_control"


def _included(given: Mapping[str, Any], robot: RobotFacts | None) -> str:
    """Return how a file in the folder `urdf` of the output includes the robot."""
    if robot is None or robot.file is None:
        return "robot.urdf"
    if robot.package:
        return f"$(find {robot.package})/{xacro_text(robot.package_path)}"
    return xacro_text(os.path.relpath(robot.file, os.path.join(given.get("output") or "", "urdf")).replace(os.sep, "/"))


def _copied(command: str, robot: RobotFacts | None) -> tuple[str, str] | None:
    """Return the path and text of a robot's copy in the package: of one that is in no package and includes no files."""
    if command != "gen-all" or robot is None or robot.file is None or robot.package:
        return None
    text = _text(robot.file)
    if "xacro:include" in text:
        return None
    name = os.path.basename(robot.file)
    return f"urdf/{'base_' if name in _OWN_NAMES else ''}{name}", text


def _split(given: Iterable[str] | None) -> list[str]:
    return [name.strip() for item in given or () for name in item.split(",") if name.strip()]


def _repeatable_command(command: str, given: Mapping[str, Any], distro: str, simulator: str) -> str:
    """Return the command that generates the same files: with the detected distro and simulator."""
    words = ["urdfctl", command, *(given["words"] or ())]
    plain = Options("jazzy")
    for key, value in given.items():
        option = f"--{_NAMES.get(key, key).replace('_', '-')}"
        if key in _NOT_REPEATED or value in (None, False, "", getattr(plain, key, None)):
            continue
        if value is True:
            words.append(option)
        else:
            words += [
                word for item in (value if isinstance(value, list | tuple) else [value]) for word in (option, str(item))
            ]
    if given.get("broadcaster") is False:
        words.append("--no-broadcaster")
    if command == "convert":
        return shlex.join(words)
    words += ["--distro", distro] + (["--simulator", simulator] if simulator != "none" else [])
    return shlex.join(words)
