"""A stranger's files make no command read, list or look for anything outside of the workspace.

Each of the hostile projects is read by every command that may read it, watched.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Sequence
from pathlib import Path

import pytest
from folder import Folder
from hostile_projects import CANARY, CASES, FILES, HOME, Hostile, laid_out
from sampling import WHOLE, sample
from watched import Watched, watched

pytestmark = pytest.mark.skipif(os.name != "posix", reason="links are made as POSIX makes them")


def run(case: Hostile, folder: Path, words: Sequence[str]) -> tuple[Watched, Path]:
    home, pull = folder / "home", folder / "pull"
    laid_out(home, HOME, {}, home)
    laid_out(pull, {**FILES, **case.files}, case.links, home)
    return run_again(folder, words, "scratch"), home


def run_again(folder: Path, words: Sequence[str], scratch: str) -> Watched:
    environ = {"HOME": str(folder / "home"), "CANARY_VARIABLE": CANARY}
    return watched(words, folder / "pull", folder / scratch, environ)


def written(folder: Path) -> list[Path]:
    """The files in a folder and below it, not those that links lead to."""
    return [path for path in folder.rglob("*") if path.is_file() and not path.is_symlink()]


def chosen_runs() -> list[tuple[str, int]]:
    """The first command of each case, and another one of each third case, not the same one for all; all of them in
    tests/bench/exhaustive."""
    chosen = []
    for place, (name, case) in enumerate(CASES.items()):
        numbers, others = range(len(case.words)), max(1, len(case.words) - 1)
        other = (1 + place // 3 % others) % len(numbers) if place % 3 == 0 else 0
        wanted = numbers if WHOLE or case.is_named else {0, other}
        chosen += [(name, number) for number in sorted(wanted)]
    return chosen


@pytest.mark.parametrize(("name", "number"), chosen_runs())
def test_nothing_outside_of_the_workspace_is_read(folder: Folder, name: str, number: int) -> None:
    case = CASES[name]
    done, home = run(case, folder.path, case.words[number])
    told = " ".join((done.ran.stdout + done.ran.stderr).split())
    assert done.ran.returncode in {0, 1, 2, 5}, told
    assert done.read_in(home) == set()
    assert case.is_named or done.looked_at_in(home) == set()
    assert done.read_outside(folder.path / "pull", folder.path / "scratch") == set()
    assert CANARY not in told
    assert [path for path in written(folder.path / "pull") if CANARY.encode() in path.read_bytes()] == []
    if number == 0:
        assert case.said in told


@pytest.mark.parametrize("name", sample([name for name, case in CASES.items() if not case.is_named], 6))
def test_what_is_said_does_not_depend_on_what_is_outside(folder: Folder, name: str) -> None:
    """Neither on what a file holds, nor on whether there is one, nor on whether it is a folder."""
    words = CASES[name].words[0]
    there, home = run(CASES[name], folder.path, words)
    shutil.rmtree(home)
    home.mkdir()
    gone = run_again(folder.path, words, "scratch2")
    for target in CASES[name].links.values():
        path = Path(target.replace("{home}", str(home)))
        if path.is_relative_to(home) and not path.exists():
            path.mkdir(parents=True)
    folders = run_again(folder.path, words, "scratch3")
    said = [(done.ran.returncode, done.ran.stdout, done.ran.stderr) for done in (there, gone, folders)]
    assert said == [said[0]] * 3
