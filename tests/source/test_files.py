"""Only regular files are read, only where the run may read, and only as much of them as any robot needs."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from urdfctl.errors import UserError
from urdfctl.source.disk.files import MAX_BYTES, FileProblem, Files, named_bytes
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Place, SourceText


def refused(path: Path | str, files: Files | None = None) -> tuple[ProblemKind, str]:
    with pytest.raises(FileProblem) as raised:
        (files or Files()).read(str(path))
    return raised.value.kind, raised.value.message


def test_a_file_is_read_once_as_it_stands_on_disk(tmp_path: Path) -> None:
    path = tmp_path / "a.urdf"
    path.write_bytes(b"\xef\xbb\xbf<a>\r\n</a>\xff")
    files = Files()
    read = files.read(str(path))
    assert read.data == b"\xef\xbb\xbf<a>\r\n</a>\xff"
    path.unlink()
    assert files.read(str(path)) is read
    assert files.sources() == [read]


def test_a_path_is_shown_without_detours(tmp_path: Path) -> None:
    (tmp_path / "sub").mkdir()
    (tmp_path / "a.urdf").touch()
    assert Files().read(str(tmp_path / "sub" / ".." / "a.urdf")).path == str(tmp_path / "a.urdf")


def test_what_is_not_there_is_not_found(tmp_path: Path) -> None:
    path = tmp_path / "none.urdf"
    assert refused(path) == (ProblemKind.FILE_NOT_FOUND, f"file does not exist: '{path}'")


def test_a_broken_link_is_told_as_such(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "none")
    assert refused(tmp_path / "link") == (ProblemKind.FILE_NOT_FOUND, f"'{tmp_path}/link' is a broken symbolic link")


def test_a_link_in_a_circle_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "link")
    assert refused(tmp_path / "link")[0] is ProblemKind.FILE_UNREADABLE


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    assert refused(tmp_path) == (ProblemKind.FILE_UNREADABLE, f"'{tmp_path}' is a folder, not a file")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes in its file system")
def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert refused(tmp_path / "pipe") == (ProblemKind.FILE_UNREADABLE, f"'{tmp_path}/pipe' is not a regular file")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes in its file system")
def test_neither_is_one_that_an_option_names(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "large").write_bytes(b"x" * (MAX_BYTES + 1))
    for name, why in (
        ("none", "No such file or directory"),
        ("pipe", "it is not a regular file"),
        ("large", "it is larger than 16 MiB"),
    ):
        with pytest.raises(UserError) as refusal:
            named_bytes(str(tmp_path / name))
        assert str(refusal.value) == f"'{tmp_path / name}' cannot be read: {why}"
    (tmp_path / "small").write_bytes(b"elbow\n")
    assert named_bytes(str(tmp_path / "small")) == b"elbow\n"


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="this system has no devices in its file system")
def test_a_device_is_not_read() -> None:
    assert refused("/dev/zero") == (ProblemKind.FILE_UNREADABLE, "'/dev/zero' is not a regular file")


def test_a_large_file_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "large").open("wb") as file:
        file.truncate(MAX_BYTES + (4 << 20))
    assert refused(tmp_path / "large") == (
        ProblemKind.BUDGET,
        f"'{tmp_path}/large' has 20 MiB; the limit is 16 MiB",
    )


@pytest.mark.skipif(hasattr(os, "geteuid") and os.geteuid() == 0, reason="the super-user may read everything")
def test_a_file_without_permission_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "a").touch(mode=0)
    assert refused(tmp_path / "a") == (ProblemKind.FILE_UNREADABLE, f"'{tmp_path}/a' cannot be read: Permission denied")


@pytest.mark.parametrize("name", ["a\0b", "x" * 5000])
def test_what_is_no_path_cannot_be_read(name: str) -> None:
    assert refused(name)[0] is ProblemKind.FILE_UNREADABLE


def test_what_lies_outside_the_bounds_is_not_read(tmp_path: Path) -> None:
    for name in ("w", "w2"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "a").touch()
    (tmp_path / "w" / "link").symlink_to(tmp_path / "w2")
    (tmp_path / "w" / "file_link").symlink_to(tmp_path / "w2" / "a")
    files = Files([str(tmp_path / "w")])
    assert files.read(str(tmp_path / "w" / "a")).data == b""
    for path in ("w2/a", "w/../w2/a", "w/link/a", "w/file_link", "w2/none"):
        kind, message = refused(tmp_path / path, files)
        assert kind is ProblemKind.OUTSIDE_WORKSPACE
        assert message == f"'{tmp_path}/{path}' is outside the workspace '{tmp_path}/w' and is not read"
    files.allow(str(tmp_path / "w2"))
    assert files.read(str(tmp_path / "w" / "link" / "a")).data == b""


def test_bounds_that_are_links_themselves_hold_what_they_lead_to(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "a").touch()
    (tmp_path / "w").symlink_to(tmp_path / "real")
    assert Files([str(tmp_path / "w")]).read(str(tmp_path / "w" / "a")).data == b""


def test_without_bounds_everything_may_be_read(tmp_path: Path) -> None:
    (tmp_path / "a").touch()
    files = Files(None)
    files.allow("/anywhere")
    assert files.read(str(tmp_path / "a")).data == b""


def test_an_installed_path_is_read_where_its_source_lies(tmp_path: Path) -> None:
    (tmp_path / "source").write_bytes(b"<a/>")
    read = Files([str(tmp_path)], lambda path: str(tmp_path / "source")).read("/share/arm/a")
    assert (read.path, read.data) == (str(tmp_path / "source"), b"<a/>")


def test_a_files_problem_is_blamed_on_who_asked_for_it(tmp_path: Path) -> None:
    place = Place(SourceText("r.xacro", b"<xacro:include/>"), 0)
    with pytest.raises(FileProblem) as raised:
        Files().read(str(tmp_path))
    problem = raised.value.at(place)
    assert (problem.at, problem.subject, problem.kind) == (place, str(tmp_path), ProblemKind.FILE_UNREADABLE)
