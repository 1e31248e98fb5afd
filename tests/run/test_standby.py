"""Workers that wait for more jobs: they remember, are replaced if they fail, and never outlive who started them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from urdfctl.run import fork
from urdfctl.run.limits import CAN_FORK, Json, Limits
from urdfctl.run.pool import Division, run_jobs

GENEROUS = Limits(20.0, 2 << 30, {})

needs_fork = pytest.mark.skipif(not CAN_FORK, reason="this system cannot fork")


def with_standby(perform: Callable[[Json], Json], standby: fork.Standby, jobs: int = 1) -> list[Any]:
    return list(
        run_jobs(
            [{"number": number} for number in range(jobs)],
            perform,
            GENEROUS,
            2,
            function_name="",
            division=Division(standby=standby),
        )
    )


@pytest.fixture
def standby() -> Iterator[fork.Standby]:
    with closing(fork.Standby()) as standby:
        yield standby


@needs_fork
def test_a_worker_on_standby_does_the_next_jobs_and_remembers_what_it_read(standby: fork.Standby) -> None:
    read: list[int] = []

    def perform(job: Json) -> Json:
        read.append(job["number"])
        return {"worker": os.getpid(), "read": list(read)}

    [first] = with_standby(perform, standby)
    [second] = with_standby(perform, standby)
    assert second == {"worker": first["worker"], "read": [0, 0]}
    assert read == []


@needs_fork
def test_more_workers_are_forked_than_are_on_standby(standby: fork.Standby) -> None:
    def perform(job: Json) -> Json:
        time.sleep(0.2)
        return {"worker": os.getpid()}

    [first] = with_standby(perform, standby)
    later = {result["worker"] for result in with_standby(perform, standby, jobs=2)}
    assert first["worker"] in later
    assert len(later) == 2


@needs_fork
def test_a_job_that_fails_in_a_worker_from_standby_is_tried_in_a_fresh_one(standby: fork.Standby) -> None:
    done: list[int] = []

    def perform(job: Json) -> Json:
        if done:
            raise ValueError("spoilt by another job")
        done.append(1)
        return {"worker": os.getpid()}

    [first] = with_standby(perform, standby)
    [second] = with_standby(perform, standby)
    assert first["worker"] != second["worker"]


@needs_fork
def test_a_worker_that_has_grown_too_much_does_not_wait(standby: fork.Standby, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fork, "MAX_GROWTH", -1)
    [first] = with_standby(lambda job: {"worker": os.getpid()}, standby)
    [second] = with_standby(lambda job: {"worker": os.getpid()}, standby)
    assert first["worker"] != second["worker"]


@needs_fork
def test_a_worker_that_died_on_standby_is_replaced(standby: fork.Standby) -> None:
    [first] = with_standby(lambda job: {"worker": os.getpid()}, standby)
    os.kill(first["worker"], signal.SIGKILL)
    [second] = with_standby(lambda job: {"worker": os.getpid()}, standby)
    assert first["worker"] != second["worker"]


@needs_fork
def test_no_worker_waits_after_the_end(standby: fork.Standby) -> None:
    results = with_standby(lambda job: {"worker": os.getpid()}, standby, jobs=2)
    standby.close()
    for result in results:
        with pytest.raises(ProcessLookupError):
            os.kill(result["worker"], 0)


@needs_fork
def test_workers_on_standby_end_when_the_process_that_asked_them_was_killed() -> None:
    started = (
        "import os, sys, time\n"
        "from urdfctl.run.fork import Standby\n"
        "from urdfctl.run.limits import Limits\n"
        "from urdfctl.run.pool import Division, run_jobs\n"
        "def perform(job): time.sleep(0.2); return {'worker': os.getpid()}\n"
        "division = Division(standby=Standby())\n"
        "limits = Limits(20.0, 2 << 30, {})\n"
        "for result in run_jobs([{}, {}], perform, limits, 2, function_name='', division=division):\n"
        "    print(result['worker'], flush=True)\n"
        "os.kill(os.getpid(), 9)\n"
    )
    workers = subprocess.run(
        [sys.executable, "-c", started], capture_output=True, text=True, check=False
    ).stdout.split()
    assert len(workers) == 2
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline and any(map(_is_running, workers)):
        time.sleep(0.05)
    assert not any(map(_is_running, workers))


def _is_running(pid: str) -> bool:
    """Whether a process runs; one that has ended and that nobody waits for does not."""
    try:
        status = Path(f"/proc/{pid}/stat").read_text() if sys.platform == "linux" else ""
        os.kill(int(pid), 0)
    except (OSError, ValueError):
        return False
    return status.rpartition(")")[2].split()[:1] != ["Z"]
