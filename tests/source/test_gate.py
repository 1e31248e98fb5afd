"""The gate to the disk: what a run may read follows from what its user names."""

from __future__ import annotations

import glob
import os
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from urdfctl.source.disk import gate
from urdfctl.source.disk.files import FileProblem, Files, first_bytes
from urdfctl.source.problem import ProblemKind

pytestmark = pytest.mark.skipif(os.name != "posix", reason="links are made as POSIX makes them")


@pytest.fixture
def inside(tmp_path: Path) -> Iterator[Path]:
    """A folder that may be read, beside one that may not."""
    for name in ("in/a", "in/sub/b", "in/.hidden", "in/[x]", "out/secret", "out/sub/c"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    for name, target in (("file", "out/secret"), ("folder", "out"), ("own", "in/a"), ("gone", "out/gone")):
        (tmp_path / "in" / name).symlink_to(tmp_path / target)
    with gate.reading_within([str(tmp_path / "in")]):
        yield tmp_path / "in"


PATTERNS = ["*", "s*/*", "sub/*", ".*", "*/", "a", "none*", "[[]x]", "s?b/[a-c]", "*/b", "own"]
OUTSIDE = ["file", "folder", "folder/secret", "gone", "../out/secret", "../out", "..", "sub/../../out", "a\0b"]


@pytest.mark.parametrize("name", OUTSIDE)
def test_what_leads_out_is_neither_there_nor_opened_nor_listed(inside: Path, name: str) -> None:
    path = f"{inside}/{name}"
    assert not any(look(path) for look in (gate.admits, gate.exists, gate.is_file, gate.is_folder))
    assert (gate.matching(path), gate.entries_in(path), list(gate.walk(path))) == ([], [], [])
    for read in (gate.opened, gate.names_in, gate.size_of, lambda path: first_bytes(path, 9)):
        with pytest.raises(OSError, match=r"outside the workspace|Invalid argument"):
            read(path)
    with pytest.raises(FileProblem) as refused:
        Files().read(path)
    assert refused.value.kind is ProblemKind.OUTSIDE_WORKSPACE


def test_what_is_inside_is_there(inside: Path) -> None:
    assert [name for name in ("a", "own", "sub", "sub/b", "none", "") if gate.exists(f"{inside}/{name}")] == [
        *("a", "own", "sub", "sub/b"),
        "",
    ]
    assert gate.is_file(f"{inside}/own")
    assert gate.is_folder(f"{inside}/sub/")
    assert gate.admits(f"{inside}/none/x")
    assert first_bytes(f"{inside}/own", 9) == b"in/a"
    assert gate.names_in(str(inside)) == sorted(os.listdir(inside))
    assert gate.size_of(f"{inside}/a") == 4
    assert [folder for folder, _, _ in gate.walk(str(inside))] == [str(inside), f"{inside}/sub"]


def test_a_relative_path_is_relative_to_the_current_folder(inside: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(inside / "sub")
    assert [gate.is_file(path) for path in ("b", "../a", "../../out/secret", "../file")] == [True, True, False, False]
    monkeypatch.chdir(inside.parent / "out")
    assert [gate.is_file(path) for path in ("secret", "../in/a")] == [False, True]


@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_pattern_means_what_glob_makes_of_it(inside: Path, pattern: str) -> None:
    meant = {path for path in glob.glob(f"{inside}/{pattern}") if os.path.realpath(path).startswith(f"{inside}")}
    assert {path for path in gate.matching(f"{inside}/{pattern}") if gate.admits(path)} == meant


@pytest.mark.parametrize("pattern", ["folder/*", "f*r/*", "sub/*/../../../out/*", "*/../../out/*", "../*/secret"])
def test_no_pattern_lists_a_folder_outside(inside: Path, pattern: str) -> None:
    assert [path for path in gate.matching(f"{inside}/{pattern}") if "/out/" in os.path.realpath(path)] == []


def test_one_limit_within_another_allows_what_both_allow(inside: Path) -> None:
    out = inside.parent / "out"
    with gate.reading_within([str(inside / "sub"), str(out)]):
        assert gate.exists(f"{inside}/sub/b")
        assert not gate.exists(f"{inside}/a")
        assert not gate.exists(f"{out}/secret")
    assert gate.exists(f"{inside}/a")
    gate.admit(str(out))
    assert gate.exists(f"{inside}/file")


def test_a_thread_has_the_limit_of_the_process_and_its_own(inside: Path) -> None:
    out = inside.parent / "out"

    def seen() -> list[bool]:
        found: list[bool] = []
        thread = threading.Thread(target=lambda: found.extend(map(gate.exists, (f"{inside}/a", f"{out}/secret"))))
        thread.start()
        thread.join()
        return found

    assert seen() == [True, True]
    with gate.reading_within([str(out)], in_all_threads=True):
        assert seen() == [False, True]
    assert seen() == [True, True]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes in its file system")
@pytest.mark.parametrize("kind", ["pipe", "link"])
def test_what_takes_the_place_of_a_file_after_the_check_is_not_opened(
    inside: Path, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, check = inside / "a", gate.check_regular

    def checked_and_swapped(info: os.stat_result, name: str) -> None:
        check(info, name)
        path.unlink()
        os.mkfifo(path) if kind == "pipe" else path.symlink_to(inside.parent / "out" / "secret")

    monkeypatch.setattr(gate, "check_regular", checked_and_swapped)
    with pytest.raises(OSError, match=r"not a regular file|symbolic link"):
        gate.opened(str(path))


def test_without_a_command_everything_may_be_read(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("x")
    gate.admit("/anywhere")
    assert gate.is_file(str(tmp_path / "a"))
    assert not gate.is_limited()
