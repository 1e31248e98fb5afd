"""What a killed run leaves is removed by the next one that writes there, and nothing else is."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest
from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.lint.cache import RunCache
from urdfctl.lint.judging import LintRun
from urdfctl.output import processes, temporary
from urdfctl.output.change import Change
from urdfctl.output.scratch import scratch_folder
from urdfctl.output.temporary import WEEK, new_folder, remove_leftovers, temporary_beside
from urdfctl.output.writing import write_file
from urdfctl.output.writing_all import write_all

needs_posix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals, links and owners")
LEAVES = {
    "file": "temporary.temporary_beside(os.path.abspath('r.urdf'), b'new')",
    "folder": "made = temporary.new_folder(os.path.abspath('new')); made.__enter__()",
}


def left_by_a_killed_run(what: str) -> str:
    """Start a run that is killed while it writes to the current folder, and return what it leaves there."""
    before = set(os.listdir())
    code = f"import os\nfrom urdfctl.output import temporary\n{LEAVES[what]}\nos.kill(os.getpid(), 9)"
    ran = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True)
    assert ran.returncode == -signal.SIGKILL, ran.stderr
    [left] = {*os.listdir()} - before
    return left


@needs_posix
@pytest.mark.parametrize("what", LEAVES)
def test_what_a_killed_run_left_is_removed_by_the_next_one_that_writes_there(folder: Folder, what: str) -> None:
    folder.write({"r.urdf": "old", "deep/file": ""})
    left = left_by_a_killed_run(what)
    assert re.fullmatch(r"\.urdfctl-[0-9a-f]{8}-\d+-\d+-\w{8}\.tmp", left)
    write_file("deep/file", "new", force=True)
    assert left in os.listdir()
    write_file("other", "", force=False)
    assert sorted(os.listdir()) == ["deep", "other", "r.urdf"]


@needs_posix
def test_what_is_written_meanwhile_and_what_others_named_stays(folder: Folder) -> None:
    names = [".urdfctl-notes", ".urdfctl-1-2-3.tmp", ".urdfctl.toml.swp", ".r.urdf.abcd1234", "urdfctl-x.tmp"]
    folder.write(dict.fromkeys(["r.urdf", *names], "mine"))
    running = temporary_beside(os.path.abspath("r.urdf"), b"new")
    with new_folder(os.path.abspath("new")):
        write_file("other", "", force=False)
        assert set(names) < set(os.listdir())
        assert os.path.exists(running)
    assert os.path.isdir("new")


@needs_posix
def test_a_process_with_the_number_of_one_that_ended_is_another_one(folder: Folder) -> None:
    name = Path(temporary_beside(os.path.abspath("r.urdf"), b"new")).name
    start = name.split("-")[3]
    earlier = name.replace(f"-{os.getpid()}-{start}-", f"-{os.getpid()}-{max(int(start) - 1, 1)}-")
    os.rename(name, earlier)
    remove_leftovers(os.curdir)
    assert os.listdir() == ([] if sys.platform == "linux" else [earlier])


def test_what_another_machine_left_is_removed_after_a_week(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(temporary, "machine_name", lambda: "0123abcd")
    name = Path(temporary_beside(os.path.abspath("r.urdf"), b"new")).name
    monkeypatch.undo()
    os.chdir(folder.path)
    remove_leftovers(os.curdir)
    assert os.listdir() == [name]
    os.utime(name, (time.time() - WEEK - 60,) * 2)
    remove_leftovers(os.curdir)
    assert os.listdir() == []


@needs_posix
def test_a_link_with_such_a_name_is_removed_and_not_what_it_leads_to(folder: Folder) -> None:
    folder.write({"kept/file": "mine"})
    left = left_by_a_killed_run("file")
    os.unlink(left)
    os.symlink("kept", left)
    remove_leftovers(os.curdir)
    assert (os.listdir(), os.listdir("kept")) == (["kept"], ["file"])


@needs_posix
@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root can give files away")
def test_what_belongs_to_another_user_stays(folder: Folder) -> None:
    left = left_by_a_killed_run("file")
    os.chown(left, 12345, 12345)
    remove_leftovers(os.curdir)
    assert os.listdir() == [left]


@pytest.mark.parametrize("name", ["a" * 255, "ä" * 127, "r.urdf"])
def test_a_name_of_any_length_can_be_written(folder: Folder, name: str) -> None:
    for text in ("old", "new"):
        write_file(name, text, force=True)
    assert (os.listdir(), Path(name).read_text()) == ([name], "new")


@needs_posix
def test_a_run_that_writes_several_files_looks_into_all_their_folders(folder: Folder) -> None:
    folder.write({"r.urdf": "old", "deep/r.urdf": "old"})
    left_by_a_killed_run("file")
    os.chdir("deep")
    left_by_a_killed_run("folder")
    os.chdir("..")
    changes = [Change(os.path.abspath(name), b"old", b"new") for name in ("r.urdf", "deep/r.urdf")]
    assert write_all(changes) == []
    assert sorted(str(path) for path in Path().rglob("*")) == ["deep", "deep/r.urdf", "r.urdf"]


@needs_posix
def test_the_cache_of_runs_is_cleaned_up_too(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder.path))
    monkeypatch.setattr("urdfctl.lint.cache.STORE_FROM", 0)
    os.mkdir("urdfctl")
    os.chdir("urdfctl")
    left_by_a_killed_run("file")
    time.sleep(0.02)  # what changes during a run keeps it from being stored
    RunCache((), Settings(package_paths=()), "asked").store(LintRun([], []))
    assert [Path(name).suffix for name in os.listdir()] == [".json"]


@needs_posix
def test_a_folder_for_one_run_is_removed_by_it_or_by_a_later_one(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(folder.path))
    with scratch_folder() as own:
        assert os.listdir() == [os.path.basename(own)]
    assert os.listdir() == []
    code = (
        "import os; from urdfctl.output.scratch import scratch_folder; kept = scratch_folder(); os.kill(os.getpid(), 9)"
    )
    subprocess.run([sys.executable, "-c", code], env={**os.environ, "TMPDIR": str(folder.path)}, check=False)
    assert len(os.listdir()) == 1
    with scratch_folder() as own:
        assert os.listdir() == [os.path.basename(own)]


def test_a_new_folder_is_there_as_a_whole_or_not_at_all(folder: Folder) -> None:
    def fill(path: str) -> None:
        with new_folder(os.path.abspath(path)) as made:
            Path(made, "file").write_text("new")
            assert not os.path.lexists("new")
            if path == "new/bad":
                raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        fill("new/bad")
    assert os.listdir() == []
    fill("new/deep")
    assert (os.listdir(), os.listdir("new/deep")) == (["new"], ["file"])
    Path("plain").mkdir()
    assert os.stat("new").st_mode == os.stat("new/deep").st_mode == os.stat("plain").st_mode


@needs_posix
def test_the_processes_of_another_container_tell_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    child = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    monkeypatch.setattr(processes.os, "readlink", lambda _: "1")
    assert processes.start_of(child.pid) == 0
    child.communicate(b"\n")
    assert processes.start_of(child.pid) is None


@needs_posix
@pytest.mark.parametrize("system", ["linux", "darwin"])
def test_a_process_runs_until_it_ends(system: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes.sys, "platform", system)
    own = processes.start_of(os.getpid())
    assert own is not None
    assert (own > 0) == (system == sys.platform == "linux")
    assert processes.is_running(os.getpid(), own)
    child = subprocess.Popen([sys.executable, "-c", ""])
    os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOWAIT)  # it has ended, and nobody has asked how yet
    assert processes.is_running(child.pid, 0) == (sys.platform != "linux" or system != "linux")
    child.wait()
    assert not processes.is_running(child.pid, 0)
    assert not processes.is_running(10**18, 0)
    assert processes.is_running(1, 0)


@needs_posix
def test_a_fork_does_not_delete_the_folder_of_the_process_that_made_it() -> None:
    folder = scratch_folder()
    with folder as own:
        child = os.fork()
        if child == 0:
            try:
                folder.cleanup()
            finally:
                os._exit(0)
        os.waitpid(child, 0)
        assert os.path.isdir(own)
    assert not os.path.exists(own)
