#!/usr/bin/env python3
"""Race urdfctl against public tools that do comparable work, as whole processes, side by side in one run.

    python tests/bench/bench.py                      everything (about ten minutes)
    python tests/bench/bench.py --only UR5e --only PR2 --runs 15
    python tests/bench/bench.py --only growth --only smoke
    python tests/bench/bench.py --json bench.json --corpus ../shared/corpus

A is urdfctl; B is `xacro FILE > out && check_urdf out`, or, on the URDF that xacro wrote, check_urdf (Debian:
liburdfdom-tools), urdf_parser_py, yourdfpy's loader and urdf-validator, or catkin_lint on a package (`pip install xacro
urdf-parser-py yourdfpy urdf-validator catkin-lint`). Programs are looked for beside the Python that runs this script,
then on PATH, modules in that Python; what is not installed is told, and no error. `--urdfctl "python -m urdfctl"` takes
another command.

After a warm-up A and B run in turn; printed are the medians, the ratio of the medians and the smallest and largest
ratio of two neighbouring runs. Nothing here judges: the exit status is 0 whatever the times are, and 1 if urdfctl, or
a pair that has to run, could not be measured. No tool does exactly what another does: check_urdf reads only what a
URDF must have, yourdfpy builds a scene, urdf-validator works out statics, catkin_lint reads CMakeLists.txt.

Peak memory is the resident set of the largest process, measured by a helper of about 10 MB: nothing smaller is seen.
"""

from __future__ import annotations

import argparse
import importlib.metadata
import json
import platform
import shlex
import sys
import tempfile
from pathlib import Path
from typing import Any

from race.heats import NAMES, Heats, Pace
from race.process import NotComparable, NotMeasured, program, progress
from race.robots import Robots
from race.table import growth, text
from race.tools import Tools

DISTRIBUTIONS = (
    "urdfctl",
    "xacro",
    "urdf-parser-py",
    "yourdfpy",
    "urdf-validator",
    "catkin-lint",
    "pybullet",
    "mujoco-core",
)


def versions() -> dict[str, str]:
    """Of what is installed in this Python."""
    found = {"python": platform.python_version()}
    for name in DISTRIBUTIONS:
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found


def arguments(argv: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="urdfctl against public tools, whole processes")
    parser.add_argument("--corpus", default="../shared/corpus", help="folder with index.yaml (default: %(default)s)")
    parser.add_argument("--urdfctl", help="the command to measure (default: urdfctl beside this Python, else on PATH)")
    parser.add_argument("--only", action="append", default=[], choices=NAMES, metavar="NAME", help=", ".join(NAMES))
    parser.add_argument("--runs", type=int, default=9, help="runs of each, at most (default: %(default)s)")
    parser.add_argument("--seconds", type=float, default=30, help="begin no further run after (default: %(default)s)")
    parser.add_argument("--corpus-runs", type=int, default=3, help="runs of the whole corpus (default: %(default)s)")
    parser.add_argument("--json", metavar="FILE", help="write every number there too")
    options = parser.parse_args(argv)
    if options.runs < 1 or options.corpus_runs < 1:
        parser.error("at least one run")
    return options


def race(heats: Heats, names: list[str]) -> tuple[list[dict[str, Any]], list[str], list[str]]:
    """The rows, what could not be compared, and what failed."""
    rows: list[dict[str, Any]] = []
    told: list[str] = []
    failures: list[str] = []
    for name in names:
        for row, measure in heats.of(name):
            try:
                rows.append(measure().summary())
            except NotComparable as error:
                told.append(f"{row}: {error}")
            except NotMeasured as error:
                failures.append(f"{row}: {error}")
    progress("")
    return rows, told, failures


def main(argv: list[str] | None = None) -> int:
    options = arguments(argv)
    with tempfile.TemporaryDirectory(prefix="urdfctl-bench-") as folder:
        temp = Path(folder)
        try:
            command = shlex.split(options.urdfctl) if options.urdfctl else [program("urdfctl", "pip install urdfctl")]
        except NotMeasured as error:
            print(f"bench: {error}", file=sys.stderr)
            return 1
        tools = Tools(tuple(command), Robots(Path(options.corpus).resolve(), temp), temp)
        heats = Heats(tools, Pace(options.runs, options.seconds, options.corpus_runs))
        rows, told, failures = race(heats, options.only or list(NAMES))
    about = versions()
    if rows:
        print(text(rows))
    for one in told:
        print(f"not measured: {one}")
    print(platform.machine(), *(f"{name} {version}" for name, version in about.items()), sep=", ")
    if options.json:
        report = {"machine": platform.machine(), "versions": about, "rows": rows, "growth": growth(rows)}
        report |= {"not_comparable": told, "failures": failures}
        Path(options.json).write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    for failure in failures:
        print(f"bench: not measured: {failure}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
