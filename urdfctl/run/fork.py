"""A pool of worker processes that are forks of this one and do one job after the other."""

from __future__ import annotations

import json
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
_KILLED = (9, 15)
"""SIGKILL and SIGTERM, which another program sends, or the system if memory is short: not a fault of the job."""


class Standby:
    """Workers that have done their jobs and wait for the next ones, for which they need not import and read again.

    All jobs that they get must have the same function and the same limits.
    """

    def __init__(self) -> None:
        self.idle: list[_Worker] = []

    def close(self) -> None:
        """End the workers."""
        while self.idle:
            self.idle.pop().kill()

    def take(self, numbers: range, jobs: Sequence[Json]) -> _Worker | None:
        """Return a waiting worker that was given jobs; None if there is none."""
        while self.idle:
            worker = self.idle.pop()
            try:
                worker.give(numbers, jobs)
            except BrokenPipeError:  # it has grown too much, and left
                worker.reap()
                continue
            return worker
        return None


class ForkPool:
    """Forked workers, the jobs that wait for one, and the results.

    pending: ranges of job numbers; each range goes to one worker.
    retried: the first numbers of ranges that need a new worker, as another did not do them.
    killed: the jobs whose worker was killed: each is tried once more, as another program may have done it.
    standby: where workers come from and go to; a worker ends after its jobs if None.
    """

    def __init__(
        self,
        jobs: Sequence[Json],
        function: Callable[[Json], Json],
        limits: Limits,
        pending: list[range],
        standby: Standby | None = None,
    ) -> None:
        self.jobs, self.function, self.limits, self.standby = jobs, function, limits, standby
        self.pending = pending[::-1]
        self.retried: set[int] = set()
        self.killed: set[int] = set()
        self.active: dict[int, _Worker] = {}
        self.results: dict[int, Result] = {}

    def fill(self, parallel: int) -> None:
        """Start workers until `parallel` are active or no job is waiting."""
        while self.pending and len(self.active) < parallel:
            numbers = self.pending.pop()
            worker = (None if numbers.start in self.retried else self._waiting(numbers)) or self._fork(numbers)
            self.active[worker.pipe] = worker

    def _waiting(self, numbers: range) -> _Worker | None:
        return self.standby.take(numbers, self._jobs(numbers)) if self.standby else None

    def _jobs(self, numbers: range) -> list[Json]:
        return [self.jobs[number] for number in numbers]

    def _fork(self, numbers: range) -> _Worker:
        if sys.platform == "win32":
            raise NotImplementedError
        sys.stdout.flush()
        sys.stderr.flush()
        reading, writing = os.pipe()
        inbox, outbox = os.pipe() if self.standby else (None, None)
        pid = os.fork()
        if pid == 0:
            status = 1
            try:
                os.close(reading)
                self._close_outboxes(outbox)
                restrict(self.limits)
                _work_on(self._jobs(numbers), self.function, self.limits, pipe=writing, inbox=inbox)
                status = 0
            finally:
                os._exit(status)
        os.close(writing)
        if inbox is not None:
            os.close(inbox)
        return _Worker(numbers, pid, reading, outbox, self.limits)

    def _close_outboxes(self, own: int | None) -> None:
        """Close what only the parent writes to: a worker whose parent has ended reads the end of its inbox."""
        others = [*self.active.values(), *(self.standby.idle if self.standby else ())]
        for outbox in [own, *(worker.outbox for worker in others)]:
            if outbox is not None:
                os.close(outbox)

    def wait(self, seconds: float | None = None) -> None:
        """Read what workers have written, for so many seconds at most; end those that are done, too slow, or write too
        much."""
        from select import select

        nearest = min(worker.deadline for worker in self.active.values())
        left = max(nearest - time.monotonic(), 0.0)
        readable, _, _ = select(list(self.active), [], [], left if seconds is None else min(left, seconds))
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
        elif not piece:
            del self.active[worker.pipe]
            self._ended(worker, worker.reap())

    def _take_results(self, worker: _Worker) -> None:
        *lines, rest = bytes(worker.text).split(b"\n")
        worker.text = bytearray(rest)
        for line in lines:
            result = decoded_result(line)
            self._settle(worker, result)
            worker.start_clock()
            worker.is_sound = worker.is_sound and not isinstance(result, WorkerFailure)
        if self.standby and not worker.jobs:
            del self.active[worker.pipe]
            if worker.is_sound:
                self.standby.idle.append(worker)
            else:
                worker.kill()

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
            self.retried.add(numbers.start)

    def _ended(self, worker: _Worker, status: int) -> None:
        if worker.jobs and -status in _KILLED and worker.jobs[0] not in self.killed:
            self.killed.add(worker.jobs[0])
        elif worker.jobs and (status != 0 or worker.is_at_first_job):
            self._settle(worker, _failure_of(status, worker.limits))
        self._retry(worker.jobs)

    def kill(self) -> None:
        """End all active workers."""
        for worker in self.active.values():
            worker.kill()


class _Worker:
    """A process, the numbers of the jobs it has not done yet, and what it has written of the next result.

    pipe: the results are read from it. outbox: more jobs are written to it; None if the process ends after its jobs.
    """

    def __init__(self, jobs: range, pid: int, pipe: int, outbox: int | None, limits: Limits) -> None:
        self.jobs, self.pid, self.pipe, self.outbox, self.limits = jobs, pid, pipe, outbox, limits
        self.is_at_first_job = self.is_sound = True
        self.text = bytearray()
        self.start_clock()

    def give(self, numbers: range, jobs: Sequence[Json]) -> None:
        """Give more jobs to a process that has none. BrokenPipeError: it has ended."""
        if self.outbox is None:
            raise ValueError("this worker ends after its jobs")
        _write(self.outbox, json.dumps(jobs).encode() + b"\n")
        self.jobs = numbers
        self.start_clock()

    def start_clock(self) -> None:
        self.deadline = time.monotonic() + self.limits.patience + GRACE

    def kill(self) -> None:
        if sys.platform != "win32":
            os.kill(self.pid, signal.SIGKILL)
        self.reap()

    def reap(self) -> int:
        os.close(self.pipe)
        if self.outbox is not None:
            os.close(self.outbox)
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def _work_on(
    jobs: Sequence[Json], function: Callable[[Json], Json], limits: Limits, *, pipe: int, inbox: int | None
) -> None:
    """Write one result a line: of some jobs, then of those that come. This process ends if it has grown too much."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    at_start = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    while jobs:
        for job in jobs:
            start_clock(limits)
            _write(pipe, encoded_result(job, function) + b"\n")
            if resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - at_start > MAX_GROWTH:
                return
        jobs = _next_jobs(inbox) if inbox is not None else ()


def _next_jobs(inbox: int) -> list[Json]:
    """Wait for jobs; none if the parent wants no more of them."""
    text = bytearray()
    while not text.endswith(b"\n"):
        piece = os.read(inbox, 1 << 16)
        if not piece:
            return []
        text += piece
    jobs: list[Json] = json.loads(text)
    return jobs


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
