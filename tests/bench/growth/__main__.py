"""How the processor time of commands grows with what they read: `python tests/bench/growth --only macros`.

Each input is made larger by four until a command takes a second or the input has 4 MiB. What takes more than 8 times as
long for the last step, or would take more than 5 s for 4 MiB, is told: most likely it grows with the square. Each
command is a process of its own without urdfctl's limits on time. It takes hours for everything; `--only` and
`--command` choose.
"""

from __future__ import annotations

import argparse
import os
import resource
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from packages import LOGS, PACKAGES
from robots import CONTROLLERS, ROBOT, ROBOTS, Grown, Tree

LARGEST = 4 << 20
MOST_FILES = 4000
LONG_ENOUGH = 1.0
STEP = 4
SUSPICIOUS = 8.0
TOO_LONG = 5.0
PATIENCE = 120
UNLIMITED = ["--timeout", "600", "--memory", "6000", "--jobs", "1"]
COMMANDS: dict[str, list[str]] = {
    "lint": ["lint", ".", *UNLIMITED],
    "lint sarif": ["lint", ".", "--format", "sarif", *UNLIMITED],
    "fix": ["lint", ".", "--unsafe-fixes", "--diff", *UNLIMITED],
    "baseline": ["lint", ".", "--baseline", "known.json", *UNLIMITED],
    "report": ["lint", ".", "--report", "report.html", *UNLIMITED],
    "show": ["show", ".", "--timeout", "600"],
    "expand": ["expand", ROBOT, "--timeout", "600"],
    "why": ["why", ROBOT, "joint:j0/limit/@velocity", "--timeout", "600"],
    "why line": ["why", f"{CONTROLLERS}:5", "--timeout", "600"],
    "diff": ["diff", ROBOT, "other.urdf", "--timeout", "600"],
    "graph": ["graph", ".", "--timeout", "600"],
    "graph svg": ["graph", ".", "--format", "svg", "--no-collapse", "--timeout", "600"],
    "view": ["view", ROBOT, "-o", "r.html", "--timeout", "600"],
    "smoke": ["smoke", ".", "--engine", "none", "--timeout", "600"],
    "migrate": ["migrate", ".", "--to", "jazzy", "--timeout", "600"],
    "init": ["init", "--force"],
    "schema": ["schema", "--check", ROBOT, "--distro", "jazzy"],
    "schema yaml": ["schema", "--check", CONTROLLERS, "--distro", "jazzy"],
    "generate": ["gen-all", ROBOT, "--type", "trajectory", "--distro", "jazzy", "-o", "made", "--timeout", "600"],
    "generate ros1": ["gen-all", ROBOT, "--type", "effort", "--distro", "noetic", "-o", "made", "--timeout", "600"],
    "convert": ["convert", ROBOT, "--to", "mjcf", "-o", "r.xml", "--timeout", "600"],
    "explain": ["explain", "a.log"],
    "explain robot": ["explain", "a.log", ROBOT],
    "gen-check": ["gen-check", "."],
}
OF_ROBOT = ("expand", "why", "diff", "view", "schema", "generate", "generate ros1", "convert")
OF_CONTROLLERS = ("why line", "schema yaml")


class Measured(NamedTuple):
    """What a command took: processor time in s, with that of its workers, and how it ended."""

    size: int
    seconds: float
    status: int | None


def commands_for(tree: Tree) -> list[str]:
    """The commands that have something to do with a folder."""
    if "a.log" in tree:
        return ["explain", *(["explain robot"] if ROBOT in tree else [])]
    fitting = [name for name in COMMANDS if not name.startswith("explain") and name != "baseline"]
    if ROBOT not in tree:
        fitting = [name for name in fitting if name not in OF_ROBOT]
    if CONTROLLERS not in tree:
        fitting = [name for name in fitting if name not in OF_CONTROLLERS]
    return ["baseline"] if "known.json" in tree else fitting


def written(tree: Tree, folder: Path) -> int:
    """Write the files of a folder. Return how many bytes they have."""
    for name, text in {**tree, "other.urdf": '<robot name="r"><link name="base"/></robot>'}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return sum(map(len, tree.values()))


def measured(words: list[str], folder: Path, size: int) -> Measured:
    """Run a command in a folder."""
    began = time.monotonic()
    pid = os.fork()
    if pid == 0:
        _be_urdfctl(words, folder)
    while True:
        ended, status, usage = os.wait4(pid, os.WNOHANG)
        if ended:
            return Measured(size, usage.ru_utime + usage.ru_stime, os.waitstatus_to_exitcode(status))
        if time.monotonic() - began > PATIENCE:
            os.killpg(pid, 9)
            _, _, usage = os.wait4(pid, 0)
            return Measured(size, max(usage.ru_utime, PATIENCE), None)
        time.sleep(0.005)


def _be_urdfctl(words: list[str], folder: Path) -> None:
    os.setsid()
    os.chdir(folder)
    for stream, flags in ((0, os.O_RDONLY), (1, os.O_WRONLY), (2, os.O_WRONLY)):
        os.dup2(os.open(os.devnull, flags), stream)
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    try:
        import urdfctl.__main__ as urdfctl

        sys.argv = ["urdfctl", *words]
        urdfctl.main()
    except SystemExit as ended:
        os._exit(ended.code if isinstance(ended.code, int) else 2)
    finally:
        os._exit(99)


def grown(grow: Grown, words: list[str], least: int) -> list[Measured]:
    """Measure a command on larger and larger inputs."""
    steps: list[Measured] = []
    count = least
    while True:
        with tempfile.TemporaryDirectory() as held:
            tree = grow(count)
            size = written(tree, Path(held))
            steps.append(measured(words, Path(held), size))
        last = steps[-1]
        stays = len(steps) > 2 and size < 2 * steps[-2].size
        if last.seconds > LONG_ENOUGH or last.status is None or size * STEP > LARGEST * 2:
            return steps
        if stays or len(tree) > MOST_FILES:
            return steps
        count *= STEP


def verdict(steps: list[Measured]) -> str:
    """What is suspicious; empty if nothing is."""
    last = steps[-1]
    base = steps[0].seconds
    if last.status not in {0, 1, 2}:
        return f"STATUS {last.status}"
    if len(steps) < 2 or last.seconds < LONG_ENOUGH / 2:
        return ""
    more = (last.seconds - base * 0.8) / max(steps[-2].seconds - base * 0.8, 0.02)
    exponent = 2 if more > SUSPICIOUS else 1
    expected = last.seconds * max(LARGEST / max(last.size, 1), 1) ** exponent
    if more > SUSPICIOUS and expected > TOO_LONG:
        return f"x{more:.1f} for x{STEP}; {expected:.0f} s for 4 MiB"
    return f"{expected:.0f} s for 4 MiB" if expected > 4 * TOO_LONG else ""


def main() -> None:
    options = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    options.add_argument("--only", action="append", default=[], help="inputs whose names contain this")
    options.add_argument("--command", action="append", default=[], help="commands with this name")
    options.add_argument("--least", type=int, default=64, help="how many parts the smallest input has")
    given = options.parse_args()
    for name, grow in {**ROBOTS, **PACKAGES, **LOGS}.items():
        if given.only and not any(part in name for part in given.only):
            continue
        for command in commands_for(grow(1)):
            if given.command and command not in given.command:
                continue
            steps = grown(grow, COMMANDS[command], given.least)
            shown = "  ".join(f"{step.size >> 10}K {step.seconds:.2f}" for step in steps)
            print(f"{name:40} {command:14} {shown:60} {verdict(steps)}", flush=True)


if __name__ == "__main__":
    main()
