"""Files are written whole or not at all."""

from __future__ import annotations

import os
import stat
import subprocess
import sys

import pytest
from folder import Folder

from urdfctl.errors import UserError
from urdfctl.output.printing import print_message
from urdfctl.output.writing import encoded, write_file

READER = """
import os
handle = os.open("pipe", os.O_RDONLY | os.O_NONBLOCK)
print("reading", flush=True)
os.set_blocking(handle, True)
read = b""
while len(read) < 400_000:
    read += os.read(handle, 65536)
print(len(read))
"""


def test_a_new_file_holds_the_text_and_has_the_usual_permissions(folder: Folder) -> None:
    before = os.umask(0o027)
    try:
        write_file("new.txt", "größer\n", force=False)
    finally:
        os.umask(before)
    assert (folder.path / "new.txt").read_bytes() == "größer\n".encode()
    assert stat.S_IMODE(os.stat("new.txt").st_mode) == 0o640


def test_what_stands_there_is_kept_without_force(folder: Folder) -> None:
    folder.write({"old.txt": "old"})
    with pytest.raises(UserError, match=r"^'old\.txt' exists; --force overwrites it$"):
        write_file("old.txt", "new", force=False)
    assert (folder.path / "old.txt").read_text() == "old"


def test_with_force_it_is_replaced_and_keeps_its_permissions(folder: Folder) -> None:
    folder.write({"old.txt": "old"})
    os.chmod("old.txt", 0o600)
    write_file("old.txt", "new", force=True)
    assert (folder.path / "old.txt").read_text() == "new"
    assert stat.S_IMODE(os.stat("old.txt").st_mode) == 0o600
    assert os.listdir() == ["old.txt"]


def test_a_link_stays_a_link(folder: Folder) -> None:
    folder.write({"real.txt": "old"})
    os.symlink("real.txt", "link.txt")
    write_file("link.txt", "new", force=True)
    assert os.path.islink("link.txt")
    assert (folder.path / "real.txt").read_text() == "new"


def test_a_broken_link_is_in_the_way(folder: Folder) -> None:
    os.symlink("nowhere", "link.txt")
    with pytest.raises(UserError, match="exists"):
        write_file("link.txt", "new", force=False)


def test_a_device_is_written_to_and_stays(folder: Folder) -> None:
    write_file(os.devnull, "text", force=False)
    assert stat.S_ISCHR(os.stat(os.devnull).st_mode)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes in its file system")
def test_a_pipe_is_written_to_where_somebody_reads_it(folder: Folder) -> None:
    os.mkfifo("pipe")
    with pytest.raises(UserError, match=r"^'pipe' cannot be written: it is a pipe that no program reads$"):
        write_file("pipe", "text", force=False)
    text = "text" * 100_000  # more than a pipe holds
    reader = subprocess.Popen([sys.executable, "-c", READER], stdout=subprocess.PIPE, text=True)
    assert reader.stdout is not None
    assert reader.stdout.readline() == "reading\n"
    write_file("pipe", text, force=False)
    assert reader.communicate(timeout=60)[0] == "400000\n"


@pytest.mark.parametrize(
    ("path", "told"),
    [(".", "'.' is a folder"), ("nowhere/x", "'nowhere/x' cannot be written: No such file or directory")],
)
def test_where_nothing_can_be_written_one_line_says_so(folder: Folder, path: str, told: str) -> None:
    with pytest.raises(UserError) as refused:
        write_file(path, "text", force=True)
    assert str(refused.value) == told


def test_nothing_is_left_where_writing_fails(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_handle: int) -> None:
        raise OSError(28, "No space left on device")

    folder.write({"old.txt": "old"})
    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(UserError, match="No space left on device"):
        write_file("old.txt", "new", force=True)
    assert os.listdir() == ["old.txt"]
    assert (folder.path / "old.txt").read_text() == "old"


def test_bytes_of_file_names_that_are_no_text_stay_as_they_are() -> None:
    assert encoded("a\udcffb") == b"a\xffb"
    assert encoded("a\ud800b") == b"a\\ud800b"


def test_a_line_on_standard_error_is_one_whatever_it_holds(capsys: pytest.CaptureFixture[str]) -> None:
    print_message("file 'a\n\x1b[31m' does not exist")
    assert capsys.readouterr().err == "urdfctl: file 'a\\n\\x1b[31m' does not exist\n"
