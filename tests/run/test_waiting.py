"""On a terminal, a line tells what is being done while workers take long, and is gone before anything else is shown."""

from __future__ import annotations

import io
import re
import time

import pytest

from urdfctl.run import pool, waiting
from urdfctl.run.limits import Json, Limits
from urdfctl.run.pool import Meanwhile, run_jobs

LIMITS = Limits(20.0, 2 << 30, {})


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def slow(job: Json) -> Json:
    time.sleep(job["seconds"])
    return job


def printed(
    monkeypatch: pytest.MonkeyPatch, stream: io.StringIO, doing: str, *seconds: float, after: float = 0.05
) -> str:
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setattr(waiting, "AFTER", after)
    monkeypatch.setenv("TERM", "xterm")
    jobs = [{"seconds": each} for each in seconds]
    results = run_jobs(jobs, slow, LIMITS, 1, function_name="", meanwhile=Meanwhile(doing=doing))
    stream.writelines("|" for _ in results)
    return stream.getvalue()


@pytest.mark.skipif(not pool.CAN_FORK, reason="this system cannot fork")
class TestWaitingLine:
    def test_tells_what_is_being_done_and_how_much_of_it(self, monkeypatch: pytest.MonkeyPatch) -> None:
        text = printed(monkeypatch, Terminal(), "working on 2 robots", 0.2, 0.2)
        for done in (0, 1):
            assert re.search(rf"urdfctl: working on 2 robots, {done} of 2 done \(\d+ s\)", text)

    def test_is_erased_before_anything_else_is_shown(self, monkeypatch: pytest.MonkeyPatch) -> None:
        text = printed(monkeypatch, Terminal(), "working", 0.2)
        assert text.endswith("\r\x1b[K|")

    def test_is_not_shown_for_what_is_quick(self, monkeypatch: pytest.MonkeyPatch) -> None:
        assert printed(monkeypatch, Terminal(), "working", 0.0, after=60.0) == "|"

    @pytest.mark.parametrize(("stream", "doing"), [(io.StringIO(), "working"), (Terminal(), "")])
    def test_is_not_shown_to_a_program_or_without_a_text(
        self, monkeypatch: pytest.MonkeyPatch, stream: io.StringIO, doing: str
    ) -> None:
        assert printed(monkeypatch, stream, doing, 0.2) == "|"

    def test_names_of_files_cannot_control_the_terminal(self, monkeypatch: pytest.MonkeyPatch) -> None:
        text = printed(monkeypatch, Terminal(), "working on a\x1b[2Jb.urdf", 0.2)
        assert "\x1b[2J" not in text
