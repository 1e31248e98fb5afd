"""The bar of a long run: on terminals, and nowhere else."""

from __future__ import annotations

import os
import pty
import re
import subprocess
import sys
import threading
from collections.abc import Mapping

import pytest
from folder import Folder, environment

SOUND = '<robot name="arm"><link name="base"/></robot>\n'


def on_a_terminal(folder: Folder, *words: str, environ: Mapping[str, str | None] | None = None) -> tuple[str, str]:
    """What `urdfctl lint` writes to its standard output, a pipe, and to its standard error, a terminal."""
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-m", "urdfctl", "lint", *words],
        cwd=folder.path,
        env=environment({"TERM": "xterm-256color", **(environ or {})}),
        stdout=subprocess.PIPE,
        stderr=theirs,
        text=True,
    )
    os.close(theirs)
    told: list[bytes] = []
    reader = threading.Thread(target=_read, args=(ours, told))
    reader.start()
    out, _ = process.communicate(timeout=60)
    reader.join(60)
    os.close(ours)
    return out, b"".join(told).decode()


def _read(terminal: int, told: list[bytes]) -> None:
    try:
        while piece := os.read(terminal, 65536):
            told.append(piece)
    except OSError:  # Linux tells the end of a terminal so
        return


def robots(folder: Folder, number: int) -> list[str]:
    names = [f"r{index:02}.urdf" for index in range(number)]
    folder.write(dict.fromkeys(names, SOUND))
    return names


COLOURED = re.compile(r"\x1b\[[0-9;]*(?:3[0-8]|9[0-7])[0-9;]*m")


def test_many_robots_have_a_bar_that_goes_when_they_are_done(folder: Folder) -> None:
    names = robots(folder, 25)
    out, told = on_a_terminal(folder, *names)
    assert "linting" in told
    assert "25/25" in told
    assert COLOURED.search(told)
    assert told.endswith("\x1b[2K")
    assert out == folder.run("lint", *names).stdout


def test_the_bar_is_plain_where_colours_are_not_wanted(folder: Folder) -> None:
    _, told = on_a_terminal(folder, *robots(folder, 25), environ={"NO_COLOR": "1"})
    assert "25/25" in told
    assert not COLOURED.search(told)


@pytest.mark.parametrize(("number", "environ"), [(19, {}), (25, {"TERM": "dumb"})])
def test_there_is_none_for_few_robots_nor_where_it_could_not_move(
    folder: Folder, number: int, environ: dict[str, str | None]
) -> None:
    assert on_a_terminal(folder, *robots(folder, number), environ=environ)[1] == ""


def test_there_is_none_in_a_pipe(folder: Folder) -> None:
    assert folder.run("lint", *robots(folder, 25), environ={"TERM": "xterm", "FORCE_COLOR": "1"}).stderr == ""
