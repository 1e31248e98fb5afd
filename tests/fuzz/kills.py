"""Kill commands while they write: `python tests/fuzz/kills.py --count 200 --seed 1`.

Each trial runs `migrate --in-place`, `lint --fix` or `gen-all -o` in a folder of its own, and ends it by a signal:
before one of its changes to the disk, or after some time. Then the next run writes there. A fault is: files that are
neither all as before nor all as they should be; a file besides, in the folder, in the user's cache or among the
temporary files; or another result of the next run than that of a run that nobody disturbed.
"""

from __future__ import annotations

import argparse
import os
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from random import Random
from typing import NamedTuple

sys.path.extend(
    str(Path(__file__).parents[1] / name)
    for name in ("helpers", "helpers/packages", "helpers/processes", "helpers/smoke", "commands", "migrate")
)

from fixable_robots import ARM
from killing import end_at, tree, without_temporary
from moved_packages import FILES as OF_ROS1

import urdfctl.__main__ as urdfctl
from urdfctl.output.journal import restore_unfinished

Tree = dict[str, bytes]
SIGNALS = [signal.SIGKILL] * 6 + [signal.SIGTERM] * 2 + [signal.SIGINT] * 2
ARMS = {f"arm_{number}.urdf": ARM.encode() for number in range(4)}
GENERATE = ["gen-all", "arm_0.urdf", "--type", "effort", "--distro", "noetic", "--simulator", "gazebo-classic"]


class Kind(NamedTuple):
    """A command, the files before it, and after it if nobody disturbs it."""

    name: str
    words: list[str]
    before: Tree
    after: Tree
    changes: int
    seconds: float


def in_process(do: Callable[[], object], folder: Path, by: int = 0, after: float = 0.0) -> int:
    """Do something in a folder, in a process of its own that is sent a signal after some seconds; return its status."""
    process = os.fork()
    if process == 0:
        os.setsid()
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell ignores it in the background
        os.chdir(folder / "work")
        for handle in (0, 1, 2):
            os.dup2(os.open(os.devnull, os.O_RDWR), handle)
        os.environ["XDG_CACHE_HOME"] = str(folder / "cache")
        tempfile.tempdir = os.environ["TMPDIR"] = str(folder / "tmp")
        try:
            do()
        finally:
            os._exit(99)
    if by:
        time.sleep(after)
        os.kill(process, by)
    status = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    with suppress(ProcessLookupError):
        os.killpg(process, signal.SIGKILL)  # workers that outlived it
    return status


def run(words: list[str]) -> None:
    """Run a command of urdfctl in this process, which ends with it."""
    sys.argv = ["urdfctl", *words]
    urdfctl.main()


def make(folder: Path, before: Tree) -> None:
    """Write the files before a command."""
    for name in ("cache", "tmp"):
        (folder / name).mkdir()
    for name, data in before.items():
        path = folder / "work" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def undisturbed(name: str, words: list[str], before: Tree) -> Kind:
    """Run a command to its end, and return what it makes, in how many changes to the disk and how many seconds."""
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        make(folder, before)
        status = in_process(lambda: run(words), folder)
        after = tree(folder / "work")
        assert status in {0, 1}, f"{name}: status {status}"
        assert after != before
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        make(folder, before)

        def counted() -> None:
            count = end_at(-1, folder, signal.SIGKILL)
            leave = os._exit
            os._exit = lambda _: leave(min(count(), 250))  # type: ignore[assignment]
            run(words)

        began = time.monotonic()
        changes = in_process(counted, folder)
        seconds = time.monotonic() - began
    return Kind(name, words, before, after, changes, seconds)


def fault_in(kind: Kind, random: Random, folder: Path, told: Counter[str]) -> str:
    """Start a command and end it; return what is wrong then or after the next run, empty if nothing is.

    A command that is done before it is sent the signal is not told as killed.
    """
    by = random.choice(SIGNALS)
    make(folder, kind.before)
    if random.random() < 0.5:
        number = random.randrange(kind.changes)
        how = f"{signal.Signals(by).name} before change {number}"
        status = in_process(lambda: (end_at(number, folder, by), run(kind.words)), folder)
    else:
        after = random.random() * kind.seconds
        how = f"{signal.Signals(by).name} after {after:.3f} s"
        status = in_process(lambda: run(kind.words), folder, by, after)
    if status in {0, 1}:
        told["done before"] += 1
        return ""
    work, besides = folder / "work", (folder / "cache/urdfctl/unfinished", folder / "tmp")
    at_once = tree(work)
    is_clean = at_once == kind.before and not any(map(tree, besides))
    in_process(restore_unfinished, folder)
    left = without_temporary(tree(work))
    told["killed"] += 1
    told[signal.Signals(by).name] += 1
    told["half written"] += without_temporary(at_once) not in (kind.before, kind.after)
    told["with temporary files"] += at_once != without_temporary(at_once) or any(map(tree, besides))
    if left not in (kind.before, kind.after):
        return f"{how}: {sorted(left)} are neither old nor new"
    told["old" if left == kind.before else "new"] += 1
    if left == kind.after or is_clean:  # nothing is left that a next run could remove
        return "" if tree(work) == left else f"{how}: leaves {sorted(tree(work))}"
    in_process(lambda: run(kind.words), folder)
    for where, wanted in ((work, kind.after), *((where, {}) for where in besides)):
        if tree(where) != wanted:
            return f"{how}: the next run leaves {sorted(tree(where))} in {where.name}"
    return ""


def main() -> int:
    """Kill as often as is asked; the exit status is 1 where a fault was found."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--count", type=int, default=20, help="how often each command is killed")
    options.add_argument("--seed", type=int, default=1)
    given = options.parse_args()
    for module in ("app", "generate.running", "find.lint", "find.fixing", "migrate"):
        import_module(f"urdfctl.commands.{module}")  # once, not in each process
    ros1 = {name: text.encode() for name, text in OF_ROS1.items()}
    package = {"made/package.xml": b"<package/>\n", "made/config/controllers.yaml": b"old: true\n", "made/own": b"1"}
    kinds = [
        undisturbed("lint --fix", ["lint", ".", "--fix", "--distro", "noetic"], ARMS),
        undisturbed("gen-all -o", [*GENERATE, "-o", "made"], ARMS),
        undisturbed("gen-all -o --force", [*GENERATE, "-o", "made", "--force"], {**ARMS, **package}),
        undisturbed("migrate --in-place", ["migrate", "arm", "--to", "jazzy", "--in-place"], ros1),
    ]
    faults = 0
    for kind in kinds:
        random, told, began = Random(f"{given.seed} {kind.name}"), Counter[str](), time.monotonic()  # noqa: S311
        while told["killed"] < given.count:
            with tempfile.TemporaryDirectory() as made:
                fault = fault_in(kind, random, Path(made), told)
            if fault:
                faults += 1
                print(f"FAULT in {kind.name}, kill {told['killed']}, {fault}", flush=True)
        took = time.monotonic() - began
        print(f"{kind.name}, {kind.changes} changes to the disk, in {took:.0f} s: ", end="")
        print(", ".join(f"{count} {what}" for what, count in told.items()), flush=True)
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main())
