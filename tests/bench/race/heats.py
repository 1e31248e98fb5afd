"""The heats: what is measured against what, each a row of the table."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import NamedTuple

from race.process import NotComparable, NotMeasured, Step, environment, program, progress
from race.robots import SAMPLES, Robot
from race.table import Row
from race.tools import Tools

PAIR = "lint | xacro && check_urdf"
ROBOTS = ("UR5e", "UR5e controllers", "PR2", "PR2 launched", "1200 links")
RIVALS = {
    "check_urdf": ("UR5e", "PR2", "1200 links"),
    "urdf_parser_py": ("UR5e", "PR2", "1200 links"),
    "yourdfpy": ("UR5e", "PR2", "1200 links"),
    "urdf-validator": ("UR5e", "PR2", "100 links"),
}
SIZES = (100, 300, 1000, 2000, 5000)
MEMORY = {"PR2 memory": "PR2", "5000 links memory": "5000 links"}
ENGINES = ("none", "pybullet", "mujoco")
NAMES = (*ROBOTS, "corpus", *RIVALS, "catkin_lint", "growth", "start-up", *MEMORY, "smoke")
STATES = "joint_state_controller: {type: joint_state_controller/JointStateController, publish_rate: 50}\n"

Heat = tuple[str, Callable[[], Row]]


class Pace(NamedTuple):
    """How often each is run: `runs` turns, fewer where they take more than `seconds`; the corpus is not cut short."""

    runs: int
    seconds: float
    corpus_runs: int


class Heats:
    """Gives the rows of each name, as functions: one that cannot be measured does not stop the others."""

    def __init__(self, tools: Tools, pace: Pace) -> None:
        self.tools, self.robots, self.pace = tools, tools.robots, pace

    def of(self, name: str) -> Iterator[Heat]:
        if name in ROBOTS:
            yield name, partial(self.robot, name)
        elif name in RIVALS:
            yield from ((f"{robot} {name}", partial(self.rival, name, robot)) for robot in RIVALS[name])
        elif name in MEMORY:
            yield name, partial(self.memory, name)
        elif name == "corpus":
            yield name, self.corpus
        elif name == "growth":
            yield from ((f"growth {size} links", partial(self.size, size)) for size in SIZES)
        else:
            yield from {"catkin_lint": self.packages, "start-up": self.starts, "smoke": self.smokes}[name]()

    def turns(self, name: str, a: Step, b: Step | None) -> tuple[list[float], list[float]]:
        """Seconds of A B A B, after a warm-up."""
        begun = time.perf_counter()
        times: tuple[list[float], list[float]] = ([], [])
        for turn in range(self.pace.runs + 1):
            if turn > 1 and time.perf_counter() - begun > self.pace.seconds:
                break
            progress(f"{name}: {turn}/{self.pace.runs}")
            for seconds, step in zip(times, (a, b), strict=True):
                if step:
                    seconds.append(step.run())
        return times[0][1:], times[1][1:]

    def row(self, name: str, what: str, a: Step, b: Step | None) -> Row:
        return Row(name, "s", *self.turns(name, a, b), what)

    def robot(self, name: str) -> Row:
        robot = self.robots.named(name)
        return self.row(name, PAIR, self.tools.lint(robot), self.tools.pair(robot))

    def rival(self, name: str, robot: str) -> Row:
        """Both read the URDF that xacro wrote."""
        urdf = self.tools.expanded(robot)
        return self.row(f"{robot} {name}", f"lint | {name}", self.tools.lint(urdf), self.tools.rival(name, urdf))

    def size(self, links: int) -> Row:
        """A alone, where xacro or check_urdf cannot."""
        name, robot = f"growth {links} links", self.robots.made(links)
        a = self.tools.lint(robot)
        try:
            times, note = self.turns(name, a, self.tools.pair(robot, rival=True)), ""
        except NotComparable as error:
            times, note = self.turns(name, a, None), f"xacro && check_urdf not measured: {error}"
        return Row(name, "s", *times, PAIR, note, links)

    def packages(self) -> Iterator[Heat]:
        """Not the same work: catkin_lint looks at what builds a package, urdfctl at its robots."""
        corpus = self.robots.corpus
        for name, package in (
            ("sample", SAMPLES / "mybot"),
            ("PR2 package", corpus / "PR2__pr2_common" / "pr2_description"),
        ):
            yield f"{name} catkin_lint", partial(self.package, f"{name} catkin_lint", package)

    def package(self, name: str, package: Path) -> Row:
        if not package.is_dir():
            raise NotMeasured(f"{package} not found")
        a = self.tools.urdfctl(package, "lint", "--no-cache", ".")
        return self.row(name, "lint FOLDER | catkin_lint FOLDER", a, self.tools.catkin_lint(package))

    def starts(self) -> Iterator[Heat]:
        """What a process takes that has next to nothing to do."""
        one = self.robots.made(1)
        version, lint = self.tools.urdfctl(one.folder, "--version"), self.tools.lint(one)
        bare = Step((sys.executable, "-c", "pass"), one.folder, environment())

        def against_xacro() -> Row:
            b = Step((program("xacro", "pip install xacro"), "--help"), one.folder, environment(), rival=True)
            return self.row("start --version, xacro", "--version | xacro --help", version, b)

        def against_check_urdf() -> Row:
            urdf = self.tools.expanded("1 links")
            b = self.tools.rival("check_urdf", urdf)
            return self.row("start 1 link, check_urdf", "lint | check_urdf", self.tools.lint(urdf), b)

        yield "start --version", partial(self.row, "start --version", "--version | python -c pass", version, bare)
        yield "start --version, xacro", against_xacro
        yield "start 1 link", lambda: self.row("start 1 link", PAIR, lint, self.tools.pair(one))
        yield "start 1 link, check_urdf", against_check_urdf

    def corpus(self) -> Row:
        """All robots that both sides accept: one run of urdfctl, one pair after the other."""
        robots = self.robots.of_corpus()
        pairs: dict[str, Step] = {}
        for number, robot in enumerate(robots, 1):
            step = self.tools.pair(robot)
            try:
                step.run()
                pairs[robot.file] = step
            except NotMeasured:
                pass
            progress(f"corpus: warm-up {number}/{len(robots)}")
        if not pairs:
            raise NotMeasured("xacro and check_urdf accept no robot of the corpus")
        a = self.tools.urdfctl(self.robots.corpus, "lint", "--no-cache", "--exit-zero", *pairs, good=(0,))
        a.run()
        times: tuple[list[float], list[float]] = ([], [])
        for turn in range(self.pace.corpus_runs):
            progress(f"corpus: {turn}/{self.pace.corpus_runs}")
            times[0].append(a.run())
            times[1].append(sum(step.run() for step in pairs.values()))
        left_out = len(robots) - len(pairs)
        note = f"{len(pairs)} robots; left out of both sides, because xacro or check_urdf refuses them: {left_out}"
        return Row("corpus", "s", *times, PAIR, note)

    def memory(self, name: str) -> Row:
        robot = self.robots.named(MEMORY[name])
        steps = self.tools.lint(robot), self.tools.pair(robot)
        runs = min(3, self.pace.runs) if name == "PR2 memory" else 1
        progress(name)
        sizes = [[step.peak() for step in steps] for _ in range(runs)]
        return Row(name, "MB", [a for a, _ in sizes], [b for _, b in sizes], PAIR)

    def smokes(self) -> Iterator[Heat]:
        """No public tool does the like: A alone."""
        for robot, arguments in (
            ("samples", self.samples),
            ("UR5e controllers", partial(self.controlled, "UR5e controllers")),
            ("PR2", self.pr2),
        ):
            for engine in ENGINES:
                name = f"smoke {robot}, {engine}"
                yield name, partial(self.smoke, name, engine, arguments)

    def smoke(self, name: str, engine: str, arguments: Callable[[], tuple[Path, tuple[str, ...]]]) -> Row:
        cwd, words = arguments()
        return self.row(name, f"smoke --engine {engine}", self.tools.smoke(cwd, engine, *words), None)

    def samples(self) -> tuple[Path, tuple[str, ...]]:
        return SAMPLES, tuple(sorted(p.parent.name for p in SAMPLES.glob("*/package.xml")))

    def controlled(self, name: str) -> tuple[Path, tuple[str, ...]]:
        robot: Robot = self.robots.named(name)
        controllers = (word for file in robot.controllers for word in ("--controllers", file))
        return robot.folder, (*robot.words, *controllers, "--workspace", ".")

    def pr2(self) -> tuple[Path, tuple[str, ...]]:
        """PR2's own controllers are for a manager of its own: its joints' states alone are read."""
        urdf = self.tools.expanded("PR2")
        (urdf.folder / "states.yaml").write_text(STATES)
        return urdf.folder, (urdf.file, "--controllers", "states.yaml", "--distro", "noetic")
