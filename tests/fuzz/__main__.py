"""A mutation fuzzer over the samples, the rules' examples and the corpus: `python tests/fuzz --seconds 300 --seed 1`.

Each trial writes a folder of which some files are mutated, and runs one command there, in a forked process with limits.
A fault is: a traceback, a crash that the command owns up to, an exit status that it does not know, more time than it
may take, or a file changed that it had no business with. Each is told once, and its folder kept to try again.
"""

from __future__ import annotations

import argparse
import gc
import os
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from random import Random
from typing import NamedTuple

from mutations import mutated
from seeds import Tree, trees

import urdfctl.__main__ as urdfctl

DEADLINE = 60.0
_FAULT = re.compile(r"bug in urdfctl|urdfctl crashed|Traceback|gave no result|Warning:|Exception ignored")
_ADDRESS = re.compile(r"0x[0-9a-f]+|'[^']*'|\"[^\"]*\"|\d+")


class Ran(NamedTuple):
    """What a command did: its exit status (None: it was too slow), what it said, and how long it took."""

    status: int | None
    said: str
    seconds: float


def words_for(tree: Tree, random: Random) -> list[str]:
    """A command for a folder's files."""
    by = {end: [name for name in tree if name.endswith(end)] for end in (".xacro", ".urdf", ".yaml", ".launch", ".py")}
    robots = (by[".xacro"] + by[".urdf"]) or ["."]
    robot = random.choice(robots)
    some = random.choice([[robot], ["."], random.sample(sorted(tree), min(2, len(tree)))])
    distro = random.choice(
        [["--distro", random.choice(["indigo", "noetic", "foxy", "humble", "jazzy", "rolling"])], []]
    )
    lists = [name for name in tree if Path(name).stem == "joints"] or [robot]
    logs = [name for name in tree if name.endswith(".log")] or sorted(tree)
    kind = random.choice(["effort", "trajectory", "diff_drive", "velocity", "joint_state_broadcaster", "gripper"])
    target = [random.choice([robot, robot, *lists]), *distro]
    formats = ["text", "concise", "json", "jsonl", "sarif", "github", "gitlab", "junit"]
    lint = ["lint", *some, *distro, "--timeout", "20", "--jobs", "1"]
    return random.choice(
        [
            [*lint, "--format", random.choice(formats)],
            [*lint, "--format", random.choice(formats)],
            [*lint, "--baseline", random.choice(["known.json" if "known.json" in tree else robot])],
            [*lint, random.choice(["--fix", "--unsafe-fixes"]), "--diff"],
            [*lint, random.choice(["--fix", "--unsafe-fixes"]), "--diff"],
            ["expand", robot, "--timeout", "20"],
            ["gen-controllers", *target, "--type", kind],
            ["gen-all", *target, "--type", kind, "--simulator", random.choice(["gz", "gazebo-classic"]), "-o", "made"],
            [random.choice(["gen-transmissions", "gen-ros2-control", "gen-gazebo", "gen-launch"]), *target],
            ["gen-check", "."],
            ["explain", random.choice(logs)],
            ["smoke", *some, *distro, "--engine", "none", "--timeout", "20", "--jobs", "1"],
            ["smoke", *some, *distro, "--engine", "none", "--timeout", "20", "--jobs", "1"],
        ]
    )


def run(words: list[str], folder: str) -> Ran:
    """Run a command in a folder, in a process of its own that may take a minute and four GiB."""
    began = time.monotonic()
    with tempfile.TemporaryFile() as said:
        pid = os.fork()
        if pid == 0:
            _be_urdfctl(words, folder, said.fileno())
        status = _waited(pid, began + DEADLINE)
        said.seek(0)
        return Ran(status, said.read().decode("utf-8", "replace"), time.monotonic() - began)


def _be_urdfctl(words: list[str], folder: str, out: int) -> None:
    os.setsid()
    os.chdir(folder)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.dup2(out, 1)
    os.dup2(out, 2)
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    resource.setrlimit(resource.RLIMIT_FSIZE, (64 << 20, 64 << 20))
    sys.argv = ["urdfctl", *words]
    try:
        urdfctl.main()
    finally:
        os._exit(99)


def _waited(pid: int, until: float) -> int | None:
    while time.monotonic() < until:
        ended, status = os.waitpid(pid, os.WNOHANG)
        if ended:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.002)
    os.killpg(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
    return None


def fault_of(ran: Ran, tree: Tree, folder: Path) -> str | None:
    """What is wrong with what a command did; None where nothing is."""
    if ran.status is None:
        return f"hangs: more than {DEADLINE:g} s"
    told = [line for line in ran.said.splitlines() if _FAULT.search(line)]
    if told or ran.status not in {0, 1, 2}:
        last = [line for line in ran.said.splitlines() if line.strip()][-1:]
        places = re.findall(r'urdfctl/(\S+\.py)", line (\d+)', ran.said)[-1:]
        return f"status {ran.status} {places} {(told or [''])[0][:300]} … {last}"
    changed = [name for name, data in tree.items() if (folder / name).read_bytes() != data]
    return f"changes {changed[0]}" if changed else None


def write(tree: Tree, folder: Path) -> None:
    """Write a folder's files."""
    for name, data in tree.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def main() -> int:
    """Try until the time is over; the exit status is 1 where a fault was found."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--seconds", type=float, default=60)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--keep", default="fuzz-faults", help="where the folders of faults are kept")
    given = options.parse_args()
    started, random = time.monotonic(), Random(given.seed)  # noqa: S311 (nothing secret)
    seeds = trees()
    pieces = [data for tree in seeds for data in tree.values()]
    tried: Counter[str] = Counter()
    faults: dict[str, str] = {}
    slowest: tuple[float, str] = (0.0, "")
    gc.freeze()
    while time.monotonic() - started < given.seconds:
        tree = dict(random.choice(seeds))
        for name in random.sample(sorted(tree), min(len(tree), random.choice([1, 1, 2, 4, len(tree)]))):
            tree[name] = mutated(tree[name], random, random.sample(pieces, 2))
        words = words_for(tree, random)
        with tempfile.TemporaryDirectory() as held:
            folder = Path(held) / "tried"
            write(tree, folder)
            ran = run(words, str(folder))
            slowest = max(slowest, (ran.seconds, " ".join(words)))
            fault = fault_of(ran, tree, folder)
            tried[words[0] + (" --diff" if "--diff" in words else "")] += 1
            key = _ADDRESS.sub("…", fault or "")
            if fault and key not in faults:
                kept = Path(given.keep) / f"{given.seed}-{len(faults)}"
                faults[key] = fault
                shutil.copytree(folder, kept, dirs_exist_ok=True)
                print(f"FAULT in {kept}: urdfctl {' '.join(words)}\n  {fault}", flush=True)
    print(
        f"seed {given.seed}: {sum(tried.values())} tried in {time.monotonic() - started:.0f} s from {len(seeds)} seeds"
    )
    print("  " + ", ".join(f"{count} {name}" for name, count in sorted(tried.items())))
    print(f"  {len(faults)} faults; the slowest took {slowest[0]:.1f} s: {slowest[1]}")
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main())
