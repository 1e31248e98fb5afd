"""Files and folders that may not be read or written, and disks without room: a line says so, and the files stay."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from folder import Folder, environment
from hostile.rights import BARE, FORBIDDEN, GEN, ROBOT, WITHOUT_ROOM

if sys.platform == "win32":
    pytest.skip("rights and limits are told as POSIX tells them", allow_module_level=True)
import resource

DROP_FROM_BOUNDS, OVERRIDE, READ_SEARCH = 24, 1, 2  # linux/prctl.h, linux/capability.h


def _drop_rights() -> None:
    """Let permissions bind the super-user too, from the next exec on. An interpreter may lie where only root reads."""
    libc = ctypes.CDLL(None, use_errno=True)
    for capability in (OVERRIDE, READ_SEARCH):
        if libc.prctl(DROP_FROM_BOUNDS, capability, 0, 0, 0):
            raise OSError(ctypes.get_errno(), "the right to pass over permissions cannot be given up")


def _leave_no_room() -> None:
    _leave_room_for(100)


def _leave_room_for(size: int) -> None:
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


def run(folder: Folder, words: str, limit: Callable[[], None] | None) -> tuple[int, str, str]:
    ran = subprocess.run(
        [sys.executable, "-m", "urdfctl", *words.split()],
        cwd=folder.path,
        env=environment({}),
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        preexec_fn=limit,
    )
    return ran.returncode, ran.stdout, ran.stderr


@pytest.fixture
def bound(folder: Folder) -> Iterator[Callable[[str], tuple[int, str, str]]]:
    """Runs a command that permissions bind, in a folder where nothing may be made and some may not be read."""
    limit = None
    if os.geteuid() == 0:
        limit = _drop_rights
        try:
            subprocess.run(["true"], preexec_fn=limit, check=True)
        except (subprocess.SubprocessError, AttributeError):
            pytest.skip("the super-user cannot be bound by permissions here")
    folder.write(
        {
            "a.urdf": ROBOT,
            "bare.urdf": BARE,
            "joints.txt": "elbow\n",
            "secret.urdf": ROBOT,
            "secret.log": "",
            "shut/a.urdf": ROBOT,
        }
    )
    changed = {"secret.urdf": 0, "secret.log": 0, "shut": 0, ".": 0o555}
    for name, mode in changed.items():
        (folder.path / name).chmod(mode)
    yield lambda words: run(folder, words, limit)
    for name in changed:
        (folder.path / name).chmod(0o755)


Bound = Callable[[str], tuple[int, str, str]]


def test_a_read_only_folder_is_linted_as_any_other(folder: Folder, bound: Bound) -> None:
    assert bound("lint a.urdf") == run(folder, "lint a.urdf", None)
    status, out, _ = bound("lint a.urdf --unsafe-fixes --diff")
    assert (status, '+  <gazebo reference="base">' in out) == (1, True)


@pytest.mark.parametrize(("words", "told"), FORBIDDEN)
def test_what_may_not_be_read_or_written_is_said_in_one_line(
    folder: Folder, bound: Bound, words: str, told: str
) -> None:
    there = sorted(os.listdir(folder.path))
    status, _, said = bound(words)
    assert (status, said) == (2, f"urdfctl: {told}\n")
    assert (folder.path / "a.urdf").read_text() == ROBOT
    assert (folder.path / "bare.urdf").read_text() == BARE
    assert sorted(os.listdir(folder.path)) == there


def test_a_robot_that_may_not_be_read_is_a_finding_beside_the_others(bound: Bound) -> None:
    status, out, _ = bound("lint . --format concise")
    assert status == 1
    assert "secret.urdf:1:1: error UC004 'secret.urdf' cannot be read: Permission denied" in out
    assert "a.urdf:1:1: warning UC133" in out


def test_what_cannot_be_fixed_in_a_read_only_folder_is_left_as_it_is(folder: Folder, bound: Bound) -> None:
    status, out, said = bound("lint a.urdf --unsafe-fixes")
    assert (status, "warning UC133" in out) == (2, True)
    assert said.splitlines() == [
        "urdfctl: 'a.urdf' cannot be written: Permission denied",
        "urdfctl: fixed 0 of 3 findings in 0 files",
    ]
    assert (folder.path / "a.urdf").read_text() == ROBOT


@pytest.mark.parametrize(("words", "file"), WITHOUT_ROOM)
def test_without_room_a_file_stays_as_it_was_and_nothing_is_left_beside_it(
    folder: Folder, words: str, file: str
) -> None:
    before = {file: ROBOT, "a.urdf": ROBOT, "bare.urdf": BARE, "joints.txt": "elbow\n"}
    folder.write(before)
    status, _, said = run(folder, words, _leave_no_room)
    assert said.splitlines()[0] == f"urdfctl: '{file}' cannot be written: File too large"
    assert status == 2
    assert {path.name: path.read_text() for path in folder.path.iterdir()} == before


def test_where_one_of_several_files_cannot_be_fixed_the_others_are_as_they_were(folder: Folder) -> None:
    small = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="%s"/>%s</robot>\n'
    slip = '<gazebo reference="bas"/>'
    long = ROBOT.replace(slip[:10], slip + slip[:10]).replace("</robot>", "<!--" + 20_000 * "-=" + "--></robot>")
    before = {"a.xacro": small % ("z.xacro", slip), "z.xacro": long}
    folder.write(before)
    status, _, said = run(folder, "lint a.xacro --unsafe-fixes", lambda: _leave_room_for(10_000))
    assert (status, said.splitlines()[0]) == (2, "urdfctl: 'z.xacro' cannot be written: File too large")
    assert {path.name: path.read_text() for path in folder.path.iterdir()} == before


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize(
    "words",
    [f"gen-controllers joints.txt {GEN} -o /dev/full", f"gen-controllers joints.txt {GEN} --force -o /dev/full"],
)
def test_a_device_that_is_full_is_not_read_first(folder: Folder, words: str) -> None:
    folder.write({"joints.txt": "elbow\n"})
    assert run(folder, words, None) == (2, "", "urdfctl: '/dev/full' cannot be written: No space left on device\n")
