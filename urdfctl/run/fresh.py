"""Workers where the system cannot fork: fresh Python processes, limited in time only."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator, Sequence

from urdfctl.run.limits import GRACE, Json, Limits, Result, WorkerFailure
from urdfctl.run.results import decoded_result
from urdfctl.startup.isolation import python_command

_KEPT_VARIABLES = ("PATH", "SYSTEMROOT", "PYTHONPATH", "VIRTUAL_ENV", "LD_LIBRARY_PATH")
_START = "from urdfctl.run.fresh import main; main()"


def run_all_fresh(jobs: Sequence[Json], function_name: str, limits: Limits, parallel: int) -> Iterator[Result]:
    """Yield the result of each job, in order.

    function_name: `package.module:function`, imported in the fresh process.
    """
    from concurrent.futures import ThreadPoolExecutor

    pool = ThreadPoolExecutor(parallel)
    try:
        yield from pool.map(lambda job: _run_fresh(job, function_name, limits), jobs)
    finally:
        pool.shutdown(cancel_futures=True)


def _run_fresh(job: Json, function_name: str, limits: Limits) -> Result:
    import subprocess

    request = {"function": function_name, "job": job, "limits": limits._replace(environ={})._asdict()}
    kept = {name: os.environ[name] for name in _KEPT_VARIABLES if name in os.environ}
    try:
        process = subprocess.run(  # noqa: S603 (our own module)
            python_command(_START),
            input=json.dumps(request).encode(),
            capture_output=True,
            timeout=limits.patience + GRACE,
            env={**limits.environ, **kept},
            check=False,
        )
    except subprocess.TimeoutExpired:
        return WorkerFailure(limits.too_slow)
    if process.returncode or not process.stdout:
        last = process.stderr.decode("utf-8", "replace").strip().splitlines()[-1:]
        return WorkerFailure(last[0] if last else f"the worker ended with status {process.returncode}", our_fault=True)
    return decoded_result(process.stdout)


def main() -> None:
    """Do the job on standard input, and write its result to standard output.

    The descriptor is duplicated first: a job may redirect standard output, as physics engines do.
    """
    from importlib import import_module

    from urdfctl.run.here import encoded_within

    request = json.loads(sys.stdin.buffer.read())
    module, _, name = request["function"].partition(":")
    function = getattr(import_module(module), name)
    with os.fdopen(os.dup(1), "wb") as output:
        output.write(encoded_within(Limits(**request["limits"]), request["job"], function))


if __name__ == "__main__":
    main()
