"""Jobs in this process end within their time, and a failure of one harms no other."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import threading
import time
from types import FunctionType

import pytest
from folder import CHECKOUT, Folder, environment
from hostile.robots import HIDDEN, TRIED
from sampling import sample

from urdfctl.run.here import Clock, run_all_here
from urdfctl.run.limits import Json, Limits, WorkerFailure
from urdfctl.server.analysis.workspace import EditorSettings, Workspace
from urdfctl.source.budget import OverBudget

LIMITS = Limits(seconds=0.05, memory=1 << 30, environ={})


def endless(job: Json) -> Json:
    while job:
        pass
    return {"done": True}


def failing(job: Json) -> Json:
    raise ValueError(job["text"])


def test_a_job_that_takes_too_long_is_ended_and_the_next_one_is_done() -> None:
    slow, quick = run_all_here([{"endless": True}, {}], endless, LIMITS)
    assert slow == WorkerFailure(LIMITS.too_slow)
    assert quick == {"done": True}


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_an_interruption_that_is_lost_is_repeated() -> None:
    """The interpreter prints and forgets what is raised in a callback of the garbage collector."""

    class Forgetting:
        def __del__(self) -> None:
            endless({"endless": True})

    def job(_: Json) -> Json:
        Forgetting()
        return endless({"endless": True})

    [result] = run_all_here([{}], job, LIMITS)
    assert result == WorkerFailure(LIMITS.too_slow)


def test_a_job_that_raises_is_a_failure_of_its_own() -> None:
    [result] = run_all_here([{"text": "broken"}], failing, LIMITS)
    assert isinstance(result, WorkerFailure)
    assert result.our_fault
    assert "ValueError: broken" in result.reason


def test_a_job_that_only_waits_uses_no_time() -> None:
    [result] = run_all_here([{}], lambda _: {"slept": time.sleep(4 * LIMITS.seconds)}, LIMITS)
    assert result == {"slept": None}


def test_a_job_that_waits_for_ever_is_ended_after_a_multiple_of_its_time() -> None:
    def waiting(_: Json) -> Json:
        while True:
            time.sleep(0.01)

    [result] = run_all_here([{}], waiting, LIMITS)
    assert result == WorkerFailure(LIMITS.too_slow)


def test_the_clock_interrupts_only_the_thread_that_it_watches() -> None:
    ended: list[str] = []

    def watched() -> None:
        try:
            with Clock(LIMITS):
                endless({"endless": True})
        except OverBudget:
            ended.append("in time")

    thread = threading.Thread(target=watched)
    thread.start()
    thread.join(timeout=20)
    assert ended == ["in time"]


def hold(end: float, left: list[float]) -> None:
    while time.process_time() < end:
        pass
    left.append(end)


@pytest.mark.parametrize("module", ["logging", "_weakrefset"])
def test_code_that_may_hold_a_lock_or_lose_an_error_is_interrupted_when_it_is_left(module: str) -> None:
    of_module = FunctionType(hold.__code__, {"__name__": module, "time": time})
    left: list[float] = []

    def job(_: Json) -> Json:
        of_module(time.process_time() + 6 * LIMITS.seconds, left)
        return endless({"endless": True})

    assert list(run_all_here([{}], job, LIMITS)) == [WorkerFailure(LIMITS.too_slow)]
    assert len(left) == 1


@pytest.mark.parametrize("tried", sample(TRIED, 4))
def test_a_hostile_file_in_an_editor_gets_the_findings_of_the_command_line(folder: Folder, tried: str) -> None:
    _, files = TRIED[tried]
    folder.write({"secret": HIDDEN, "pull/.git/HEAD": "", **{f"pull/{name}": text for name, text in files.items()}})
    (folder.path / "pull" / "out").symlink_to(folder.path)
    ran = folder.run("lint", "pull", "--format", "json", "--exit-zero", "--timeout", "50")
    expected = sorted(finding["code"] for finding in json.loads(ran.stdout)["findings"]) if ran.stdout else []
    found = Workspace(str(folder.path / "pull"), EditorSettings()).check().findings
    assert sorted(finding.code for findings in found.values() for finding in findings) == expected
    assert HIDDEN not in repr(found)
    assert not (folder.path / "ran").exists()


BROWSER = """
import sys
sys.platform = "emscripten"
sys.path[:1] = []

class Missing:
    def find_spec(self, name, path=None, target=None):
        if name in {"fcntl", "grp", "pwd", "resource", "syslog", "termios", "pty", "tty", "_multiprocessing"}:
            raise ModuleNotFoundError(f"a browser has no {name}", name=name)

for name in ("fcntl", "grp", "pwd", "resource", "syslog", "termios", "pty", "tty"):
    sys.modules.pop(name, None)
sys.meta_path.insert(0, Missing())

import multiprocessing, os, subprocess, threading

def refuse(*_, **__):
    raise AssertionError("a browser has no other processes")

def without_threads(*_, **__):
    raise RuntimeError("can't start new thread")

for name in ("fork", "forkpty", "posix_spawn", "posix_spawnp", "system", "popen", "execv", "execve", "waitpid", "kill"):
    setattr(os, name, refuse)
subprocess.Popen.__init__ = subprocess.run = multiprocessing.Process.start = refuse
threading.Thread.start = without_threads
"""
"""What is not there where Python runs in a browser, as Pyodide documents it."""
RUN = "from urdfctl.__main__ import main; main()"
RADU, MYBOT = str(CHECKOUT / "samples/radu/urdf/radu.urdf.xacro"), str(CHECKOUT / "samples/mybot/urdf/mybot.xacro")
IN_A_BROWSER = {
    "lint": ("lint", str(CHECKOUT / "samples"), "--format", "json", "--no-cache"),
    "lint again": ("lint", str(CHECKOUT / "samples/broken/mybot")),
    "fix": ("lint", str(CHECKOUT / "samples/broken/mybot"), "--diff"),
    "explain a rule": ("explain", "UC201"),
    "explain a message": ("explain", "No p gain specified for pid.", "--in", str(CHECKOUT / "samples/broken")),
    "gen-controllers": ("gen-controllers", MYBOT, "--type", "effort", "--distro", "noetic"),
    "gen-transmissions": ("gen-transmissions", MYBOT, "--type", "effort", "--distro", "noetic"),
    "gen-all": ("gen-all", RADU, "--type", "velocity", "--distro", "humble", "-o", "made"),
    "gen-check": ("gen-check", str(CHECKOUT / "samples/mybot")),
}


def texts(folder: Folder) -> dict[str, bytes]:
    """What is in the files of a folder."""
    return {str(path): path.read_bytes() for path in sorted(folder.path.rglob("*")) if path.is_file()}


@pytest.mark.parametrize("name", IN_A_BROWSER)
def test_where_there_are_no_processes_and_no_threads_the_result_is_the_same(
    folder: Folder, name: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    own = tmp_path_factory.mktemp("browser")  # it takes all other processes for ended, and deletes what they left
    words = IN_A_BROWSER[name]
    ran = folder.run(*words)
    made = texts(folder)
    shutil.rmtree(folder.path / "made", ignore_errors=True)
    ran_here = subprocess.run(
        [sys.executable, "-c", BROWSER + RUN, *words],
        cwd=folder.path,
        env=environment({"PYTHONPATH": str(CHECKOUT), "TMPDIR": str(own)}),
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert (ran_here.returncode, ran_here.stdout, ran_here.stderr) == (ran.returncode, ran.stdout, ran.stderr)
    assert texts(folder) == made


def test_where_there_are_no_processes_open_texts_are_linted(folder: Folder) -> None:
    """The layer below the editor's server."""
    folder.write({"arm.urdf": '<robot name="arm"><link name="base"/></robot>'})
    code = (
        "from urdfctl.server.analysis.workspace import EditorSettings, Workspace\n"
        "here = Workspace(os.getcwd(), EditorSettings())\n"
        "here.changed('arm.urdf', b'<robot name=\"arm\"><lnk name=\"base\"/></robot>')\n"
        "print(sorted(found.message for all in here.check().findings.values() for found in all))\n"
    )
    ran = subprocess.run(
        [sys.executable, "-c", BROWSER + code],
        cwd=folder.path,
        env=environment({"PYTHONPATH": str(CHECKOUT)}),
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert "<lnk>" in ran.stdout, ran.stderr
