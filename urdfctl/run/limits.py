"""Limits of a worker process: their values, their enforcement, and the report of a failure."""

from __future__ import annotations

import gc
import os
import signal
import sys
import time
from collections.abc import Callable, Mapping
from types import FrameType
from typing import Any

from urdfctl.source.budget import OverBudget
from urdfctl.startup.records import NamedTuple

Json = dict[str, Any]
GRACE = 2.0
"""Seconds between the deadline inside a worker and the moment when its parent ends it."""
WAITING = 12.0
"""On a loaded machine, a job may take this multiple of its processor time."""
HAS_PROCESSES = sys.platform not in {"emscripten", "wasi"}
"""Whether there are other processes: a browser has none."""
CAN_FORK = hasattr(os, "fork") and sys.platform != "win32"


def processors() -> int:
    """Return how many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Limits(NamedTuple):
    """The limits of one job.

    seconds: processor time, in s: what a job may do does not depend on what else the machine does.
    memory: address space beyond that of the process that starts the workers, in bytes.
    environ: the environment variables that the job sees.
    waiting: the wall-clock time that the job may take, as a multiple of its processor time.
    """

    seconds: float
    memory: int
    environ: Mapping[str, str]
    waiting: float = WAITING

    @property
    def patience(self) -> float:
        """The wall-clock time that the job may take, in s."""
        return self.seconds * self.waiting

    @property
    def too_slow(self) -> str:
        """The reason for ending a job that takes longer than it may."""
        return f"it takes longer than {self.seconds:g} s"


class WorkerFailure(NamedTuple):
    """A job without a result.

    reason: in words.
    our_fault: True if an exception in urdfctl's own code was not caught.
    """

    reason: str
    our_fault: bool = False


Result = Json | WorkerFailure


def restrict(limits: Limits) -> None:
    """Limit the environment of this process, and the memory that it takes beyond what it has."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    gc.disable()  # a worker lives for milliseconds, and the memory limit still holds
    os.environ.clear()
    os.environ.update(limits.environ)
    _limit(resource.RLIMIT_AS, _address_space() + limits.memory)
    _limit(resource.RLIMIT_CORE, 0)
    if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:  # a shell's background jobs ignore it
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # the parent reports the interruption
    signal.signal(signal.SIGPROF, _raise_over_budget(limits))
    signal.signal(signal.SIGALRM, _raise_over_budget(limits))


def _address_space() -> int:
    """Return the bytes of memory that this process has mapped (proc(5), statm); 0 where it is not told."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    try:
        with open("/proc/self/statm", "rb") as file:
            return int(file.read().split()[0]) * resource.getpagesize()
    except (OSError, ValueError, IndexError):
        return 0


def start_clock(limits: Limits) -> None:
    """Give this process its time from now on; after that, OverBudget is raised."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    _limit(resource.RLIMIT_CPU, int(time.process_time() + limits.seconds + GRACE) + 1)
    signal.setitimer(signal.ITIMER_PROF, limits.seconds)
    signal.setitimer(signal.ITIMER_REAL, limits.patience)


def stop_clock() -> None:
    """Cancel the alarms, so that they cannot interrupt the writing of a result."""
    if sys.platform != "win32" and hasattr(signal, "setitimer"):  # a browser has no timers
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.setitimer(signal.ITIMER_REAL, 0)


def _limit(kind: int, wanted: int) -> None:
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    hard = resource.getrlimit(kind)[1]
    limit = wanted if hard == resource.RLIM_INFINITY else min(wanted, hard)
    try:
        resource.setrlimit(kind, (limit, hard))
    except (ValueError, OSError, OverflowError):  # macOS rejects RLIMIT_AS
        return


def _raise_over_budget(limits: Limits) -> Callable[[int, FrameType | None], None]:
    def on_alarm(_signal: int, _frame: FrameType | None) -> None:
        raise OverBudget(limits.too_slow)

    return on_alarm
