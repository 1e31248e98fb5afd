"""Workers give results in order, keep to their limits, and tell how they died."""

from __future__ import annotations

import fcntl
import mmap
import os
import re
import resource
import signal
import time
from collections.abc import Callable
from itertools import repeat
from pathlib import Path
from typing import Any

import pytest
from folder import Folder
from sampling import WHOLE

from urdfctl.config.settings import Settings
from urdfctl.expand.job import expand_file
from urdfctl.lint.job import lint_all
from urdfctl.lint.selection import Selection
from urdfctl.load.target import Target
from urdfctl.run import fork, fresh, pool
from urdfctl.run.limits import Json, Limits, WorkerFailure
from urdfctl.run.pool import Division, run_jobs

GENEROUS = Limits(20.0, 2 << 30, {})
SHORT = Limits(0.3, 2 << 30, {})

needs_fork = pytest.mark.skipif(not pool.CAN_FORK, reason="this system cannot fork")


def results(perform: Callable[[Json], Json], limits: Limits = GENEROUS, jobs: int = 1, parallel: int = 1) -> list[Any]:
    return list(run_jobs([{"number": number} for number in range(jobs)], perform, limits, parallel, function_name=""))


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Workers that do not end by themselves are waited for only a little longer than they may take."""
    monkeypatch.setattr(fork, "GRACE", 0.2)


@needs_fork
def test_a_job_that_only_waits_uses_no_time() -> None:
    assert results(lambda job: {"slept": time.sleep(2 * SHORT.seconds)}, SHORT) == [{"slept": None}]


@needs_fork
def test_results_come_in_the_order_of_the_jobs_though_the_first_takes_longest() -> None:
    def perform(job: Json) -> Json:
        time.sleep(0.2 - 0.05 * job["number"])
        return job

    assert results(perform, jobs=4, parallel=4) == [{"number": number} for number in range(4)]


@needs_fork
def test_as_many_jobs_as_asked_for_run_at_once(tmp_path: Path) -> None:
    def perform(job: Json) -> Json:
        (tmp_path / f"{job['number']}.started").touch()
        while len(started := list(tmp_path.glob("*.started"))) < 2:  # the first two wait for each other
            time.sleep(0.01)
        ended = list(tmp_path.glob("*.ended"))
        (tmp_path / f"{job['number']}.ended").touch()
        return {"started": len(started), "ended": len(ended)}

    first, second, third = results(perform, jobs=3, parallel=2)
    assert first["started"] - first["ended"] <= 2
    assert second["started"] - second["ended"] <= 2
    assert (third["started"], third["ended"] > 0) == (3, True)


@needs_fork
def test_more_jobs_at_once_than_files_may_be_open_are_no_crash(monkeypatch: pytest.MonkeyPatch) -> None:
    if not WHOLE:
        monkeypatch.setattr(pool, "MAX_PARALLEL", 20)
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    few = len(os.listdir("/dev/fd")) + pool.MAX_PARALLEL + 12
    jobs = 1500 if WHOLE else few
    resource.setrlimit(resource.RLIMIT_NOFILE, (soft if WHOLE else few, hard))
    try:
        assert results(lambda job: job, jobs=jobs, parallel=100_000) == [{"number": number} for number in range(jobs)]
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))


@needs_fork
def test_a_result_larger_than_a_pipe_holds_arrives_whole() -> None:
    [found] = results(lambda job: {"text": "x" * 3_000_000})
    assert found == {"text": "x" * 3_000_000}


@needs_fork
def test_a_result_larger_than_anybody_would_read_ends_the_worker(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fork, "MAX_RESULT", 100_000)
    assert results(lambda job: {"text": "x" * 3_000_000}) == [WorkerFailure("its findings need more than 64 MiB")]


@needs_fork
def test_a_job_that_sleeps_past_its_time_is_ended_in_time() -> None:
    assert results(lambda job: {"slept": time.sleep(30)}, SHORT) == [WorkerFailure("it takes longer than 0.3 s")]


@needs_fork
def test_a_job_in_a_loop_of_c_code_is_ended_too(quick: None) -> None:
    found = results(lambda job: {"matched": any(repeat(0))}, SHORT)
    assert found == [WorkerFailure("it takes longer than 0.3 s")]


@needs_fork
def test_a_job_that_will_not_hear_of_its_end_is_ended_all_the_same(quick: None) -> None:
    def perform(job: Json) -> Json:
        while True:
            try:
                time.sleep(30)
            except Exception:  # noqa: BLE001, S112
                continue

    assert results(perform, SHORT) == [WorkerFailure("it takes longer than 0.3 s")]


@needs_fork
def test_a_job_that_is_too_late_costs_the_others_nothing(quick: None) -> None:
    def perform(job: Json) -> Json:
        time.sleep(30 if job["number"] == 0 else 0)
        return job

    late, other = results(perform, SHORT._replace(seconds=1.0, waiting=1.5), jobs=2, parallel=2)
    assert late == WorkerFailure("it takes longer than 1 s")
    assert other == {"number": 1}


@needs_fork
def test_a_job_that_wants_too_much_memory_is_told_so_and_is_no_crash() -> None:
    [found] = results(lambda job: {"length": len(bytearray(1 << 30))}, Limits(20.0, 512 << 20, {}))
    assert found == WorkerFailure("it needs more memory than one robot may use (see --memory)", our_fault=False)


@needs_fork
def test_memory_that_the_starting_process_has_mapped_is_not_counted() -> None:
    with mmap.mmap(-1, 1 << 30):
        found = results(lambda job: {"length": len(bytearray(1 << 26))}, Limits(20.0, 512 << 20, {}))
    assert found == [{"length": 1 << 26}]


@needs_fork
def test_a_worker_that_is_killed_for_its_memory_or_time_is_no_crash() -> None:
    [found] = results(lambda job: {"killed": os.kill(os.getpid(), signal.SIGKILL)})
    assert found == WorkerFailure("it uses more time or memory than one robot may use", our_fault=False)


@needs_fork
@pytest.mark.parametrize("by", [signal.SIGKILL, signal.SIGTERM])
def test_a_job_whose_worker_another_program_kills_is_done_by_another_worker(by: int, tmp_path: Path) -> None:
    def perform(job: Json) -> Json:
        if job["number"] == 0 and not (tmp_path / "killed").exists():
            (tmp_path / "killed").touch()
            os.kill(os.getpid(), by)
        return job

    assert results(perform, jobs=2) == [{"number": 0}, {"number": 1}]


@needs_fork
def test_a_worker_that_dies_by_another_signal_is_our_fault() -> None:
    [found] = results(lambda job: {"killed": os.kill(os.getpid(), signal.SIGUSR1)})
    assert found == WorkerFailure("the worker was ended by SIGUSR1 and gave no result", our_fault=True)


@needs_fork
def test_a_worker_that_leaves_without_a_word_is_our_fault() -> None:
    assert results(lambda job: os._exit(7)) == [
        WorkerFailure("the worker ended with status 7 and gave no result", our_fault=True)
    ]


def one_after_the_other(perform: Callable[[Json], Json], limits: Limits = GENEROUS, jobs: int = 16) -> list[Any]:
    """The results of jobs of which one worker does up to four."""
    return list(
        run_jobs(
            [{"number": number} for number in range(jobs)], perform, limits, 1, function_name="", division=Division(4)
        )
    )


def numbered(results: list[Any]) -> list[Any]:
    return [result["number"] if isinstance(result, dict) else result for result in results]


@needs_fork
def test_a_worker_does_several_jobs_where_there_are_many() -> None:
    found = one_after_the_other(lambda job: {**job, "worker": os.getpid()})
    assert numbered(found) == list(range(16))
    assert len({result["worker"] for result in found}) == 4


@needs_fork
@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        (["", "a", "a", "a", "b", "b", "", ""], ["0", "123", "45", "6", "7"]),
        (["a"] * 9, ["01234567", "8"]),
        (["a", "b", "a"], ["0", "1", "2"]),
    ],
)
def test_neighbours_that_share_work_go_to_the_same_worker(keys: list[str], expected: list[str]) -> None:
    jobs = [{"number": number} for number in range(len(keys))]
    done: dict[int, str] = {}
    for job in run_jobs(
        jobs,
        lambda job: {**job, "worker": os.getpid()},
        GENEROUS,
        2,
        function_name="",
        division=Division(together=keys),
    ):
        assert isinstance(job, dict)
        done[job["worker"]] = done.get(job["worker"], "") + str(job["number"])
    assert list(done.values()) == expected


@needs_fork
def test_a_job_that_dies_among_others_is_the_only_one_without_a_result() -> None:
    def perform(job: Json) -> Json:
        if job["number"] in (2, 4):
            os.kill(os.getpid(), signal.SIGKILL)
        return job

    died = WorkerFailure("it uses more time or memory than one robot may use")
    assert numbered(one_after_the_other(perform)) == [0, 1, died, 3, died, *range(5, 16)]


@needs_fork
def test_a_job_that_takes_too_long_among_others_is_ended_within_its_own_time(quick: None) -> None:
    def perform(job: Json) -> Json:
        time.sleep(30 if job["number"] == 1 else 0.1)
        return job

    late = WorkerFailure("it takes longer than 1 s")
    assert numbered(one_after_the_other(perform, SHORT._replace(seconds=1.0, waiting=1.5))) == [0, late, *range(2, 16)]


@needs_fork
def test_what_fails_after_others_is_tried_again_by_itself() -> None:
    held: list[bytearray] = []

    def perform(job: Json) -> Json:
        held.append(bytearray(1200 << 20 if job["number"] in (1, 2) else 1))
        return job

    room_for_one = Limits(20.0, address_space() + (1800 << 20), {})
    assert numbered(one_after_the_other(perform, room_for_one)) == list(range(16))


def address_space() -> int:
    """Bytes that this process, and so its forks, has taken already, where the system tells."""
    told = Path("/proc/self/statm")
    return int(told.read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE") if told.exists() else 0


@needs_fork
def test_half_a_result_is_no_result(monkeypatch: pytest.MonkeyPatch) -> None:
    before = set(_writable_pipes().values())

    def perform(job: Json) -> Json:
        [result] = [number for number, pipe in _writable_pipes().items() if pipe not in before]
        os.write(result, b'{"number": ')
        os.kill(os.getpid(), signal.SIGKILL)
        return job

    assert results(perform) == [WorkerFailure("it uses more time or memory than one robot may use")]


def _writable_pipes() -> dict[int, str]:
    """The pipes that this process can write to, by their numbers."""
    links = {name: _link(name) for name in os.listdir("/proc/self/fd")}
    pipes = {int(name): link for name, link in links.items() if link.startswith("pipe:")}
    return {number: link for number, link in pipes.items() if fcntl.fcntl(number, fcntl.F_GETFL) & os.O_WRONLY}


def _link(name: str) -> str:
    try:
        return os.readlink(f"/proc/self/fd/{name}")
    except OSError:
        return ""


@needs_fork
def test_an_exception_of_ours_is_told_with_its_place() -> None:
    def perform(job: Json) -> Json:
        raise LookupError("no such thing")

    [found] = results(perform)
    assert found.our_fault
    assert re.fullmatch(r"LookupError: no such thing \(test_worker.py:\d+ in perform\)", found.reason)


@needs_fork
def test_a_worker_sees_only_the_environment_it_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SECRET_TOKEN", "xyz")
    [found] = results(lambda job: dict(os.environ), Limits(20.0, 2 << 30, {"ROS_DISTRO": "noetic"}))
    assert found == {"ROS_DISTRO": "noetic"}


@needs_fork
def test_workers_end_with_the_run_that_no_longer_wants_them(tmp_path: Path) -> None:
    written = tmp_path / "pid"

    def perform(job: Json) -> Json:
        if job["number"] == 1:
            (tmp_path / "partial").write_text(str(os.getpid()))
            (tmp_path / "partial").rename(written)
            time.sleep(30)
        while not written.exists():
            time.sleep(0.01)
        return job

    running = run_jobs([{"number": 0}, {"number": 1}], perform, GENEROUS, 2, function_name="")
    next(running)
    os.kill(int(written.read_text()), 0)
    running.close()
    with pytest.raises(ProcessLookupError):
        os.kill(int(written.read_text()), 0)


# -- where there is no fork ------------------------------------------------------------------------------------------

ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="base" default="base"/>
  <link name="$(arg base)"/>
  <xacro:wheel/>
</robot>
"""


@pytest.fixture
def without_fork(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pool, "CAN_FORK", False)


def test_without_fork_the_findings_are_the_same(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    folder.write({"a.xacro": ROBOT, "b.xacro": ROBOT.replace("wheel", "arm")})
    targets = [Target("a.xacro"), Target("b.xacro", (("base", "foot"),))]
    settings = Settings(distro="noetic", package_paths=(".",), started=("arm",))
    forked = list(lint_all(targets, settings, Selection(ignore=("UC1",))))
    monkeypatch.setattr(pool, "CAN_FORK", False)
    assert list(lint_all(targets, settings, Selection(ignore=("UC1",)))) == forked
    assert [[d.code for d in linted.outcome.diagnostics] for linted in forked] == [["UC008"], ["UC008"]]


def test_without_fork_a_file_is_expanded_all_the_same(folder: Folder, without_fork: None) -> None:
    folder.write({"a.xacro": ROBOT.replace("<xacro:wheel/>", "")})
    expanded = expand_file("a.xacro", {"base": "foot"}, Settings())
    assert not expanded.problems
    assert '<link name="foot"/>' in (expanded.text or "")


def test_without_fork_nothing_is_imported_from_the_current_folder(folder: Folder, without_fork: None) -> None:
    spy = "import pathlib; pathlib.Path('was_run').touch()"
    folder.write({"a.xacro": ROBOT, "yaml.py": spy, "json.py": spy, "xacro/__init__.py": spy, "xacro/xmlutils.py": spy})
    [linted] = lint_all([Target("a.xacro")], Settings(), Selection())
    assert [diagnostic.code for diagnostic in linted.outcome.diagnostics] == ["UC008"]
    assert not (folder.path / "was_run").exists()


def test_without_fork_a_job_past_its_time_is_ended(
    folder: Folder, without_fork: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fresh, "GRACE", 0.0)
    folder.write({"a.xacro": ROBOT})
    [linted] = lint_all([Target("a.xacro")], Settings(timeout=0.001), Selection())
    assert [diagnostic.code for diagnostic in linted.outcome.diagnostics] == ["UC014"]


def test_without_fork_a_job_that_sends_its_standard_output_elsewhere_is_heard(
    folder: Folder, without_fork: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    loud = "import os\ndef perform(job):\n    os.dup2(os.open('said', os.O_WRONLY | os.O_CREAT), 1)\n    return job\n"
    folder.write({"apart/loud.py": loud})
    monkeypatch.syspath_prepend(folder.path / "apart")
    assert list(run_jobs([{"number": 3}], dict, GENEROUS, 1, function_name="loud:perform")) == [{"number": 3}]


def test_without_fork_an_exception_of_ours_is_told(folder: Folder, without_fork: None) -> None:
    [found] = run_jobs(
        [{"function": "urdfctl.lint.job:lint_work", "target": "of the wrong form"}],
        dict,
        GENEROUS,
        1,
        function_name="urdfctl.lint.job:perform_alone",
    )
    assert isinstance(found, WorkerFailure)
    assert found.our_fault
    assert "job.py" in found.reason


def test_without_fork_a_worker_sees_only_the_environment_it_is_given(
    folder: Folder, without_fork: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SECRET_TOKEN", "xyz")
    folder.write({"a.xacro": ROBOT.replace("<xacro:wheel/>", '<link name="$(env SECRET_TOKEN)"/>')})
    expanded = expand_file("a.xacro", {}, Settings())
    assert expanded.text is None
    assert [problem.message for problem in expanded.problems] == [
        "environment variable 'SECRET_TOKEN' is not set, or is not passed to xacro"
    ]
