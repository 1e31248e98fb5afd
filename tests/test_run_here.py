"""Jobs in this process end within their time, and a failure of one harms no other."""

from __future__ import annotations

import json
import threading

import pytest
from folder import CHECKOUT, Folder
from sampling import sample
from test_hostile_files import HIDDEN, TRIED
from typer.testing import CliRunner

from urdfctl.cli.app import app
from urdfctl.run import pool
from urdfctl.run.here import Clock, run_all_here
from urdfctl.run.limits import Json, Limits, WorkerFailure
from urdfctl.server.workspace import Wishes, Workspace
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


@pytest.mark.parametrize("tried", sample(TRIED, 4))
def test_a_hostile_file_in_an_editor_gets_the_findings_of_the_command_line(folder: Folder, tried: str) -> None:
    _, files = TRIED[tried]
    folder.write({"secret": HIDDEN, "pull/.git/HEAD": "", **{f"pull/{name}": text for name, text in files.items()}})
    (folder.path / "pull" / "out").symlink_to(folder.path)
    ran = folder.run("lint", "pull", "--format", "json", "--exit-zero", "--timeout", "50")
    expected = sorted(finding["code"] for finding in json.loads(ran.stdout)["findings"]) if ran.stdout else []
    found = Workspace(str(folder.path / "pull"), Wishes()).check().findings
    assert sorted(finding.code for findings in found.values() for finding in findings) == expected
    assert HIDDEN not in repr(found)
    assert not (folder.path / "ran").exists()


def test_without_other_processes_lint_finds_the_same(monkeypatch: pytest.MonkeyPatch, folder: Folder) -> None:
    """As Python in a browser has none."""
    words = ["lint", str(CHECKOUT / "samples"), "--format", "json", "--no-cache", "--exit-zero"]
    expected = folder.run(*words).stdout
    monkeypatch.setattr(pool, "HAS_PROCESSES", False)
    assert CliRunner().invoke(app, words).stdout == expected
