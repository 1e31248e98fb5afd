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
from typing import Any, NamedTuple

from urdfctl.source.budget import OverBudget

Json = dict[str, Any]
GRACE = 2.0
MAX_RESULT = 64 << 20
MOST_AT_ONCE = 128
"""More would meet the limits on open files, and help nobody."""
CAN_FORK = hasattr(os, "fork") and sys.platform != "win32"


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
    jobs: Sequence[Json], perform: Callable[[Json], Json], limits: Limits, parallel: int, *, fresh: str
) -> Iterator[Result]:
    """The result of each job, in their order; as many at once as `parallel` says. `fresh` names what performs a job in
    a process that knows nothing of this one: `package.module:function`."""
    if not CAN_FORK:
        yield from _run_all_fresh(jobs, limits, parallel, fresh)
        return
    at_once = min(max(parallel, 1), MOST_AT_ONCE)
    results: dict[int, Result] = {}
    pending = list(enumerate(jobs))[::-1]
    active: dict[int, _Worker] = {}
    try:
        for wanted in range(len(jobs)):
            while wanted not in results:
                while pending and len(active) < at_once:
                    index, job = pending.pop()
                    worker = _fork(index, job, perform, limits)
                    active[worker.pipe] = worker
                _wait(active, results)
            yield results.pop(wanted)
    finally:
        for worker in active.values():
            worker.kill()


class _Worker(NamedTuple):
    job: int
    pid: int
    pipe: int
    deadline: float
    seconds: float
    text: bytearray

    def kill(self) -> None:
        os.kill(self.pid, signal.SIGKILL)
        self.reap()

    def reap(self) -> int:
        os.close(self.pipe)
        return os.waitpid(self.pid, 0)[1]


def _fork(index: int, job: Json, perform: Callable[[Json], Json], limits: Limits) -> _Worker:
    sys.stdout.flush()
    sys.stderr.flush()
    reading, writing = os.pipe()
    pid = os.fork()
    if pid == 0:
        os.close(reading)
        status = 1
        try:
            _restrict(limits)
            _write(writing, _performed(job, perform))
            status = 0
        finally:
            os._exit(status)
    os.close(writing)
    return _Worker(index, pid, reading, time.monotonic() + limits.seconds + GRACE, limits.seconds, bytearray())


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
    if CAN_FORK:
        signal.setitimer(signal.ITIMER_REAL, 0)


def _write(pipe: int, text: bytes) -> None:
    view = memoryview(text)
    while view:
        view = view[os.write(pipe, view) :]


def _restrict(limits: Limits) -> None:
    import resource

    gc.disable()  # a worker lives for milliseconds; the memory limit holds all the same
    os.environ.clear()
    os.environ.update(limits.environ)
    seconds = int(limits.seconds + GRACE) + 1
    for kind, wanted in (
        (resource.RLIMIT_AS, limits.memory),
        (resource.RLIMIT_CPU, seconds),
        (resource.RLIMIT_CORE, 0),
    ):
        hard = resource.getrlimit(kind)[1]
        most = wanted if hard == resource.RLIM_INFINITY else min(wanted, hard)
        try:
            resource.setrlimit(kind, (most, hard))
        except (ValueError, OSError, OverflowError):  # macOS refuses RLIMIT_AS
            continue
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:  # as in a shell's background, where none is to be heard
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # the parent tells what is to be told
    signal.signal(signal.SIGALRM, _too_late(limits.seconds))
    signal.setitimer(signal.ITIMER_REAL, limits.seconds)


def _too_late(seconds: float) -> Callable[[int, FrameType | None], None]:
    def raise_it(_signal: int, _frame: FrameType | None) -> None:
        raise OverBudget(f"it takes longer than {seconds:g} s")

    return raise_it


def _wait(active: dict[int, _Worker], results: dict[int, Result]) -> None:
    """Read what workers have written; end those that are done, silent for too long, or too talkative."""
    from select import select

    now = time.monotonic()
    nearest = min(worker.deadline for worker in active.values())
    readable, _, _ = select(list(active), [], [], max(nearest - now, 0.0))
    for pipe in readable:
        worker = active[pipe]
        piece = os.read(pipe, 1 << 16)
        worker.text.extend(piece)
        if not piece:
            del active[pipe]
            results[worker.job] = _result(worker)
    for worker in list(active.values()):
        too_late = time.monotonic() >= worker.deadline
        if too_late or len(worker.text) > MAX_RESULT:
            del active[worker.pipe]
            worker.kill()
            why = f"it takes longer than {worker.seconds:g} s" if too_late else "its findings are too many to hold"
            results[worker.job] = Died(why)


def _result(worker: _Worker) -> Result:
    number = os.waitstatus_to_exitcode(worker.reap())
    if number == 0 and worker.text:
        return _parsed(bytes(worker.text))
    if -number in (signal.SIGXCPU, signal.SIGKILL):
        return Died("it uses more time or memory than a robot needs")
    how = f"was ended by {signal.Signals(-number).name}" if number < 0 else f"ended with status {number}"
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
