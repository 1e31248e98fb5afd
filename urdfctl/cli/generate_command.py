"""`urdfctl gen-...`: what the words mean, and where the files go."""

from __future__ import annotations

import os
import re
import shlex
import sys
from collections.abc import Iterable, Mapping

from urdfctl.catalog.catalog import catalog_with
from urdfctl.cli.generate_again import words_that_made
from urdfctl.cli.generate_writing import Writing, deliver
from urdfctl.cli.words import configured, settings_from, split_arguments
from urdfctl.cli.writing import print_text, tell
from urdfctl.discover import find
from urdfctl.errors import UserError
from urdfctl.generate.choice import chosen, stuck
from urdfctl.generate.everything import Order, files
from urdfctl.generate.facts import NO_ROBOT, JointFacts, RobotFacts
from urdfctl.generate.joint_list import joints_listed
from urdfctl.generate.options import Options, Roles
from urdfctl.generate.scalars import xacro_text
from urdfctl.generate.templates import Templates, template_names
from urdfctl.hints import Any
from urdfctl.measure import facts_from
from urdfctl.report.common import Report
from urdfctl.report.text import render
from urdfctl.settings import Settings
from urdfctl.source.files import MAX_BYTES, named_bytes
from urdfctl.source.packages import package_name

_LISTS = (".txt", ".csv", ".yaml", ".yml", ".list")
_SAID_OTHERWISE = frozenset(
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
_PARTS = ("gen-transmissions", "gen-ros2-control", "gen-gazebo")
_NAMES = {"types": "type"}
_DEFAULT_DISTRO = {1: "noetic", 2: "jazzy", None: "jazzy"}


class Unreadable(Exception):
    """The robot cannot be read; what was found is told."""


def run_generate(command: str, given: Mapping[str, Any]) -> int:
    """Generate, write or show or check it, and give the exit status."""
    if given["list_templates"]:
        print_text("".join(f"{name}\n" for name in template_names(given["templates"])))
        return 0
    words = given["words"] or []
    config = configured([], given["config"], given["workspace"])
    settings = settings_from(
        config, given["distro"], given["simulator"], None, given["workspace"], given["package_path"], given["env"],
        given["trust"], given["timeout"], given["memory"],
    )  # fmt: skip
    try:
        robot, listed = _sources(words, given, settings)
    except Unreadable as error:
        sys.stderr.write(str(error))
        return 1
    if robot and robot.file and not split_arguments(words)[0]:
        given = {**given, "words": [os.path.relpath(robot.file), *words]}  # it was found: what is made here may hide it
    options = _options(command, given, settings, robot)
    joints = chosen(robot, listed, given.get("joints") or (), given.get("exclude") or ())
    if not joints and command != "gen-gazebo":
        raise UserError(_no_joints(robot))
    if command == "gen-all" and robot and not robot.package:
        tell(f"'{robot.file}' is in no package, so that no installed file finds it")
    passed_over = stuck(robot, joints) if robot and not (listed or given.get("joints")) else ()
    if passed_over:
        tell(f"left out, for their limits hold them fast: {', '.join(passed_over)} (--joint)")
    order = Order(joints, options, catalog_with(settings.additions), robot or NO_ROBOT, Templates(given["templates"]))
    writing = Writing(given["output"], given["force"], given["diff"], given["check"], given.get("into"))
    return deliver(files(command, order), writing, many=command == "gen-all")


def _no_joints(robot: RobotFacts | None) -> str:
    if robot is None:
        return "no joints: name a robot, a list of joints, or --joint NAME,NAME"
    return "the robot has no joint to control: none that moves and mimics no other" + (
        "" if not robot.joints else ", and that is not excluded"
    )


def _sources(
    words: list[str], given: Mapping[str, Any], settings: Settings
) -> tuple[RobotFacts | None, list[JointFacts]]:
    """The robot, None where there is none, and the joints that are listed."""
    paths, arguments = split_arguments(words)
    listed = [JointFacts(name) for name in _split(given.get("joint"))]
    lists = [path for path in paths if path == "-" or path.endswith(_LISTS)]
    robots = [path for path in paths if path not in lists]
    for path in lists:
        listed += joints_listed(_text(path), "standard input" if path == "-" else path)
    if not robots and (listed or lists):
        return None, listed
    found = find(robots)
    descriptions = [path for path, _ in found.descriptions() if robots or not _is_part(path)]
    if len(descriptions) != 1:
        shown = ", ".join(sorted(os.path.relpath(path) for path in descriptions))
        raise UserError(
            f"which robot? {shown}" if descriptions else "no robot found here: name one, or a list of joints"
        )
    path = robots[0] if robots and not os.path.isdir(robots[0]) else os.path.relpath(descriptions[0])
    read = facts_from(path, arguments, settings)
    if read.facts is None:
        raise Unreadable("\n".join(render(Report((), read.problems)).splitlines()[:-1]) + "\n")
    return read.facts, listed


def _is_part(path: str) -> bool:
    """Whether a file is what was generated for a robot to include."""
    made_by = (words_that_made(path) or ("",))[0]
    return made_by in _PARTS or (made_by == "gen-all" and os.path.basename(path) == "control.xacro")


def _text(path: str) -> str:
    try:
        if path == "-":
            data = sys.stdin.buffer.read(MAX_BYTES + 1)
            if len(data) > MAX_BYTES:
                raise UserError(f"standard input cannot be read: it is larger than {MAX_BYTES >> 20} MiB")
            return data.decode("utf-8")
        return named_bytes(path).decode("utf-8")
    except UnicodeDecodeError:
        raise UserError(f"'{path}' cannot be read: it is no UTF-8") from None


def _options(command: str, given: Mapping[str, Any], settings: Settings, robot: RobotFacts | None) -> Options:
    distro = settings.distro or (robot.distro if robot else None) or settings.environ.get("ROS_DISTRO")
    if not distro:
        distro = _DEFAULT_DISTRO[robot.ros if robot else None]
        tell(f"no distro is told; {distro} is taken (--distro)")
    simulator = settings.simulator or (robot.simulator if robot else None) or "none"
    defaults = Options(distro)
    states = given.get("state")
    return Options(
        distro,
        simulator,
        tuple(_split(given.get("types"))),
        tuple(_split([given.get("interface") or given.get("command") or ""])),
        tuple(name for name in _split([states]) if name != "none") if states else None,
        given.get("hardware"),
        bool(given.get("group")),
        (given.get("namespace") or "").strip("/"),
        given.get("name"),
        Roles(*(tuple(_split(given.get(role))) for role in Roles._fields)),
        given.get("sensor"),
        given.get("frame"),
        given.get("broadcaster", True),
        given.get("rate", defaults.rate),
        _package(command, given, robot),
        given.get("controllers") or defaults.controllers_file,
        robot.package_path if robot else None,
        _included(given, robot),
        tuple(split_arguments(given["words"] or ())[1].items()),
        bool(given.get("macro")),
        given.get("form") or defaults.form,
        bool(given.get("chain")),
        _said_again(command, given, distro, simulator),
    )


def _package(command: str, given: Mapping[str, Any], robot: RobotFacts | None) -> str | None:
    """The package that the files will be in: of gen-all the one that it writes, else the robot's."""
    if given.get("package"):
        return str(given["package"])
    if command != "gen-all" or given["output"] is None:
        return robot.package if robot else None
    manifest = os.path.join(given["output"], "package.xml")
    folder = os.path.basename(os.path.abspath(given["output"]))
    return package_name(manifest) or re.sub(r"[^a-z0-9_]+", "_", folder.lower()).strip("_") or "my_robot_control"


def _included(given: Mapping[str, Any], robot: RobotFacts | None) -> str:
    """How a file in the folder `urdf` of what is written includes the robot."""
    if robot is None or robot.file is None:
        return "robot.urdf"
    if robot.package:
        return f"$(find {robot.package})/{xacro_text(robot.package_path)}"
    return xacro_text(os.path.relpath(robot.file, os.path.join(given.get("output") or "", "urdf")).replace(os.sep, "/"))


def _split(given: Iterable[str] | None) -> list[str]:
    return [name.strip() for item in given or () for name in item.split(",") if name.strip()]


def _said_again(command: str, given: Mapping[str, Any], distro: str, simulator: str) -> str:
    """The command that makes the same files: without what says where they go, and with what was found out."""
    words = ["urdfctl", command, *(given["words"] or ())]
    plain = Options("jazzy")
    for key, value in given.items():
        option = f"--{_NAMES.get(key, key).replace('_', '-')}"
        if key in _SAID_OTHERWISE or value in (None, False, "", getattr(plain, key, None)):
            continue
        if value is True:
            words.append(option)
        else:
            words += [
                word for one in (value if isinstance(value, list | tuple) else [value]) for word in (option, str(one))
            ]
    if given.get("broadcaster") is False:
        words.append("--no-broadcaster")
    words += ["--distro", distro] + (["--simulator", simulator] if simulator != "none" else [])
    return shlex.join(words)
