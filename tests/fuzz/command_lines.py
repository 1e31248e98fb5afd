"""A command for the files of a folder, with options, at random; and which of the files it may change."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from random import Random
from typing import NamedTuple

from revisions import REVISIONS
from seeds import Tree

_DISTROS = ["indigo", "noetic", "foxy", "humble", "jazzy", "rolling"]
_FORMATS = ["text", "concise", "json", "jsonl", "sarif", "github", "gitlab", "junit"]
_TYPES = ["effort", "trajectory", "diff_drive", "velocity", "joint_state_broadcaster", "gripper"]
_ADDRESSES = ["joint:elbow/limit/@velocity", "link:base", "joint:elbow", "robot", "ros2_control:arm", "@name", "x/y[2]"]
_INSIDE = ("made/", "made.", "MIGRATION.md", "robot.html", "out.")
"""How the names of files begin that commands are told to write."""


class Line(NamedTuple):
    """A command line.

    writes: how the names of the files begin that it may create or change; None for any of the folder.
    programs: the programs that it may start.
    """

    name: str
    words: list[str]
    writes: tuple[str, ...] | None = ()
    statuses: frozenset[int] = frozenset({0, 1, 2})
    needs_git: bool = False
    programs: tuple[str, ...] = ()

    def may_change(self, name: str) -> bool:
        """Return whether the command may create or change a file of the folder."""
        return self.writes is None or name.startswith(self.writes)


class _Files:
    """The files of a folder by what they are, and random choices among them."""

    def __init__(self, tree: Tree, random: Random) -> None:
        self.tree, self.random, self.choose = tree, random, random.choice
        self.robots = self.ending(".xacro", ".urdf") or ["."]
        self.robot = random.choice(self.robots)
        self.launches = self.ending(".launch", ".launch.xml", ".launch.py", ".launch.yaml") or [self.robot]
        self.yamls = self.ending(".yaml", ".yml") or [self.robot]
        self.some = random.choice([[self.robot], ["."], random.sample(sorted(tree), min(2, len(tree)))])
        self.distro = random.choice([["--distro", random.choice(_DISTROS)], []])

    def ending(self, *ends: str) -> list[str]:
        return sorted(name for name in self.tree if name.endswith(ends))

    def file(self, name: str) -> str:
        """A file to write: a new one, or a link that leads out of the folder."""
        return self.choose([f"made.{name}", f"made.{name}", f"made/{name}", f"to_secret.{name}"])

    def workers(self) -> list[str]:
        return ["--timeout", "20", "--jobs", "1"]


def _lint(files: _Files) -> Line:
    words = ["lint", *files.some, *files.distro, *files.workers()]
    name = files.choose(_FORMATS)
    more: list[list[str]] = [
        ["--format", name],
        ["--format", name],
        ["--format", f"sarif={files.file('sarif')}", "--format", "text"],
        ["--report", files.file("html")],
        ["--baseline", "known.json" if "known.json" in files.tree else files.robot],
        ["--write-baseline", files.file("json")],
        ["--statistics", "--no-cache"],
    ]
    return Line("lint", [*words, *files.choose(more)], _INSIDE)


def _fix(files: _Files) -> Line:
    words = ["lint", *files.some, *files.distro, *files.workers(), files.choose(["--fix", "--unsafe-fixes"])]
    if files.choose([True, False]):
        return Line("lint --fix --diff", [*words, "--diff"])
    return Line("lint --fix", words, None)


def _smoke(files: _Files) -> Line:
    name = files.choose(["smoke", "smoke", "check"])
    words = [name, *files.some, *files.distro, "--engine", "none", *files.workers()]
    more = files.choose([[], [], ["--format", files.choose(["json", "junit"])], ["--report", files.file("html")]])
    more += files.choose([[], ["--tasks", files.choose(files.yamls)], ["--controllers", files.choose(files.yamls)]])
    return Line(name, [*words, *more], _INSIDE, frozenset({0, 1, 2, 5}))


def _why(files: _Files) -> Line:
    place = f"{files.choose(sorted(files.tree))}:{files.random.randint(0, 60)}{files.choose(['', ':1', ':30'])}"
    words = files.choose([[files.robot, files.choose(_ADDRESSES)], [place], [files.robot, place]])
    return Line("why", ["why", *words, *files.distro, "--format", files.choose(["text", "json"])])


def _diff(files: _Files) -> Line:
    revision = files.choose(REVISIONS)
    sides = files.choose([
        [files.choose(files.robots), files.choose(files.robots)],
        [files.robot, files.robot, "prefix:=a_"],
        [f"{revision}:", files.robot],
        [f"{revision}:urdf/arm.xacro", files.robot],
        [f"{revision}:{files.robot}", f"{files.choose(REVISIONS)}:"],
        [f"{revision}:.", "."],
    ])  # fmt: skip
    form = files.choose(["text", "markdown", "html", "json", f"html={files.file('html')}"])
    words = ["diff", *sides, "--format", form]
    return Line("diff", words, _INSIDE, needs_git=any(":" in side for side in sides), programs=("git",))


def _graph(files: _Files) -> Line:
    words = ["graph", *files.some, *files.distro, "--format", files.choose(["mermaid", "dot", "svg", "html", "json"])]
    more = files.choose([[], ["--collapse"], ["--focus", files.choose(["elbow", "arm", "x"])], ["--start", "all"]])
    return Line("graph", [*words, *more])


def _view(files: _Files) -> Line:
    where = files.choose([["-o", files.file("html")], ["-o", files.file("html")], ["--image", "made.png"]])
    return Line("view", ["view", *files.some, *files.distro, *where], _INSIDE)


def _show(files: _Files) -> Line:
    return Line("show", ["show", *files.some, *files.distro, "--format", files.choose(["text", "json"])])


def _expand(files: _Files) -> Line:
    where = files.choose([[], [], ["-o", files.file("urdf")]])
    return Line("expand", ["expand", files.robot, *where], _INSIDE)


def _explain(files: _Files) -> Line:
    logs = files.ending(".log") or sorted(files.tree)
    more = files.choose([[], [], ["--in", "."], ["--format", "json"]])
    return Line("explain", ["explain", files.choose(logs), *more])


def _doctor(files: _Files) -> Line:
    recordings = files.ending(".json") or sorted(files.tree)
    more = files.choose([[], ["--in", "."], ["--format", "json"]])
    return Line("doctor", ["doctor", files.choose(recordings), *files.distro, *more])


def _convert(files: _Files) -> Line:
    words = ["convert", files.robot, "--to", "mjcf", *files.choose([[], ["--base", "free"], ["--joints", "elb.*"]])]
    return Line("convert", [*words, "-o", files.choose(["made.xml", "made/robot.xml"])], _INSIDE)


def _schema(files: _Files) -> Line:
    checked = files.choose([files.choose(files.yamls), files.robot])
    kind = files.choose([[], ["controllers"], ["ros2_control"], ["urdf"]])
    return Line("schema", ["schema", *kind, "--check", checked, "--distro", files.choose(_DISTROS)])


def _init(files: _Files) -> Line:
    more = files.choose([[], ["--pre-commit", "--workflow"], ["--force"]])
    where = files.choose(["", "", "urdf/"])
    writes = tuple(f"{where}{name}" for name in ("urdfctl.toml", ".pre-commit-config.yaml", ".github/"))
    return Line("init", ["init", where or ".", *files.distro, *more], writes, programs=("git",))


def _migrate(files: _Files) -> Line:
    to = ["--to", files.choose(["humble", "jazzy", "kilted", "rolling"])]
    more = files.choose([[], ["--from", files.choose(["noetic", "foxy", "humble"])], ["--simulator", "gz"]])
    more += files.choose([[], ["--launch", "xml"], ["--only", files.choose(["urdf", "yaml,launch", "moveit"])]])
    if files.choose([True, False, False]):
        words = ["migrate", ".", *to, *more, "--in-place", "--force"]
        return Line("migrate --in-place", words, None, programs=("git",))
    where, writes = files.choose([([], ()), (["-o", "made"], _INSIDE), (["--report", files.file("json")], _INSIDE)])
    return Line("migrate", ["migrate", ".", *to, *more, *where], writes, programs=("git",))


def _generate(files: _Files) -> Line:
    lists = [name for name in files.tree if Path(name).stem == "joints"] or [files.robot]
    target = [files.choose([files.robot, files.robot, *lists]), *files.distro]
    name = files.choose(["gen-controllers", "gen-transmissions", "gen-ros2-control", "gen-gazebo", "gen-launch"])
    kind = ["--type", files.choose(_TYPES)] if name in {"gen-controllers", "gen-launch"} else []
    if files.choose([True, False]):
        where = files.choose([[], ["-o", files.file("yaml")], ["-o", files.file("yaml"), "--force"]])
        return Line(name, [name, *target, *kind, *where], _INSIDE)
    if files.choose([True, False, False]):
        few = ["--samples", "50", *files.choose([[], ["--group", "arm=base:tip"], ["--force"]])]
        return Line("gen-moveit", ["gen-moveit", files.robot, *files.distro, *few, "-o", "made"], _INSIDE)
    simulator = ["--simulator", files.choose(["gz", "gazebo-classic", "mujoco"])]
    return Line("gen-all", ["gen-all", *target, "--type", files.choose(_TYPES), *simulator, "-o", "made"], _INSIDE)


def _check(files: _Files) -> Line:
    return Line("gen-check", ["gen-check", *files.choose([[], ["."], ["config"], ["config/old.yaml"]])])


def _server(_: _Files) -> Line:
    return Line("server", ["server"], programs=("python", "python3", "git", _interpreter()))


def _interpreter() -> str:
    import sys

    return Path(sys.executable).name


LINES: Mapping[Callable[[_Files], Line], int] = {
    _lint: 4, _fix: 4, _smoke: 2, _why: 2, _diff: 3, _graph: 2, _view: 2, _show: 1, _expand: 1, _explain: 1, _doctor: 1,
    _convert: 1, _schema: 2, _init: 1, _migrate: 3, _generate: 3, _check: 1, _server: 2,
}  # fmt: skip
"""What makes a command, and how often."""


def line_for(tree: Tree, random: Random) -> Line:
    """Return a command for a folder's files."""
    [make] = random.choices([*LINES], [*LINES.values()])
    return make(_Files(tree, random))
