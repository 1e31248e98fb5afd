"""Folders that are nested more deeply than Python's stack are read like others, or refused in one line."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder
from sampling import sample

from urdfctl import __main__ as command
from urdfctl.source.disk.folders import delete_folder, walk

LEVELS = 1100
"""More than Python's stack has, and in a path that Linux allows."""
MANIFEST = '<package format="2"><name>p</name><buildtool_depend>catkin</buildtool_depend></package>'
COMMANDS = ["migrate . --to jazzy -o ../out", "lint . --fix", "gen-check .", "graph .", "init"]
ROBOT = '<robot name="r"><link name="a"/><link name="a"/></robot>'
posix = pytest.mark.skipif(sys.platform == "win32", reason="paths are as long as POSIX allows")


@pytest.fixture(scope="module")
def deep(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Folder]:
    """A package with a faulty robot in the innermost of many folders."""
    tmp_path = tmp_path_factory.mktemp("deep")
    folder = Folder(tmp_path / "p")
    folder.write({"package.xml": MANIFEST, ".git/HEAD": ""})
    here = os.getcwd()
    os.chdir(folder.path)
    for _ in range(LEVELS):
        os.mkdir("d")
        os.chdir("d")
    Path("arm.urdf").write_text(ROBOT, encoding="utf-8")
    os.chdir(here)
    yield folder
    delete_folder(str(folder.path))
    delete_folder(str(tmp_path / "out"))


@posix
def test_a_robot_in_the_innermost_of_many_folders_is_linted(deep: Folder) -> None:
    ran = deep.run("lint", ".", "--format", "concise")
    assert f"{'d/' * LEVELS}arm.urdf:1:45: error UC110" in ran.stdout
    assert ran.returncode == 1


@posix
@pytest.mark.parametrize("words", sample(COMMANDS, 2))
def test_each_command_ends_in_many_nested_folders(deep: Folder, words: str) -> None:
    ran = deep.run(*words.split(), environ={"TMPDIR": str(deep.path.parent)})
    assert ran.returncode in {0, 1, 2}
    assert "Traceback" not in ran.stderr
    assert {path.name for path in deep.path.parent.iterdir()} <= {"p", "out"}


@posix
def test_a_migration_whose_copy_has_too_long_a_path_is_refused_in_one_line(tmp_path: Path) -> None:
    folder = Folder(tmp_path / "p")
    folder.write({"package.xml": MANIFEST})
    inner = folder.path
    while len(str(inner)) < os.pathconf("/", "PC_PATH_MAX") - 150:
        inner /= "d" * 100
    os.makedirs(inner)
    temporary = tmp_path / ("t" * 200)
    temporary.mkdir()
    ran = folder.run("migrate", ".", "--to", "jazzy", environ={"TMPDIR": str(temporary)})
    assert ran.returncode == 2
    assert re.fullmatch(r"urdfctl: '.*/d{100}' cannot be copied: File name too long\n", ran.stderr)
    assert list(temporary.iterdir()) == []


@posix
def test_folders_are_walked_as_python_does(folder: Folder) -> None:
    folder.write({"b/c/x": "", "b/d/y": "", "a/z": "", "f": "", "skipped/inner/x": ""})
    (folder.path / "b" / "up").symlink_to(folder.path)
    (folder.path / "loop").symlink_to("loop")

    def walked(by: object) -> list[tuple[str, list[str], list[str]]]:
        found = []
        for current, folders, others in by(str(folder.path)):  # type: ignore[operator]
            folders[:] = sorted(name for name in folders if name != "skipped")
            found.append((current, list(folders), sorted(others)))
        return found

    assert walked(walk) == walked(os.walk)
    assert list(walk(str(folder.path / "f"))) == list(walk(str(folder.path / "missing"))) == []


@posix
def test_a_folder_is_deleted_without_what_its_links_lead_to(folder: Folder) -> None:
    folder.write({"gone/a/b/x": "", "kept/y": ""})
    (folder.path / "gone" / "a" / "to_folder").symlink_to(folder.path / "kept")
    (folder.path / "gone" / "to_file").symlink_to(folder.path / "kept" / "y")
    delete_folder(str(folder.path / "gone"))
    assert sorted(os.listdir(folder.path)) == ["kept"]
    assert os.listdir(folder.path / "kept") == ["y"]


def test_only_one_module_goes_through_folders() -> None:
    paths = (path for path in (CHECKOUT / "urdfctl").rglob("*.py") if path.name != "folders.py")
    used = [path.name for path in paths if re.search(r"os\.walk\(|rmtree\(|copytree\(", path.read_text("utf-8"))]
    assert used == []


def test_nesting_that_nothing_expects_is_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def nested(words: list[str]) -> int:
        return nested(words) + 1

    left: list[int] = []
    monkeypatch.setattr(command, "run", nested)
    monkeypatch.setattr(command, "leave", left.append)
    monkeypatch.setattr(command, "open_closed_streams", lambda: None)
    command.main()
    assert left == [2]
    assert capsys.readouterr().err == "urdfctl: something in these files is nested too deeply to be read\n"
