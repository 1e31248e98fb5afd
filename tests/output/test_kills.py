"""A run that is killed leaves all files as they were or as they should be, and the next one cleans up after it."""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from typing import BinaryIO

import pytest
from folder import CHECKOUT, Folder, environment
from killing import SCENARIOS

from urdfctl.output.change import Change
from urdfctl.output.journal import journal

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")


@pytest.mark.parametrize("by", ["SIGKILL", "SIGTERM", "SIGINT"])
@pytest.mark.parametrize("scenario", SCENARIOS)
def test_a_run_that_ends_before_any_of_its_changes_leaves_old_or_new(folder: Folder, scenario: str, by: str) -> None:
    words = [sys.executable, str(CHECKOUT / "tests/helpers/processes/killing.py"), scenario, by]
    ran = subprocess.run(words, env=environment({}), capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout
    told = re.search(r"at change (\d+): all changes made", ran.stdout)
    assert told is not None
    assert int(told[1]) > 2, "each scenario changes several things"


def test_a_run_whose_new_journal_another_run_holds_writes_nothing_into_it(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    fcntl = pytest.importorskip("fcntl")
    made: list[BinaryIO] = []
    new = tempfile.mkstemp

    def held(**options: str) -> tuple[int, str]:
        handle, path = new(**options)
        made.append(open(path, "rb"))  # noqa: SIM115 (closed below)
        fcntl.flock(made[0], fcntl.LOCK_EX)
        return handle, path

    monkeypatch.setenv("XDG_CACHE_HOME", str(folder.path / "cache"))
    monkeypatch.setattr(tempfile, "mkstemp", held)
    with journal([Change(str(folder.path / "a"), None, b"new", 0o644)], []):
        assert made[0].read() == b""
    made[0].close()
