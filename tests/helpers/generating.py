"""Helpers for the tests of the generators: a robot with all kinds of joints, and the findings in generated files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import yaml
from typer.testing import CliRunner

from urdfctl.catalog.catalog import CATALOG
from urdfctl.commands.app import app
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.generate.everything import Order, files
from urdfctl.generate.options import File, GeneratorOptions, Roles
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.generate.text.templates import Templates
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.source.disk.shown import forget_files

TEMPLATES = Templates()
WHEELS = (
    ("front_left", 0.3, 0.2),
    ("front_right", 0.3, -0.2),
    ("rear_left", -0.3, 0.2),
    ("rear_right", -0.3, -0.2),
)
STEERED = (
    ("steer_left", 0.3, 0.2),
    ("steer_right", 0.3, -0.2),
    ("steer_rear_left", -0.3, 0.2),
    ("steer_rear_right", -0.3, -0.2),
)
JOINTS = (
    *(
        JointFacts(n, "continuous", at=(x, y, 0.0), axis=(0.0, 1.0, 0.0), radius=0.1, velocity=3.0)
        for n, x, y in WHEELS
    ),
    *(JointFacts(n, at=(x, y, 0.0), axis=(0.0, 0.0, 1.0), lower=-1, upper=1, effort=9.0) for n, x, y in STEERED),
    JointFacts("arm", at=(0.0, 0.0, 1.0), axis=(1.0, 0.0, 0.0), lower=-1, upper=1, effort=9.0, inertia=0.2),
)
ROBOT = RobotFacts("everything", root="base_link", joints=JOINTS)
_ROLES = {
    "tricycle_steering": Roles(traction=("rear_left", "rear_right"), steering=("steer_left",)),
    "tricycle": Roles(traction=("front_left",), steering=("steer_left",)),
    "bicycle": Roles(traction=("front_left",), steering=("steer_left",)),
    "ackermann": Roles(traction=("rear_left", "rear_right"), steering=("steer_left", "steer_right")),
    "four_wheel": Roles(
        traction=("front_left", "front_right", "rear_left", "rear_right"),
        steering=("steer_left", "steer_right", "steer_rear_left", "steer_rear_right"),
    ),
}


def roles_of(name: str) -> Roles:
    """Return the roles of the robot's joints for a drive."""
    return next((roles for part, roles in _ROLES.items() if part in name), Roles())


def made(
    command: str, options: GeneratorOptions, joints: tuple[JointFacts, ...] = JOINTS, robot: RobotFacts = ROBOT
) -> list[File]:
    """Return the files that a generate command makes."""
    return files(command, Order(joints, options, CATALOG, robot, TEMPLATES))


def read(text: str) -> dict[str, Any]:
    """Return the content of a controller file; `/**/NAME`, a name in any namespace, is NAME."""
    return {name.removeprefix("/**/"): part for name, part in yaml.safe_load(text).items()}


def told(folder: Path, texts: Mapping[str, str], distro: str, simulator: str | None = None) -> list[str]:
    """Return the findings of all rules in some files; the first is the robot, or a controller file alone.

    Two rules are left out: UC707, which reports types that a later distro removes, and UC449, which reports the
    placeholders in generated files.
    """
    for name, text in texts.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    loader = Loader(Settings(distro, simulator, workspace=str(folder), package_paths=(str(folder),)))
    first, *others = [str(folder / name) for name in texts]
    controllers = tuple(path for path in others if path.endswith(".yaml"))
    launch = next((path for path in others if path.endswith(".launch")), None)
    outcome = lint_target(loader, Target(first, controllers=controllers, launch=launch), Selection()).result.outcome
    return [f"{found.code} {found.message}" for found in outcome.diagnostics if found.code not in ("UC449", "UC707")]


class Ran(NamedTuple):
    """The result of a command."""

    returncode: int
    stdout: str
    stderr: str


def command(*words: str, text: str | None = None) -> Ran:
    """Run `urdfctl` with these arguments in this process; robots are still read in another process."""
    forget_files()  # as a new process would
    try:
        result = CliRunner().invoke(app, list(words), input=text, catch_exceptions=False)
    except UserError as error:
        return Ran(2, "", f"urdfctl: {error}\n")
    return Ran(result.exit_code, result.stdout, result.stderr)
