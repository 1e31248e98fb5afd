"""Run jobs in this process: for an editor's server, and where the system has no other processes (a browser).

The limit on time is the same as in a worker. There is none on memory: this process lives on. What a job may read of
the environment is that of its settings, as everywhere.
"""

from __future__ import annotations

import ctypes
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from types import TracebackType

from urdfctl.run.limits import Json, Limits, Result
from urdfctl.run.results import decoded_result, encoded_result
from urdfctl.source.budget import OverBudget


def run_all_here(jobs: Sequence[Json], function: Callable[[Json], Json], limits: Limits) -> Iterator[Result]:
    """Yield the result of each job, in order."""
    for job in jobs:
        yield decoded_result(encoded_within(limits, job, function))


def encoded_within(limits: Limits, job: Json, function: Callable[[Json], Json]) -> bytes:
    """Return a job's result, or the reason why there is none, as one line of JSON."""
    try:
        with Clock(limits):
            return encoded_result(job, function)
    except OverBudget:  # between the end of the job and that of the clock
        return encoded_result(job, _raiser(OverBudget(limits.too_slow)))


def _raiser(error: Exception) -> Callable[[Json], Json]:
    def function(_: Json) -> Json:
        raise error

    return function


def _without_arguments(reason: str) -> type[OverBudget]:
    """OverBudget with a reason, as a class: another thread can only be given a class."""

    class TimeIsUp(OverBudget):
        def __init__(self) -> None:
            super().__init__(reason)

    return TimeIsUp


_AGAIN = 1.0
"""Seconds after which work that is still not interrupted is interrupted again."""
_LEAST = 0.02
"""Seconds between two looks at the clock, at least."""
_NOT_INTERRUPTED = frozenset(
    {"threading", "logging", "importlib._bootstrap", "coverage.collector", "weakref", "_weakrefset"}
)
"""Modules whose code is not interrupted: a lock that it has just taken would be held for ever, and what is raised in a
callback for a dead object is lost."""


def _clock_of(thread: int) -> Callable[[], float]:
    """Return a function that returns the processor time of a thread in s; that of the process if there is none."""
    if sys.platform == "win32" or not hasattr(time, "pthread_getcpuclockid"):
        return time.process_time
    try:
        clock = time.pthread_getcpuclockid(thread)
    except OSError:  # a browser has the function, and no such clock
        return time.process_time
    return lambda: time.clock_gettime(clock)


def _may_be_interrupted(thread: int) -> bool:
    """Return whether what is raised in the innermost Python code of a thread leaves it, and does no harm there."""
    frame = sys._current_frames().get(thread)
    return frame is None or frame.f_globals.get("__name__") not in _NOT_INTERRUPTED


class Clock:
    """Raises OverBudget in the thread that entered it, after its time or when `stop` is called.

    Python code is interrupted at its next bytecode, and again until it leaves: what is raised in a callback of the
    garbage collector is lost. Without threads, nothing is interrupted. Where the processor time of one thread cannot
    be asked for, that of the process counts.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._error = _without_arguments(limits.too_slow)
        self._lock = threading.Lock()
        self._thread: int | None = None
        self._timer: threading.Timer | None = None

    def __enter__(self) -> None:
        self._thread = threading.get_ident()
        self._clock = _clock_of(self._thread)
        self._end, self._deadline = self._clock() + self._limits.seconds, time.monotonic() + self._limits.patience
        self._timer = self._started(self._limits.seconds, self._look)

    def _look(self) -> None:
        """Stop the thread if its time is over; otherwise look again when it can be."""
        with self._lock:
            left = self._end - self._clock() if self._thread is not None else 0.0
            if left > 0 and time.monotonic() < self._deadline:
                self._timer = self._started(max(left, _LEAST), self._look)
                return
        self.stop()

    def _started(self, seconds: float, then: Callable[[], None]) -> threading.Timer | None:
        timer = threading.Timer(seconds, then)
        timer.daemon = True
        try:
            timer.start()
        except RuntimeError:  # a browser has no threads
            return None
        return timer

    def __exit__(self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None) -> None:
        with self._lock:
            self._thread = None
        if self._timer is not None:
            self._timer.cancel()

    def stop(self) -> None:
        """Interrupt the thread that is between entering and leaving."""
        with self._lock:
            if self._thread is None:
                return
            again = _LEAST
            if _may_be_interrupted(self._thread):
                ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), ctypes.py_object(self._error))
                again = _AGAIN
            self._timer = self._started(again, self.stop)
