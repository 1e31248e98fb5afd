"""Run jobs in worker processes with little time, little memory and little of the environment.

Where the system can fork, a worker is a fork; elsewhere it is a fresh Python. In a browser, this process does the jobs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from urdfctl.run.fork import ForkPool, Standby
from urdfctl.run.limits import CAN_FORK, HAS_PROCESSES, Json, Limits, Result
from urdfctl.run.waiting import WaitingLine
from urdfctl.startup.records import NamedTuple

MAX_PARALLEL = 128
"""More workers would reach the limit on open files without being faster."""
_MAX_TOGETHER = 8
"""How many jobs that share work one worker does, while others may wait for work."""


class Division(NamedTuple):
    """How jobs are divided among workers.

    jobs_per_worker: how many jobs a forked worker may do, each within the limits.
    together: for each job, a key; neighbours with the same key share work and go to the same worker. Empty: none do.
    standby: where workers come from and wait for later jobs; they end after these jobs if None.
    """

    jobs_per_worker: int = 1
    together: Sequence[str] = ()
    standby: Standby | None = None


def _nothing() -> None:
    """Use the time for nothing."""


class Meanwhile(NamedTuple):
    """What happens in this process while the workers are busy.

    call: called once, after the first workers were started.
    doing: what a user on a terminal is told if it takes long, such as `working on arm.urdf`; empty for nothing.
    """

    call: Callable[[], object] = _nothing
    doing: str = ""


def run_jobs(
    jobs: Sequence[Json],
    function: Callable[[Json], Json],
    limits: Limits,
    parallel: int,
    *,
    function_name: str,
    division: Division = Division(),  # noqa: B008 (immutable)
    meanwhile: Meanwhile = Meanwhile(),  # noqa: B008 (immutable)
) -> Iterator[Result]:
    """Yield the result of each job, in order.

    parallel: how many workers run at the same time, up to MAX_PARALLEL.
    function_name: `package.module:function`, used instead of `function` where the system cannot fork.
    division: of the jobs among forked workers.
    meanwhile: what happens here while the workers are busy.
    """
    parallel = min(max(parallel, 1), MAX_PARALLEL)
    if not HAS_PROCESSES:
        from urdfctl.run.here import run_all_here

        meanwhile.call()
        yield from run_all_here(jobs, function, limits)
        return
    if not CAN_FORK:
        from urdfctl.run.fresh import run_all_fresh

        yield from run_all_fresh(jobs, function_name, limits, parallel)
        return
    size = max(min(division.jobs_per_worker, len(jobs) // (4 * parallel)), 1)
    shares = _shares(division.together or [""] * len(jobs), size)
    pool, line = ForkPool(jobs, function, limits, shares, division.standby), WaitingLine(meanwhile.doing, len(jobs))
    try:
        pool.fill(parallel)
        meanwhile.call()
        for number in range(len(jobs)):
            while number not in pool.results:
                pool.fill(parallel)
                pool.wait(line.seconds)
                line.show(number)
            line.erase()
            yield pool.results.pop(number)
    finally:
        line.erase()
        pool.kill()


def _shares(keys: Sequence[str], size: int) -> list[range]:
    """Part jobs into ranges of `size`, and of more where the neighbours at the end share a key."""
    shares: list[range] = []
    start = 0
    for end in range(1, len(keys) + 1):
        shared = end < len(keys) and keys[end] and keys[end] == keys[end - 1]
        if end == len(keys) or end - start >= (max(size, _MAX_TOGETHER) if shared else size):
            shares.append(range(start, end))
            start = end
    return shares
