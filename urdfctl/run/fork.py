"""A pool of worker processes that are forks of this one and do one job after the other."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Callable, Sequence

from urdfctl.run.limits import GRACE, Json, Limits, Result, WorkerFailure, restrict, start_clock
from urdfctl.run.results import decoded_result, encoded_result

MAX_RESULT = 64 << 20
"""Bytes that a worker may send without ending a line."""
MAX_GROWTH = (48 << 20) if sys.platform == "darwin" else (48 << 10)
"""By how much a worker may have grown and still take another job, in the unit of ru_maxrss."""


class ForkPool:
    """Forked workers, the jobs that wait for one, and the results.

    pending: ranges of job numbers; each range goes to one worker.
    """

    def __init__(
        self, jobs: Sequence[Json], function: Callable[[Json], Json], limits: Limits, pending: list[range]
    ) -> None:
        self.jobs, self.function, self.limits = jobs, function, limits
        self.pending = pending[::-1]
        self.active: dict[int, _Worker] = {}
        self.results: dict[int, Result] = {}

    def fill(self, parallel: int) -> None:
        """Start workers until `parallel` are active or no job is waiting."""
        while self.pending and len(self.active) < parallel:
            worker = self._fork(self.pending.pop())
            self.active[worker.pipe] = worker

    def _fork(self, numbers: range) -> _Worker:
        if sys.platform == "win32":
            raise NotImplementedError
        sys.stdout.flush()
        sys.stderr.flush()
        reading, writing = os.pipe()
        pid = os.fork()
        if pid == 0:
            os.close(reading)
            status = 1
            try:
                restrict(self.limits)
                _work([self.jobs[number] for number in numbers], self.function, self.limits, writing)
                status = 0
            finally:
                os._exit(status)
        os.close(writing)
        return _Worker(numbers, pid, reading, self.limits)

    def wait(self) -> None:
        """Read what workers have written; end those that are done, too slow, or write too much."""
        from select import select

        nearest = min(worker.deadline for worker in self.active.values())
        readable, _, _ = select(list(self.active), [], [], max(nearest - time.monotonic(), 0.0))
        for pipe in readable:
            self._read(self.active[pipe])
        for worker in list(self.active.values()):
            too_slow = time.monotonic() >= worker.deadline
            if too_slow or len(worker.text) > MAX_RESULT:
                del self.active[worker.pipe]
                worker.kill()
                reason = self.limits.too_slow if too_slow else "its findings need more than 64 MiB"
                self._settle(worker, WorkerFailure(reason))
                self._retry(worker.jobs)

    def _read(self, worker: _Worker) -> None:
        piece = os.read(worker.pipe, 1 << 16)
        worker.text.extend(piece)
        if b"\n" in piece:
            self._take_results(worker)
        if not piece:
            del self.active[worker.pipe]
            self._ended(worker, worker.reap())

    def _take_results(self, worker: _Worker) -> None:
        *lines, rest = bytes(worker.text).split(b"\n")
        worker.text = bytearray(rest)
        for line in lines:
            self._settle(worker, decoded_result(line))
            worker.start_clock()

    def _settle(self, worker: _Worker, result: Result) -> None:
        """Keep a result. A failure after other jobs is tried again alone: those may have caused it."""
        number = worker.jobs[0]
        worker.jobs = worker.jobs[1:]
        if isinstance(result, WorkerFailure) and not worker.is_at_first_job:
            self._retry(range(number, number + 1))
        else:
            self.results[number] = result
        worker.is_at_first_job = False

    def _retry(self, numbers: range) -> None:
        if numbers:
            self.pending.append(numbers)

    def _ended(self, worker: _Worker, status: int) -> None:
        if worker.jobs and (status != 0 or worker.is_at_first_job):
            self._settle(worker, _failure_of(status, worker.limits))
        self._retry(worker.jobs)

    def kill(self) -> None:
        """End all active workers."""
        for worker in self.active.values():
            worker.kill()


class _Worker:
    """A process, the numbers of the jobs it has not done yet, and what it has written of the next result."""

    def __init__(self, jobs: range, pid: int, pipe: int, limits: Limits) -> None:
        self.jobs, self.pid, self.pipe, self.limits = jobs, pid, pipe, limits
        self.is_at_first_job = True
        self.text = bytearray()
        self.start_clock()

    def start_clock(self) -> None:
        self.deadline = time.monotonic() + self.limits.patience + GRACE

    def kill(self) -> None:
        if sys.platform != "win32":
            os.kill(self.pid, signal.SIGKILL)
        self.reap()

    def reap(self) -> int:
        os.close(self.pipe)
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def _work(jobs: Sequence[Json], function: Callable[[Json], Json], limits: Limits, pipe: int) -> None:
    """Write one result a line, until the jobs are done or this process has grown by MAX_GROWTH."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    at_start = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for job in jobs:
        start_clock(limits)
        _write(pipe, encoded_result(job, function) + b"\n")
        if resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - at_start > MAX_GROWTH:
            return


def _write(pipe: int, text: bytes) -> None:
    view = memoryview(text)
    while view:
        view = view[os.write(pipe, view) :]


def _failure_of(status: int, limits: Limits) -> WorkerFailure:
    from signal import Signals

    signal_name = Signals(-status).name if status < 0 else ""
    if signal_name == "SIGXCPU":
        return WorkerFailure(limits.too_slow)
    if signal_name == "SIGKILL":
        return WorkerFailure("it uses more time or memory than one robot may use")
    how = f"was ended by {signal_name}" if signal_name else f"ended with status {status}"
    return WorkerFailure(f"the worker {how} and gave no result", our_fault=True)
