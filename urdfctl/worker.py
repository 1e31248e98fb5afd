"""Runs jobs in worker processes that have little time, little memory and little of the environment.

What a worker sends back is JSON text, so nothing of a stranger's robot is ever unpickled or run by the parent. Where the
system can fork, a worker is a fork; elsewhere it is a fresh `python -m urdfctl.worker`.
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


def run(jobs: Sequence[Json], perform: Callable[[Json], Json], limits: Limits, parallel: int) -> Iterator[Result]:
    """The result of each job, in their order; as many at once as `parallel` says."""
    if not CAN_FORK:
        for job in jobs:
            yield _run_fresh(job, limits)
        return
    results: dict[int, Result] = {}
    pending = list(enumerate(jobs))[::-1]
    active: dict[int, _Worker] = {}
    try:
        for wanted in range(len(jobs)):
            while wanted not in results:
                while pending and len(active) < max(parallel, 1):
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
    try:
        return json.dumps(perform(job)).encode()
    except BaseException as error:  # noqa: BLE001 (the parent must hear of it, whatever it is)
        import traceback

        last = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{os.path.basename(last.filename)}:{last.lineno} in {last.name}"
        return json.dumps({"died": f"{type(error).__name__}: {error} ({where})"}).encode()


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
    for kind, value in (
        (resource.RLIMIT_AS, limits.memory),
        (resource.RLIMIT_CPU, seconds),
        (resource.RLIMIT_CORE, 0),
    ):
        hard = resource.getrlimit(kind)[1]
        value = value if hard == resource.RLIM_INFINITY else min(value, hard)
        try:
            resource.setrlimit(kind, (value, hard))
        except (ValueError, OSError):  # macOS refuses RLIMIT_AS
            continue
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
    status = worker.reap()
    if worker.text:
        return _parsed(bytes(worker.text))
    number = os.waitstatus_to_exitcode(status)
    if -number in (signal.SIGXCPU, signal.SIGKILL):
        return Died("it uses more time or memory than a robot needs")
    return Died(f"the worker ended with status {number} and said nothing", ours=number != 0)


def _parsed(text: bytes) -> Result:
    result: Json = json.loads(text)
    return Died(result["died"], ours=True) if "died" in result else result


def _run_fresh(job: Json, limits: Limits) -> Result:
    import subprocess

    keep = {
        name: os.environ[name] for name in ("PATH", "SYSTEMROOT", "PYTHONPATH", "VIRTUAL_ENV") if name in os.environ
    }
    command = [sys.executable, "-m", "urdfctl.worker"]
    try:
        done = subprocess.run(  # noqa: S603 (our own module)
            command,
            input=json.dumps(job).encode(),
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
    """A fresh worker: one job on standard input, its result on standard output."""
    from urdfctl.load import perform

    job = json.loads(sys.stdin.buffer.read())
    sys.stdout.buffer.write(_performed(job, perform))


if __name__ == "__main__":
    main()
