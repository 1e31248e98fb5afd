"""Runs jobs in worker processes that have little time, little memory and little of the environment.

What a worker sends back is JSON text, so nothing of a stranger's robot is ever unpickled or run by the parent. Where
the system can fork, a worker is a fork; elsewhere it is a fresh Python that runs `main`, with a limit of time only.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import FrameType

from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.source.budget import OverBudget

Json = dict[str, Any]
GRACE = 2.0
MAX_RESULT = 64 << 20
MOST_AT_ONCE = 128
"""More would meet the limits on open files, and help nobody."""
MOST_GROWTH = (48 << 20) if sys.platform == "darwin" else (48 << 10)
"""By how much a worker may have grown and go on with the next job, in the unit of ru_maxrss."""
CAN_FORK = hasattr(os, "fork") and sys.platform != "win32"


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Limits(NamedTuple):
    """Seconds and bytes for one job, and the environment it sees."""

    seconds: float
    memory: int
    environ: Mapping[str, str]


class Died(NamedTuple):
    """A worker that gave no result: `why`, in words."""

    why: str
    ours: bool = False
    """Whether it was our own fault: an exception that nothing caught."""


Result = Json | Died


def run(
    jobs: Sequence[Json],
    perform: Callable[[Json], Json],
    limits: Limits,
    parallel: int,
    *,
    fresh: str,
    together: int = 1,
    meanwhile: Callable[[], object] = lambda: None,
) -> Iterator[Result]:
    """The result of each job, in their order; as many at once as `parallel` says. `fresh` names what performs a job in
    a process that knows nothing of this one: `package.module:function`. A worker may do up to `together` jobs, one
    after the other, each within the limits; what one of them does not survive is tried again in a worker of its own.
    `meanwhile` is called when the first workers are at work."""
    if not CAN_FORK:
        yield from _run_all_fresh(jobs, limits, parallel, fresh)
        return
    at_once = min(max(parallel, 1), MOST_AT_ONCE)
    size = max(min(together, len(jobs) // (4 * at_once)), 1)
    pool = _Pool(
        jobs, perform, limits, [range(start, min(start + size, len(jobs))) for start in range(0, len(jobs), size)]
    )
    try:
        pool.fill(at_once)
        meanwhile()
        for wanted in range(len(jobs)):
            while wanted not in pool.results:
                pool.fill(at_once)
                pool.wait()
            yield pool.results.pop(wanted)
    finally:
        pool.kill()


class _Worker:
    """A process with the jobs it has still to do, and what it has written of the next result."""

    def __init__(self, jobs: range, pid: int, pipe: int, limits: Limits) -> None:
        self.jobs, self.pid, self.pipe, self.limits = jobs, pid, pipe, limits
        self.first = True
        self.text = bytearray()
        self.start_clock()

    def start_clock(self) -> None:
        self.deadline = time.monotonic() + self.limits.seconds + GRACE

    def kill(self) -> None:
        if sys.platform != "win32":
            os.kill(self.pid, signal.SIGKILL)
        self.reap()

    def reap(self) -> int:
        os.close(self.pipe)
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


class _Pool:
    """The workers at work, what is still to be given to one, and the results."""

    def __init__(
        self, jobs: Sequence[Json], perform: Callable[[Json], Json], limits: Limits, pending: list[range]
    ) -> None:
        self.jobs, self.perform, self.limits = jobs, perform, limits
        self.pending = pending[::-1]
        self.active: dict[int, _Worker] = {}
        self.results: dict[int, Result] = {}

    def fill(self, at_once: int) -> None:
        """Start workers, as long as there is something to do."""
        while self.pending and len(self.active) < at_once:
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
                _work([self.jobs[number] for number in numbers], self.perform, self.limits, writing)
                status = 0
            finally:
                os._exit(status)
        os.close(writing)
        return _Worker(numbers, pid, reading, self.limits)

    def wait(self) -> None:
        """Read what workers have written; end those that are done, silent for too long, or too talkative."""
        from select import select

        nearest = min(worker.deadline for worker in self.active.values())
        readable, _, _ = select(list(self.active), [], [], max(nearest - time.monotonic(), 0.0))
        for pipe in readable:
            worker = self.active[pipe]
            piece = os.read(pipe, 1 << 16)
            worker.text.extend(piece)
            if b"\n" in piece:
                self._take(worker)
            if not piece:
                del self.active[pipe]
                self._ended(worker, worker.reap())
        for worker in list(self.active.values()):
            too_late = time.monotonic() >= worker.deadline
            if too_late or len(worker.text) > MAX_RESULT:
                del self.active[worker.pipe]
                worker.kill()
                why = (
                    f"it takes longer than {self.limits.seconds:g} s"
                    if too_late
                    else "its findings are too many to hold"
                )
                self._settle(worker, Died(why))
                self._again(worker.jobs)

    def _take(self, worker: _Worker) -> None:
        *lines, rest = bytes(worker.text).split(b"\n")
        worker.text = bytearray(rest)
        for line in lines:
            self._settle(worker, _parsed(line))
            worker.start_clock()

    def _settle(self, worker: _Worker, result: Result) -> None:
        """Keep a result; but of one that went down with others before it, it is not sure that it was its own fault."""
        number = worker.jobs[0]
        worker.jobs = worker.jobs[1:]
        if isinstance(result, Died) and not worker.first:
            self._again(range(number, number + 1))
        else:
            self.results[number] = result
        worker.first = False

    def _again(self, numbers: range) -> None:
        if numbers:
            self.pending.append(numbers)

    def _ended(self, worker: _Worker, status: int) -> None:
        if worker.jobs and (status != 0 or worker.first):
            self._settle(worker, _death_of(status))
        self._again(worker.jobs)

    def kill(self) -> None:
        """End what is still at work."""
        for worker in self.active.values():
            worker.kill()


def _work(jobs: Sequence[Json], perform: Callable[[Json], Json], limits: Limits, pipe: int) -> None:
    """Do one job after the other, a result on each line, until so much memory is used that a new worker is better."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    at_start = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for job in jobs:
        start_clock(limits)
        _write(pipe, _performed(job, perform) + b"\n")
        if resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - at_start > MOST_GROWTH:
            return


def start_clock(limits: Limits) -> None:
    """Let this process have no more than so much time from now on; past it OverBudget is raised."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    _limit(resource.RLIMIT_CPU, int(time.process_time() + limits.seconds + GRACE) + 1)
    signal.setitimer(signal.ITIMER_REAL, limits.seconds)


def _limit(kind: int, wanted: int) -> None:
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    hard = resource.getrlimit(kind)[1]
    most = wanted if hard == resource.RLIM_INFINITY else min(wanted, hard)
    try:
        resource.setrlimit(kind, (most, hard))
    except (ValueError, OSError, OverflowError):  # macOS refuses RLIMIT_AS
        return


def _performed(job: Json, perform: Callable[[Json], Json]) -> bytes:
    """The result as JSON, or why there is none. The parent must hear of it, whatever it is."""
    try:
        text = json.dumps(perform(job)).encode()
        _disarm()
    except OverBudget as error:
        return _death(str(error), ours=False)
    except MemoryError:
        return _death("it needs more memory than a robot may take (see --memory)", ours=False)
    except BaseException as error:  # noqa: BLE001 (as said above)
        _disarm()
        import traceback

        last = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{os.path.basename(last.filename)}:{last.lineno} in {last.name}"
        return _death(f"{type(error).__name__}: {error} ({where})", ours=True)
    return text


def _death(why: str, *, ours: bool) -> bytes:
    return json.dumps({"died": why, "ours": ours}).encode()


def _disarm() -> None:
    """Let no alarm cut short what is being told."""
    if sys.platform != "win32":
        signal.setitimer(signal.ITIMER_REAL, 0)


def _write(pipe: int, text: bytes) -> None:
    view = memoryview(text)
    while view:
        view = view[os.write(pipe, view) :]


def restrict(limits: Limits) -> None:
    """Take from this process what a worker has no need of: memory, and most of the environment."""
    if sys.platform == "win32":
        raise NotImplementedError
    import resource

    gc.disable()  # a worker lives for milliseconds; the memory limit holds all the same
    os.environ.clear()
    os.environ.update(limits.environ)
    _limit(resource.RLIMIT_AS, limits.memory)
    _limit(resource.RLIMIT_CORE, 0)
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:  # as in a shell's background, where none is to be heard
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # the parent tells what is to be told
    signal.signal(signal.SIGALRM, _too_late(limits.seconds))


def _too_late(seconds: float) -> Callable[[int, FrameType | None], None]:
    def raise_it(_signal: int, _frame: FrameType | None) -> None:
        raise OverBudget(f"it takes longer than {seconds:g} s")

    return raise_it


def _death_of(status: int) -> Died:
    ended_by = signal.Signals(-status).name if status < 0 else ""
    if ended_by in {"SIGXCPU", "SIGKILL"}:
        return Died("it uses more time or memory than a robot needs")
    how = f"was ended by {ended_by}" if ended_by else f"ended with status {status}"
    return Died(f"the worker {how} and gave no result", ours=True)


def _parsed(text: bytes) -> Result:
    result: Json = json.loads(text)
    return Died(result["died"], result["ours"]) if "died" in result else result


# -- where there is no fork ------------------------------------------------------------------------------------------


def _run_all_fresh(jobs: Sequence[Json], limits: Limits, parallel: int, fresh: str) -> Iterator[Result]:
    from concurrent.futures import ThreadPoolExecutor

    pool = ThreadPoolExecutor(min(max(parallel, 1), MOST_AT_ONCE))
    try:
        yield from pool.map(lambda job: _run_fresh(job, limits, fresh), jobs)
    finally:
        pool.shutdown(cancel_futures=True)


_KEPT = ("PATH", "SYSTEMROOT", "PYTHONPATH", "VIRTUAL_ENV", "LD_LIBRARY_PATH")
_START = "import sys; sys.path[:] = sys.argv[1:]; from urdfctl.worker import main; main()"
"""Nothing is imported from the current folder, which may be a stranger's."""


def _run_fresh(job: Json, limits: Limits, fresh: str) -> Result:
    import subprocess

    keep = {name: os.environ[name] for name in _KEPT if name in os.environ}
    command = [sys.executable, "-c", _START, *(entry for entry in sys.path if entry)]
    try:
        done = subprocess.run(  # noqa: S603 (our own module)
            command,
            input=json.dumps({"perform": fresh, "job": job}).encode(),
            capture_output=True,
            timeout=limits.seconds + GRACE,
            env={**limits.environ, **keep},
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Died(f"it takes longer than {limits.seconds:g} s")
    if done.returncode or not done.stdout:
        last = done.stderr.decode("utf-8", "replace").strip().splitlines()[-1:]
        return Died(last[0] if last else f"the worker ended with status {done.returncode}", ours=True)
    return _parsed(done.stdout)


def main() -> None:
    """A fresh worker: one job on standard input, its result on standard output, as it was when the job began: a job may
    send its own elsewhere, as that of an engine does."""
    from importlib import import_module

    given = json.loads(sys.stdin.buffer.read())
    module, _, name = given["perform"].partition(":")
    perform = getattr(import_module(module), name)
    with os.fdopen(os.dup(1), "wb") as result:
        result.write(_performed(given["job"], perform))


if __name__ == "__main__":
    main()
