#!/usr/bin/env python3
"""Time `urdfctl lint` side by side with `xacro FILE > out && check_urdf out`, as whole processes.

    python tests/bench/bench.py                      everything (some minutes)
    python tests/bench/bench.py --only UR5e --only PR2 --runs 15
    python tests/bench/bench.py --json bench.json --corpus ../shared/corpus

It needs check_urdf (Debian: liburdfdom-tools), the xacro package and PyYAML. urdfctl and xacro are looked for beside
the Python that runs this script, then on PATH; `--urdfctl "python -m urdfctl"` takes another command.

A is urdfctl, B the other pair. After a warm-up A and B run in turn; printed are the medians, the ratio of the medians
and the smallest and largest ratio of two neighbouring runs. Nothing here judges: the exit status is 0 whatever the
times are, and 1 if something could not be measured.

xacro asks ament_index_python for $(find pkg). So that B works without ROS, it gets a module of that name that does as
little as possible (the real one is slower), and install prefixes whose share folders are links into the corpus. A gets
no such help. Peak memory is the resident set of the largest process, measured by a helper of about 10 MB: nothing
smaller is seen.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import re
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import yaml

ROBOTS = {
    "UR5e": "UniversalRobots__Universal_Robots_ROS2_Description/urdf/ur.urdf.xacro",
    "PR2": "PR2__pr2_common/pr2_description/robots/pr2.urdf.xacro",
}
WITH_CONTROLLERS = {
    "UR5e controllers": (
        "UR5e",
        "UniversalRobots__Universal_Robots_ROS2_Driver/ur_robot_driver/config/ur_controllers.yaml",
    )
}
TARGETS = {"UR5e": 1.0, "UR5e controllers": 1.1, "PR2": 0.6, "1200 links": 0.25, "corpus": 0.2, "PR2 memory": 60.0}
LINKS, CHAIN = 1200, 30
PAIR = 'out=$1; check=$2; xacro=$3; shift 3; "$xacro" "$@" > "$out" && "$check" "$out"'
AMENT = '''"""As much of ament_index_python as xacro asks for."""
import os


def get_package_share_directory(package):
    for prefix in os.environ["AMENT_PREFIX_PATH"].split(os.pathsep):
        if os.path.exists(os.path.join(prefix, "share", "ament_index", "resource_index", "packages", package)):
            return os.path.join(prefix, "share", package)
    raise KeyError(f"package '{package}' not found")
'''
PEAK = """
import os, sys
null = [(os.POSIX_SPAWN_OPEN, fd, os.devnull, os.O_WRONLY, 0) for fd in (1, 2)]
pid = os.posix_spawnp(sys.argv[1], sys.argv[1:], os.environ, file_actions=null)
_, status, usage = os.wait4(pid, 0)
print(os.waitstatus_to_exitcode(status), usage.ru_maxrss)
"""
HEADER = """<?xml version="1.0"?>
<robot name="many" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="length" value="0.1"/>
  <xacro:property name="mass" value="0.5"/>
  <xacro:macro name="segment" params="n parent">
    <link name="link_${n}">
      <inertial>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
        <mass value="${mass}"/>
        <inertia ixx="${mass * length * length / 12}" ixy="0" ixz="0"
                 iyy="${mass * length * length / 12}" iyz="0" izz="${mass * 0.02 * 0.02 / 2}"/>
      </inertial>
      <visual>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
        <geometry><cylinder radius="0.02" length="${length}"/></geometry>
      </visual>
      <collision>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
        <geometry><cylinder radius="0.02" length="${length}"/></geometry>
      </collision>
    </link>
    <joint name="joint_${n}" type="revolute">
      <parent link="${parent}"/>
      <child link="link_${n}"/>
      <origin xyz="0 0 ${length}" rpy="0 0 0"/>
      <axis xyz="0 1 0"/>
      <limit lower="${-pi / 2}" upper="${pi / 2}" effort="10" velocity="2"/>
    </joint>
    <transmission name="transmission_${n}">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="joint_${n}">
        <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
      </joint>
      <actuator name="motor_${n}">
        <mechanicalReduction>1</mechanicalReduction>
      </actuator>
    </transmission>
  </xacro:macro>
  <link name="base"/>
"""


class NotMeasuredError(Exception):
    """Something that was to be measured does not run."""


@dataclass(frozen=True)
class Step:
    """One process: what runs, where, and which exit statuses count as done."""

    argv: tuple[str, ...]
    cwd: Path
    env: Mapping[str, str]
    good: tuple[int, ...] = (0,)

    def run(self) -> float:
        start = time.perf_counter()
        done = subprocess.run(
            self.argv, cwd=self.cwd, env=self.env, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False
        )
        seconds = time.perf_counter() - start
        if done.returncode not in self.good:
            tail = done.stderr.decode(errors="replace").strip()[-400:]
            raise NotMeasuredError(f"{shlex.join(self.argv)[-200:]}: exit status {done.returncode}\n{tail}")
        return seconds

    def peak(self) -> float:
        """Megabytes of the largest process among this one and its descendants."""
        helper = [sys.executable, "-I", "-S", "-c", PEAK, *self.argv]
        done = subprocess.run(helper, cwd=self.cwd, env=self.env, capture_output=True, text=True, check=False)
        if done.returncode:
            raise NotMeasuredError(done.stderr.strip())
        status, size = (int(word) for word in done.stdout.split())
        if status not in self.good:
            raise NotMeasuredError(f"{shlex.join(self.argv)[-200:]}: exit status {status}")
        return size / (2**20 if sys.platform == "darwin" else 2**10)


@dataclass(frozen=True)
class Row:
    """One line of the table."""

    name: str
    unit: str
    a: list[float]
    b: list[float]
    note: str = ""

    def summary(self) -> dict[str, Any]:
        pairs = [x / y for x, y in zip(self.a, self.b, strict=True)]
        a, b = statistics.median(self.a), statistics.median(self.b)
        numbers = {"a_median": a, "b_median": b, "ratio": a / b, "ratio_min": min(pairs), "ratio_max": max(pairs)}
        target_of = "ratio" if self.unit == "s" else "a_median"
        return {**asdict(self), **numbers, "target": TARGETS[self.name], "target_of": target_of}


def program(name: str) -> str:
    """Beside the running Python, else on PATH."""
    beside = Path(sys.executable).with_name(name)
    found = str(beside) if beside.exists() else shutil.which(name)
    if not found:
        raise NotMeasuredError(f"{name} not found beside {sys.executable} or on PATH")
    return found


class Packages:
    """Install prefixes made of links into a folder of sources, for a $(find pkg) without ROS."""

    def __init__(self, corpus: Path, temp: Path) -> None:
        self.corpus, self.temp = corpus, temp
        self.overlays: dict[tuple[Path, ...], Path] = {}
        found: dict[str, list[Path]] = {}
        for folder, name in packages_below(corpus):
            found.setdefault(name, []).append(folder)
        self.twice = {name: folders for name, folders in sorted(found.items()) if len(folders) > 1}
        self.common = self.prefix("common", {n: f[0] for n, f in found.items() if len(f) == 1})
        module = temp / "python" / "ament_index_python"
        module.mkdir(parents=True)
        (module / "__init__.py").touch()
        (module / "packages.py").write_text(AMENT)

    def prefix(self, name: str, packages: Mapping[str, Path]) -> Path:
        share = self.temp / name / "share"
        marks = share / "ament_index" / "resource_index" / "packages"
        marks.mkdir(parents=True)
        for package, folder in packages.items():
            (share / package).symlink_to(folder, target_is_directory=True)
            (marks / package).touch()
        return self.temp / name

    def environment(self, file: Path) -> dict[str, str]:
        """For one robot; where a name occurs more than once, the package nearest to the robot is the one."""
        nearest = {name: max(folders, key=lambda f: shared_parts(f, file)) for name, folders in self.twice.items()}
        key = tuple(nearest.values())
        if key not in self.overlays:
            self.overlays[key] = self.prefix(f"overlay{len(self.overlays)}", nearest)
        python = [str(self.temp / "python"), *filter(None, [os.environ.get("PYTHONPATH")])]
        prefixes = os.pathsep.join([str(self.overlays[key]), str(self.common)])
        return {**os.environ, "AMENT_PREFIX_PATH": prefixes, "PYTHONPATH": os.pathsep.join(python)}


def packages_below(corpus: Path) -> Iterable[tuple[Path, str]]:
    for folder, below, files in os.walk(corpus):
        below[:] = sorted(name for name in below if not name.startswith(".") and name != "known_bad")
        if "package.xml" in files:
            text = Path(folder, "package.xml").read_text(encoding="utf-8", errors="replace")
            if match := re.search(r"<name>\s*([^<\s]+)\s*</name>", text):
                yield Path(folder), match[1]


def shared_parts(one: Path, other: Path) -> int:
    return len(Path(os.path.commonpath([one, other])).parts)


class Bench:
    """The measurements, each a method that gives one row."""

    def __init__(self, options: argparse.Namespace, temp: Path) -> None:
        self.options, self.temp = options, temp
        self.corpus = Path(options.corpus).resolve()
        self.urdfctl = shlex.split(options.urdfctl) if options.urdfctl else [program("urdfctl")]
        self.xacro, self.check_urdf = program("xacro"), program("check_urdf")
        self.index: list[dict[str, Any]] = []
        if set(options.only) != {"1200 links"}:
            self.index = read_index(self.corpus)
        self.packages = Packages(self.corpus if self.index else temp / "none", temp)

    def lint(self, cwd: Path, *arguments: str, good: tuple[int, ...] = (0, 1)) -> Step:
        return Step((*self.urdfctl, "lint", *arguments), cwd, os.environ, good)

    def pair(self, cwd: Path, file: str, *arguments: str) -> Step:
        head = ("sh", "-c", PAIR, "sh", str(self.temp / "out.urdf"), self.check_urdf, self.xacro)
        return Step((*head, file, *arguments), cwd, self.packages.environment(cwd / file))

    def robot(self, name: str) -> tuple[Step, Step]:
        """A robot, where it is said so with its controllers' file, which only A reads."""
        name, *controllers = WITH_CONTROLLERS.get(name, (name,))
        entry = next((e for e in self.index if e["path"] == ROBOTS[name]), None)
        if entry is None:
            raise NotMeasuredError(f"{ROBOTS[name]} is not in the corpus's index")
        words = (entry["path"], *(f"{key}:={value}" for key, value in entry["args"].items()))
        return self.lint(self.corpus, *words, *controllers), self.pair(self.corpus, *words)

    def many_links(self) -> tuple[Step, Step]:
        folder = self.temp / "many"
        folder.mkdir()
        calls = (f'  <xacro:segment n="{n}" parent="{parent_of(n)}"/>\n' for n in range(LINKS))
        (folder / "many.xacro").write_text(HEADER + "".join(calls) + "</robot>\n")
        return self.lint(folder, "many.xacro"), self.pair(folder, "many.xacro")

    def alternate(self, name: str, runs: int, a: Step, b: list[Step], note: str = "") -> Row:
        """A B A B, without a warm-up."""
        times: tuple[list[float], list[float]] = ([], [])
        for turn in range(runs):
            times[0].append(a.run())
            times[1].append(sum(step.run() for step in b))
            progress(f"{name}: {turn + 1}/{runs}")
        return Row(name, "s", *times, note)

    def time(self, name: str) -> Row:
        a, b = self.many_links() if name == "1200 links" else self.robot(name)
        a.run(), b.run()
        return self.alternate(name, self.options.runs, a, [b])

    def whole_corpus(self) -> Row:
        paths = [e["path"] for e in self.index if e["expands"] and not e["args"]]
        steps: dict[str, Step] = {}
        for number, path in enumerate(paths, 1):
            step = self.pair(self.corpus, path)
            try:
                step.run()
                steps[path] = step
            except NotMeasuredError:
                pass
            progress(f"corpus: warm-up {number}/{len(paths)}")
        if not steps:
            raise NotMeasuredError("xacro and check_urdf accept no robot of the corpus")
        a = self.lint(self.corpus, "--exit-zero", *steps, good=(0,))
        a.run()
        left_out = len(paths) - len(steps)
        note = f"{len(steps)} robots; left out of both sides, because xacro or check_urdf refuses them: {left_out}"
        return self.alternate("corpus", self.options.corpus_runs, a, list(steps.values()), note)

    def memory(self) -> Row:
        a, b = self.robot("PR2")
        a.peak(), b.peak()
        sizes = [(a.peak(), b.peak()) for _ in range(min(3, self.options.runs))]
        return Row("PR2 memory", "MB", [x for x, _ in sizes], [y for _, y in sizes], "the target is for A")

    def row(self, name: str) -> Row:
        if name == "corpus":
            return self.whole_corpus()
        return self.memory() if name == "PR2 memory" else self.time(name)


def read_index(corpus: Path) -> list[dict[str, Any]]:
    file = corpus / "index.yaml"
    if not file.is_file():
        raise NotMeasuredError(f"{file} not found: name the corpus with --corpus, or ask for --only '1200 links'")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    roots: list[dict[str, Any]] = yaml.load(file.read_text(encoding="utf-8"), loader)["roots"]  # noqa: S506 (a safe loader)
    return roots


def parent_of(n: int) -> str:
    """Chains of CHAIN links, each out of the middle of the one before: branched, and not too deep for check_urdf."""
    if n == 0:
        return "base"
    return f"link_{n - 1}" if n % CHAIN else f"link_{n - CHAIN // 2}"


def progress(text: str) -> None:
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def show(rows: list[dict[str, Any]]) -> None:
    progress("")
    print(f"{'':12}{'A median':>11}{'B median':>11}{'ratio':>8}   {'of pairs':<14}target")
    for row in rows:
        unit = row["unit"]
        target = f"<= {row['target']:g}" + ("" if row["target_of"] == "ratio" else f" {unit} (A)")
        places = 3 if unit == "s" else 1
        medians = "".join(f"{row[k]:>{10 - len(unit)}.{places}f} {unit}" for k in ("a_median", "b_median"))
        pairs = f"{row['ratio_min']:.2f}..{row['ratio_max']:.2f}"
        print(f"{row['name']:12}{medians}{row['ratio']:>8.2f}   {pairs:<14}{target}")
    print("\nA = urdfctl lint, B = xacro > out && check_urdf out")
    for row in rows:
        print(f"{row['name']}: {len(row['a'])} runs" + (f"; {row['note']}" if row["note"] else ""))


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="urdfctl lint against xacro and check_urdf, whole processes")
    parser.add_argument("--corpus", default="../shared/corpus", help="folder with index.yaml (default: %(default)s)")
    parser.add_argument("--urdfctl", help="the command to measure (default: urdfctl beside this Python, else on PATH)")
    parser.add_argument("--only", action="append", default=[], choices=list(TARGETS), help="repeatable")
    parser.add_argument("--runs", type=int, default=9, help="runs of each robot (default: %(default)s)")
    parser.add_argument("--corpus-runs", type=int, default=3, help="runs of the whole corpus (default: %(default)s)")
    parser.add_argument("--json", metavar="FILE", help="write every number there too")
    options = parser.parse_args()
    if options.runs < 1 or options.corpus_runs < 1:
        parser.error("at least one run")
    return options


def main() -> int:
    options = arguments()
    rows: list[dict[str, Any]] = []
    failures: list[str] = []
    with tempfile.TemporaryDirectory(prefix="urdfctl-bench-") as temp:
        try:
            bench = Bench(options, Path(temp))
        except NotMeasuredError as error:
            print(f"bench: {error}", file=sys.stderr)
            return 1
        for name in options.only or TARGETS:
            try:
                rows.append(bench.row(name).summary())
            except NotMeasuredError as error:
                failures.append(f"{name}: {error}")
    if rows:
        show(rows)
    if options.json:
        about = {"python": platform.python_version(), "machine": platform.machine()}
        report = {**about, "rows": rows, "failures": failures}
        Path(options.json).write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    for failure in failures:
        print(f"bench: not measured: {failure}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
