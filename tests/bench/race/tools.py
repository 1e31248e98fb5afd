"""The tools in the race: urdfctl, xacro with check_urdf, and those that do comparable work."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from race.process import NotComparable, Step, environment, program, python_with
from race.robots import Robot, Robots

PAIR = 'out=$1; check=$2; xacro=$3; shift 3; "$xacro" "$@" > "$out" && "$check" "$out"'
YOURDFPY = "import sys, yourdfpy; yourdfpy.URDF.load(sys.argv[1], load_meshes=False)"
PARSER_PY = "import sys; from urdf_parser_py.urdf import URDF; URDF.from_xml_file(sys.argv[1])"
DEBIAN = "apt install liburdfdom-tools"


class Tools:
    """Gives the steps that are timed; one that is not installed raises NotComparable."""

    def __init__(self, urdfctl: tuple[str, ...], robots: Robots, temp: Path) -> None:
        self.command, self.robots, self.temp = urdfctl, robots, temp

    def urdfctl(self, cwd: Path, *arguments: str, good: tuple[int, ...] = (0, 1)) -> Step:
        return Step((*self.command, *arguments), cwd, environment(), good)

    def lint(self, robot: Robot) -> Step:
        return self.urdfctl(robot.folder, "lint", "--no-cache", *robot.words, *robot.controllers)

    def smoke(self, cwd: Path, engine: str, *arguments: str) -> Step:
        """The engine is looked for beside ours: urdfctl answers 2 where it is missing, as to any wrong command."""
        if engine != "none":
            python_with(engine, "pip install 'urdfctl[smoke]'")
        return self.urdfctl(cwd, "smoke", "--engine", engine, *arguments)

    def pair(self, robot: Robot, *, rival: bool = False) -> Step:
        """`xacro FILE > out && check_urdf out`."""
        tools = program("check_urdf", DEBIAN), program("xacro", "pip install xacro")
        argv = ("sh", "-c", PAIR, "sh", str(self.temp / "out.urdf"), *tools, *robot.words)
        return Step(argv, robot.folder, self.robots.environment(robot), rival=rival)

    def expanded(self, name: str) -> Robot:
        """The robot as xacro writes it, for tools that read no xacro."""
        robot = self.robots.named(name)
        folder = self.temp / "expanded"
        folder.mkdir(exist_ok=True)
        file = folder / f"{name.replace(' ', '_')}.urdf"
        if not file.exists():
            done = subprocess.run(
                [program("xacro", "pip install xacro"), *robot.words],
                cwd=robot.folder,
                env=self.robots.environment(robot),
                capture_output=True,
                check=False,
            )
            if done.returncode:
                raise NotComparable(f"xacro refuses {robot.file}")
            file.write_bytes(done.stdout)
        return Robot(folder, file.name)

    def rival(self, name: str, urdf: Robot) -> Step:
        """One that reads a URDF."""
        makers: dict[str, Callable[[], tuple[str, ...]]] = {
            "check_urdf": lambda: (program("check_urdf", DEBIAN), urdf.file),
            "urdf_parser_py": lambda: (python_with(name, "pip install urdf-parser-py"), "-c", PARSER_PY, urdf.file),
            "yourdfpy": lambda: (python_with(name, "pip install yourdfpy"), "-c", YOURDFPY, urdf.file),
            "urdf-validator": lambda: (
                *(program("urdf_validate", "pip install urdf-validator"), urdf.file),
                *("--output-dir", str(self.temp / "validator")),
            ),
        }
        return Step(
            makers[name](), urdf.folder, environment(), (0, 1) if name == "urdf-validator" else (0,), rival=True
        )

    def catkin_lint(self, package: Path) -> Step:
        argv = (program("catkin_lint", "pip install catkin-lint"), "--offline", "--rosdistro", "noetic", str(package))
        return Step(argv, package, environment(), (0, 1), rival=True)
