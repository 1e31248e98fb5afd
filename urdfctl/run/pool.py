"""Run jobs in worker processes with little time, little memory and little of the environment.

Where the system can fork, a worker is a fork; elsewhere it is a fresh Python.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from urdfctl.run.fork import ForkPool
from urdfctl.run.limits import CAN_FORK, Json, Limits, Result

MAX_PARALLEL = 128
"""More workers would reach the limit on open files without being faster."""


def run_jobs(
    jobs: Sequence[Json],
    function: Callable[[Json], Json],
    limits: Limits,
    parallel: int,
    *,
    function_name: str,
    jobs_per_worker: int = 1,
    meanwhile: Callable[[], object] = lambda: None,
) -> Iterator[Result]:
    """Yield the result of each job, in order.

    parallel: how many workers run at the same time, up to MAX_PARALLEL.
    function_name: `package.module:function`, used instead of `function` where the system cannot fork.
    jobs_per_worker: how many jobs a forked worker may do, each within the limits.
    meanwhile: called once, after the first workers were started.
    """
    parallel = min(max(parallel, 1), MAX_PARALLEL)
    if not CAN_FORK:
        from urdfctl.run.fresh import run_all_fresh

        yield from run_all_fresh(jobs, function_name, limits, parallel)
        return
    size = max(min(jobs_per_worker, len(jobs) // (4 * parallel)), 1)
    shares = [range(start, min(start + size, len(jobs))) for start in range(0, len(jobs), size)]
    pool = ForkPool(jobs, function, limits, shares)
    try:
        pool.fill(parallel)
        meanwhile()
        for number in range(len(jobs)):
            while number not in pool.results:
                pool.fill(parallel)
                pool.wait()
            yield pool.results.pop(number)
    finally:
        pool.kill()
