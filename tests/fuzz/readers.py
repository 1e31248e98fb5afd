"""The readers of strangers' files, each with the file of the package that an input stands in place of."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import NamedTuple

from fake_git import LISTING, laid_out
from hostile import readers as texts
from package import PACKAGE
from questions import asked_in_an_editor
from seeds import ARM, CHECKOUT, Tree
from works import CONTROLLERS, ROBOT, expand, migrated, worked

from urdfctl.catalog.distros import ALL
from urdfctl.config.file import Config, config_of
from urdfctl.errors import UserError
from urdfctl.load.target import Target
from urdfctl.schemas.checking import faults_in_controllers, faults_in_robot
from urdfctl.schemas.robot import ros2_control_schema, urdf_schema
from urdfctl.smoke.robot.shapes import corners_of
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse
from urdfctl.source.yaml.tree import read_yaml
from urdfctl.view.meshes import NotAMesh, merged, packed, read_mesh

_MIGRATED = {name: PACKAGE[name] for name in ("package.xml", "CMakeLists.txt", CONTROLLERS)} | {ROBOT: ARM}
_MIGRATED |= {name: PACKAGE[name] for name in (".git/HEAD", "launch/x.launch", "launch/arm.launch.py")}
Read = Callable[[bytes, Random], None]
OF_ROBOTS = (".xacro", ".urdf", ".gazebo", ".trans")
OF_YAML = (".yaml", ".yml")
_ONLY_EXPANDED = 0.8


class Reader(NamedTuple):
    """What is read.

    file: the file of the package that the input stands in place of; empty for one that `read` writes itself.
    ends: how the names of other files end that may stand there too.
    read: reads it. UserError, ReadError and what is over budget are answers; any other exception is a fault.
    share: how many inputs it gets, in comparison with the others.
    """

    file: str
    ends: tuple[str, ...]
    read: Read
    share: int


def xml(data: bytes, _: Random) -> None:
    parse(SourceText("/a.xacro", data))
    texts.read_comments(data, Path())


def yaml(data: bytes, random: Random) -> None:
    read_yaml(SourceText("/a.yaml", data))


def expression(data: bytes, random: Random) -> None:
    """Evaluate a text in one of the places where xacro does."""
    text = data.decode("utf-8", "replace").replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    body = random.choice(['<a b="${%s}"/>', '<xacro:if value="${%s}"/>', '<a b="$(eval %s)"/>', '<a b="$(%s)"/>'])
    robot = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{body % text}</robot>'
    _write("urdf/expression.xacro", robot.encode())
    target = Target("urdf/expression.xacro")
    expand(target, random) if random.random() < _ONLY_EXPANDED else worked(target, random)


def robot(_: bytes, random: Random) -> None:
    more = random.choice([{}, {"controllers": (CONTROLLERS,)}, {"launch": "launch/arm.launch.py"}, {"fragment": True}])
    worked(Target(ROBOT, **more), random)


def controllers(_: bytes, random: Random) -> None:
    worked(random.choice([Target(CONTROLLERS), Target(ROBOT, controllers=(CONTROLLERS,))]), random)


def launch(file: str) -> Read:
    def read(_: bytes, random: Random) -> None:
        worked(random.choice([Target(file), Target(file), Target(ROBOT, launch=file)]), random)

    return read


def beside_a_robot(_: bytes, random: Random) -> None:
    worked(Target(ROBOT, controllers=(CONTROLLERS,)), random)


def moveit(_: bytes, random: Random) -> None:
    worked(Target("moveit/arm.urdf"), random)


def to_migrate(name: str) -> Read:
    """Return what migrates a package of few files, of which one is the input."""

    def read(data: bytes, random: Random) -> None:
        folder = Path("migrated")
        for one, content in {**_MIGRATED, name: data}.items():
            path = folder / one
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        try:
            migrated(str(folder), random)
        finally:
            shutil.rmtree(folder)

    return read


def config(data: bytes, random: Random) -> None:
    texts.read_settings(data, Path())
    _write("urdfctl.toml", data)
    given = config_of("urdfctl.toml") or Config()
    given.excludes(ROBOT)
    given.ignores(ROBOT, "UC101")
    os.unlink("pyproject.toml")


def mesh(data: bytes, random: Random) -> None:
    kind = random.choice(["stl", "obj", "dae"])
    _write(f"meshes/read.{kind}", data)
    corners_of(f"meshes/read.{kind}")
    with suppress(NotAMesh):
        for surface in merged(read_mesh(data, kind)):
            packed(surface, random.choice([1.0, 0.01]))


def schema(data: bytes, random: Random) -> None:
    if random.random() < 0.5:
        faults_in_controllers(SourceText("/a.yaml", data), random.choice(ALL))
    else:
        faults_in_robot(SourceText("/a.urdf", data), random.choice([urdf_schema(), ros2_control_schema("jazzy")]))


def of_text(read: Callable[[bytes, Path], None]) -> Read:
    return lambda data, _: read(data, Path())


READERS: Mapping[str, Reader] = {
    "xml": Reader("", (*OF_ROBOTS, ".xml", ".launch", ".srdf", ".world", ".sdf"), xml, 900),
    "yaml": Reader("", OF_YAML, yaml, 800),
    "expression": Reader("", (".expression",), expression, 80),
    "robot": Reader(ROBOT, OF_ROBOTS, robot, 40),
    "macros": Reader("urdf/wheel.xacro", OF_ROBOTS, robot, 8),
    "values of a robot": Reader("config/sizes.yaml", OF_YAML, robot, 8),
    "controllers": Reader(CONTROLLERS, OF_YAML, controllers, 40),
    "launch.xml": Reader("launch/arm.launch.xml", (".launch.xml",), launch("launch/arm.launch.xml"), 20),
    "launch of ROS 1": Reader("launch/arm.launch", (".launch",), launch("launch/arm.launch"), 20),
    "launch.yaml": Reader("launch/arm.launch.yaml", (".launch.yaml",), launch("launch/arm.launch.yaml"), 10),
    "launch.py": Reader("launch/arm.launch.py", (".py",), launch("launch/arm.launch.py"), 25),
    "settings": Reader("", (".toml",), config, 60),
    "package.xml": Reader("package.xml", ("package.xml",), beside_a_robot, 8),
    "CMakeLists.txt": Reader("CMakeLists.txt", ("CMakeLists.txt",), beside_a_robot, 8),
    "install rules": Reader("", ("CMakeLists.txt",), of_text(texts.read_cmake), 60),
    "setup.py": Reader("", ("setup.py",), of_text(texts.read_setup), 60),
    "plugins": Reader("plugins.xml", ("plugins.xml",), beside_a_robot, 6),
    "parameters": Reader("src/own.yaml", OF_YAML, beside_a_robot, 6),
    "MoveIt": Reader("moveit/arm.srdf", (".srdf",), moveit, 14),
    "MoveIt's limits": Reader("moveit/joint_limits.yaml", ("joint_limits.yaml",), moveit, 4),
    "MoveIt's controllers": Reader("moveit/moveit_controllers.yaml", ("moveit_controllers.yaml",), moveit, 4),
    "MoveIt's solvers": Reader("moveit/kinematics.yaml", ("kinematics.yaml",), moveit, 4),
    "worlds": Reader("", (".world", ".sdf"), to_migrate("worlds/arm.world"), 1),
    "robots to migrate": Reader("", OF_ROBOTS, to_migrate(ROBOT), 1),
    "launch files to migrate": Reader("", (".launch", ".launch.py"), to_migrate("launch/arm.launch"), 1),
    "controllers to migrate": Reader("", OF_YAML, to_migrate(CONTROLLERS), 1),
    "meshes": Reader("", (".stl", ".obj", ".dae"), mesh, 60),
    "schemas": Reader("", (*OF_YAML, *OF_ROBOTS), schema, 6),
    "joints": Reader("", ("joints.yaml", "joints.csv", "joints.txt"), of_text(texts.read_joints), 60),
    "known findings": Reader("", (".json",), of_text(texts.read_known_findings), 60),
    ".gitignore": Reader("", (".gitignore",), of_text(texts.read_gitignore), 60),
    "logs": Reader("", (".log",), of_text(texts.read_log), 100),
    "origins": Reader("", ("old.yaml",), of_text(texts.read_origin), 60),
    "suppressions": Reader("", (*OF_ROBOTS, *OF_YAML), of_text(texts.read_comments), 500),
    "questions of an editor": Reader("", (*OF_ROBOTS, *OF_YAML, ".launch"), asked_in_an_editor, 12),
    "revisions": Reader("", (".revision",), laid_out, 20),
}
ANSWERS = (UserError, ReadError)

EXPRESSIONS = [
    *("1 + 2.5", "pi * sin(radians(30))", "[x for x in range(3)]", "dict(a=1)['a']", "'a' if x else 'b'", "{1: 2}[1]"),
    *("xacro.load_yaml('../config/sizes.yaml')['mass']", "lambda x: x + 1", "'%.3f' % 1.5", "'{:>5}'.format(1)"),
    *("arg prefix", "find arm", "optenv HOME x", "max([1, 2], key=lambda v: -v)", "not True and 3 < 4 <= 5"),
]
LOG = b"[spawner-3] [INFO] [1700000000.1] [spawner_arm]: Configured and activated arm\n"


def of_package() -> Tree:
    """Return the files that inputs begin with, besides those of other trees."""
    pages = (CHECKOUT / "docs/configuration.md").read_text(encoding="utf-8").split("```toml\n")[1:]
    examples = {f"{number}.toml": page.partition("```")[0].encode() for number, page in enumerate(pages)}
    texts = {f"{number}.expression": text.encode() for number, text in enumerate(EXPRESSIONS)}
    return {**PACKAGE, **examples, **texts, "moves.log": LOG, "main.revision": LISTING}


def _write(name: str, data: bytes) -> None:
    with open(name, "wb") as file:
        file.write(data)
