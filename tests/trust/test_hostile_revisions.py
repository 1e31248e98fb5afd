"""Git revisions that strangers made: nothing is written outside of its folder, and none of their programs runs."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest
from folder import Folder
from hostile.revisions import TREES
from revisions import repository
from seeds import ARM

SECRET = b"what nobody may read"


def contents(folder: Path) -> dict[str, bytes]:
    """Return all files below a folder but those of git."""
    found = (path for path in folder.rglob("*") if path.is_file() and ".git" not in path.parts)
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}


@pytest.mark.skipif(os.name != "posix", reason="a repository with names that only POSIX has")
@pytest.mark.parametrize("tree", TREES)
@pytest.mark.parametrize("word", ["{}:", "{}:urdf/arm.xacro", "{}:."])
def test_a_hostile_revision_is_compared_or_refused_and_harms_nothing(folder: Folder, tree: str, word: str) -> None:
    names = ("secret", "secret.urdf", "secret.png", "secret.stl", "tmp/secret.png", "tmp/secret.stl")
    folder.write({**dict.fromkeys(names, SECRET), "pull/urdf/arm.xacro": ARM, "tmp/x": ""})
    shutil.copytree(repository(), folder.path / "pull/.git", symlinks=True)
    before = contents(folder.path)
    side = "urdf/arm.xacro" if word != "{}:." else "."
    ran = folder.run(
        "diff", word.format(tree), side, cwd=folder.path / "pull", environ={"TMPDIR": str(folder.path / "tmp")}
    )
    assert ran.returncode in {0, 1, 2}, ran.stderr
    assert "Traceback" not in ran.stderr
    assert SECRET.decode() not in ran.stdout + ran.stderr
    assert contents(folder.path) == before
