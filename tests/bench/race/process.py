"""Processes: what runs, for how long, and how large it grows."""

from __future__ import annotations

import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

LIMIT = 120.0
PEAK = """
import os, sys
null = [(os.POSIX_SPAWN_OPEN, fd, os.devnull, os.O_WRONLY, 0) for fd in (1, 2)]
pid = os.posix_spawnp(sys.argv[1], sys.argv[1:], os.environ, file_actions=null)
_, status, usage = os.wait4(pid, 0)
print(os.waitstatus_to_exitcode(status), usage.ru_maxrss)
"""


class NotMeasured(Exception):
    """Something that was to be measured does not run."""


class NotComparable(NotMeasured):
    """A tool that we race against is not installed, or refuses the robot: worth a line, and nobody's fault."""


@dataclass(frozen=True)
class Step:
    """One process: what runs, where, which exit statuses count as done, and whether it may fail without fault."""

    argv: tuple[str, ...]
    cwd: Path
    env: Mapping[str, str]
    good: tuple[int, ...] = (0,)
    rival: bool = False

    def run(self) -> float:
        """Seconds."""
        start = time.perf_counter()
        try:
            done = subprocess.run(
                self.argv,
                cwd=self.cwd,
                env=self.env,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                timeout=LIMIT,
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise self.failed(f"gave up after {LIMIT:g} s") from None
        seconds = time.perf_counter() - start
        if done.returncode not in self.good:
            raise self.failed(f"exit status {done.returncode}", done.stderr.decode(errors="replace"))
        return seconds

    def peak(self) -> float:
        """Megabytes of the largest process among this one and its descendants."""
        helper = [sys.executable, "-I", "-S", "-c", PEAK, *self.argv]
        done = subprocess.run(helper, cwd=self.cwd, env=self.env, capture_output=True, text=True, check=False)
        if done.returncode:
            raise self.failed("cannot be started", done.stderr)
        status, size = (int(word) for word in done.stdout.split())
        if status not in self.good:
            raise self.failed(f"exit status {status}")
        return size / (2**20 if sys.platform == "darwin" else 2**10)

    def failed(self, how: str, said: str = "") -> NotMeasured:
        """What to raise, with the last line of what it said; its own word where it may fail."""
        last = said.strip().rpartition("\n")[2][-200:]
        if self.rival:
            return NotComparable(f"{how}{last and ': ' + last}")
        return NotMeasured(f"{shlex.join(self.argv)[-200:]}: {how}{last and ': ' + last}")


def program(name: str, package: str) -> str:
    """Beside the running Python, else on PATH; `package` is what to install where it is in neither."""
    beside = Path(sys.executable).with_name(name)
    found = str(beside) if beside.exists() else shutil.which(name)
    if not found:
        raise NotComparable(f"{name} is not installed: {package}")
    return found


def python_with(module: str, package: str) -> str:
    """The running Python, if it has a module."""
    if importlib.util.find_spec(module) is None:
        raise NotComparable(f"{module} is not installed: {package}")
    return sys.executable


def environment(**more: str) -> dict[str, str]:
    """Ours, and more."""
    return {**os.environ, **more}


def progress(text: str) -> None:
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)
