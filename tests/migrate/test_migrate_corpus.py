"""Migrations of the corpus: a second one changes nothing, and two over a distro between equal one over both."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from corpus import CORPUS, OWN, needs_corpus
from folder import CHECKOUT, environment
from generating import command
from sampling import WHOLE, sample

SAMPLE = ["PickNikRobotics__ros2_robotiq_gripper", "kroshu__kuka_robot_descriptions", "botsync__volta"]
PAIRS = Path(os.environ.get("URDFCTL_PAIRS", "pairs"))
"""Robots as they were before people migrated them, ID/before, as ../shared/tools/wild.py --pairs lays them out."""


def repositories() -> list[Path]:
    """The repositories to migrate: a few of the corpus, or all of them and all pairs."""
    if not WHOLE or not CORPUS.is_dir():
        return [CORPUS / name for name in sample(SAMPLE, 3)]
    whole = sorted(path for path in CORPUS.iterdir() if path.is_dir() and path.name != "known_bad")
    return [*whole, *sorted(PAIRS.glob("*/before"))]


SOURCES = pytest.mark.parametrize(
    "source",
    [
        *(pytest.param(CHECKOUT / "samples" / name, id=name) for name in sample(("gripper", "mybot"), 2)),
        *(pytest.param(OWN / name, id=name) for name in sample(("crane", "rover"), 2)),
        *(pytest.param(path, id=f"{path.parent.name}/{path.name}", marks=needs_corpus) for path in repositories()),
    ],
)


def diff(folder: Path, *words: str) -> bytes:
    """The diff of a migration to jazzy in a folder."""
    ran = subprocess.run(
        [sys.executable, "-m", "urdfctl", "migrate", *words, "--to", "jazzy"],
        cwd=folder,
        env=environment({}),
        capture_output=True,
        check=False,
    )
    assert ran.returncode in (0, 1), ran.stderr
    return ran.stdout


def contents(folder: Path) -> dict[str, bytes]:
    """The files in a folder, without those of git and the report."""
    files = (path for path in folder.rglob("*") if path.is_file() and path.name != "MIGRATION.md")
    found = {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}
    return {name: data for name, data in found.items() if not name.startswith(".git/")}


def migrated(source: Path, distro: str, target: Path) -> dict[str, bytes]:
    """The files of a migrated copy, without the report."""
    ran = command("migrate", str(source), "--to", distro, "-o", str(target))
    assert ran.returncode == 0, ran.stderr
    return contents(target)


@SOURCES
def test_a_migration_does_not_depend_on_its_path_and_is_not_repeated(source: Path, tmp_path: Path) -> None:
    at_once = migrated(source, "lyrical", tmp_path / "lyrical")
    migrated(source, "jazzy", tmp_path / "jazzy")
    assert migrated(tmp_path / "jazzy", "lyrical", tmp_path / "both") == at_once
    again = command("migrate", str(tmp_path / "lyrical"), "--to", "lyrical")
    assert (again.returncode, again.stdout) == (0, "")


@SOURCES
def test_git_applies_the_diff_whatever_the_order_of_the_packages(source: Path, tmp_path: Path) -> None:
    work = tmp_path / "work"
    shutil.copytree(source, work, symlinks=True)
    subprocess.run(["git", "init", "-q"], cwd=work, check=True)
    packages = sorted({str(manifest.parent) for manifest in work.rglob("package.xml")})
    assert diff(work, *packages) == diff(work, *reversed(packages))
    patch = diff(work, ".")
    if patch:
        subprocess.run(["git", "apply", "--whitespace=nowarn"], cwd=work, input=patch, check=True)
    assert contents(work) == migrated(source, "jazzy", tmp_path / "jazzy")
