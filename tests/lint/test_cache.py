"""A second run uses the results of the first one only if nothing that it could read has changed."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest
from folder import Folder

from urdfctl.commands.running import run_words
from urdfctl.lint import cache, run
from urdfctl.lint.judging import LintRun

ROBOT = '<robot name="r" xmlns:xacro="x"><xacro:include filename="part.xacro"/><link name="a"/></robot>'
PART = '<robot xmlns:xacro="x"><joint name="j" type="%s"/></robot>'


@pytest.fixture
def linted(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> list[LintRun]:
    """The runs that were really made, not taken from the cache, of a package in the current folder."""
    runs: list[LintRun] = []
    judge = run.judge

    def noted(*arguments: object) -> LintRun:
        runs.append(judge(*arguments))  # type: ignore[arg-type]
        return runs[-1]

    monkeypatch.setattr(run, "judge", noted)
    monkeypatch.setattr(cache, "STORE_FROM", 0.0)
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder.path / "home/cache"))
    (folder.path / "home").mkdir()
    folder.write({"ws/.git/HEAD": "", "ws/package.xml": "<package><name>p</name></package>"})
    folder.write({"ws/urdf/robot.xacro": ROBOT, "ws/urdf/part.xacro": PART % "fixed"})
    monkeypatch.chdir(folder.path / "ws")
    return runs


def lint(*words: str) -> int:
    return run_words(["lint", ".", "--jobs", "1", *words])


def test_a_run_without_changes_is_not_made_again(linted: list[LintRun], capsys: pytest.CaptureFixture[str]) -> None:
    first = lint(), capsys.readouterr()
    second = lint(), capsys.readouterr()
    assert first == second
    assert len(linted) == 1


def change(path: Path) -> None:
    path.write_text(path.read_text(encoding="utf-8").replace("fixed", "sideways"), encoding="utf-8")


@pytest.mark.parametrize(
    "act",
    [
        lambda: change(Path("urdf/part.xacro")),
        lambda: Path("urdf/part.xacro").unlink(),
        lambda: Path("urdf/other.urdf").write_text("<robot/>", encoding="utf-8"),
        lambda: Path("CMakeLists.txt").write_text("project(p)", encoding="utf-8"),
        lambda: Path("urdf/part.xacro").rename("urdf/moved.xacro"),
        lambda: Path("new/deep").mkdir(parents=True),
        lambda: Path(".gitignore").write_text("*.bak\n", encoding="utf-8"),
        lambda: Path("urdfctl.toml").write_text("distro = 'jazzy'\n", encoding="utf-8"),
    ],
    ids=["changes", "vanishes", "appears", "is looked for", "is renamed", "a folder", "is ignored", "configures"],
)
def test_what_changes_in_the_workspace_is_seen(linted: list[LintRun], act: Callable[[], object]) -> None:
    lint()
    act()
    lint()
    assert len(linted) == 2


def test_a_change_that_keeps_size_and_time_is_seen(linted: list[LintRun]) -> None:
    lint()
    path = Path("urdf/part.xacro")
    before = path.stat()
    path.write_text((PART % "fixed").replace('"j"', '"k"'), encoding="utf-8")
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    lint()
    assert len(linted) == 2


@pytest.mark.parametrize("words", [("--distro", "noetic"), ("--select", "UC1"), ("prefix:=a_",), ("--simulator", "gz")])
def test_another_question_has_another_answer(linted: list[LintRun], words: tuple[str, ...]) -> None:
    lint()
    lint(*words)
    assert len(linted) == 2


def test_the_cache_is_left_alone_if_the_user_wants_that(linted: list[LintRun]) -> None:
    lint("--no-cache")
    assert not Path("../home/cache").exists()
    lint()
    lint("--no-cache")
    assert len(linted) == 3


def test_a_broken_file_in_the_cache_is_ignored(linted: list[LintRun]) -> None:
    lint()
    for file in Path("../home/cache/urdfctl").iterdir():
        file.write_text('{"fingerprint": 1', encoding="utf-8")
    lint()
    assert len(linted) == 2


def test_a_file_that_changes_during_a_run_is_not_taken_for_what_was_linted(
    linted: list[LintRun], monkeypatch: pytest.MonkeyPatch
) -> None:
    judge = run.judge

    def disturbed(*arguments: object) -> LintRun:
        made = judge(*arguments)  # type: ignore[arg-type]
        change(Path("urdf/part.xacro"))
        return made

    monkeypatch.setattr(run, "judge", disturbed)
    lint()
    assert not Path("../home/cache").exists()


def test_packages_of_an_installed_ros_are_in_doubt(linted: list[LintRun], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("AMENT_PREFIX_PATH", "/opt/ros/jazzy")
    lint()
    assert not Path("../home/cache").exists()


def test_old_results_are_deleted(linted: list[LintRun], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "MAX_STORED", 2)
    for code in ("UC1", "UC2", "UC3", "UC4"):
        lint("--select", code)
    assert len(list(Path("../home/cache/urdfctl").iterdir())) == 2


def test_a_run_is_stored_if_it_took_long_by_the_clock_or_on_all_processors_together(
    linted: list[LintRun], monkeypatch: pytest.MonkeyPatch, folder: Folder
) -> None:
    monkeypatch.setattr(cache, "STORE_FROM", 0.5)
    for after, is_stored in (((0.4, 0.4), False), ((0.6, 0.1), True), ((0.3, 0.9), True)):
        clocks = iter([(0.0, 0.0), after])
        monkeypatch.setattr(cache, "clocks", lambda clocks=clocks: next(clocks))
        lint()
        stored = list((folder.path / "home").rglob("*.json"))
        assert bool(stored) == is_stored, after
        for path in stored:
            path.unlink()
