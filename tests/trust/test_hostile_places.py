"""Folders and systems that are hostile: devices and pipes in the place of files, no home, no room, no right."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from folder import Folder, environment
from hostile.places import ARM, ENVIRONMENTS, IN_ANY_ENVIRONMENT, NAMES, ON_A_FULL_DISK, PIPES, SHOWN
from sampling import sample

needs_posix = pytest.mark.skipif(os.name != "posix", reason="pipes and links are made as POSIX makes them")
ROBOT = '<robot name="a"><link name="base"/></robot>\n'


@needs_posix
@pytest.mark.parametrize("kind", ["pipe", "zeros", "loop"])
@pytest.mark.parametrize("words", [["lint", "."], ["gen-check", "."], ["smoke", ".", "--engine", "none"]])
def test_a_pipe_a_device_or_a_loop_in_the_place_of_a_file_is_not_waited_for(
    folder: Folder, kind: str, words: list[str]
) -> None:
    folder.write({"a.urdf": ROBOT, ".git/HEAD": ""})
    for path in (folder.path / name for name in (NAMES if kind != "zeros" else NAMES[:4])):
        if kind == "pipe":
            os.mkfifo(path)
        else:
            path.symlink_to("/dev/zero" if kind == "zeros" else path)
    ran = folder.run(*words)
    assert ran.returncode in {0, 1, 2, 5}, ran.stderr
    assert "Traceback" not in ran.stderr


@needs_posix
@pytest.mark.parametrize(("words", "told"), PIPES)
def test_a_pipe_that_an_option_names_is_not_waited_for(folder: Folder, words: str, told: str) -> None:
    folder.write({"a.urdf": ARM})
    for name in ("pipe", "pipe.yaml"):
        os.mkfifo(folder.path / name)
    ran = folder.run(*words.split())
    assert (ran.returncode, ran.stderr) == (2, f"urdfctl: {told}\n")


@needs_posix
def test_a_controllers_file_of_smoke_that_is_a_pipe_is_a_finding(folder: Folder) -> None:
    folder.write({"a.urdf": ARM})
    os.mkfifo(folder.path / "pipe")
    ran = folder.run("smoke", "a.urdf", "--engine", "none", "--controllers", "pipe")
    assert ran.returncode == 1
    assert "'pipe' is not a regular file" in ran.stdout


@needs_posix
@pytest.mark.parametrize("name", ["endless.yaml", "endless.urdf", "endless.txt"])
def test_a_list_of_joints_without_end_is_refused(folder: Folder, name: str) -> None:
    (folder.path / name).symlink_to("/dev/zero")
    ran = folder.run("gen-controllers", name, "--type", "effort", "--distro", "noetic")
    assert ran.returncode in {1, 2}
    assert "Traceback" not in ran.stderr


@pytest.mark.parametrize("words", IN_ANY_ENVIRONMENT)
def test_neither_home_nor_locale_changes_what_is_said(folder: Folder, words: str) -> None:
    folder.write({"my röbot/ärm 🤖.urdf": ARM, "fehler.log": "Schlüssel fehlt 🤖\n"})
    given = [word.replace("PATH", "my röbot/ärm 🤖.urdf") for word in words.split()]
    plain = folder.run(*given)
    for number, environ in enumerate(ENVIRONMENTS):
        ran = folder.run(*(word.replace("OUT", f"ö made {number}") for word in given), environ=environ)
        assert ran.returncode in {0, 1, 2, 5}, ran.stderr
        assert "Traceback" not in ran.stderr
        if given[0] not in {
            "gen-all",
            "expand",
        }:  # another folder; a banner that varies
            assert (ran.returncode, ran.stdout) == (plain.returncode, plain.stdout)


@needs_posix
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("words", ON_A_FULL_DISK)
def test_no_room_is_said_in_one_line(folder: Folder, words: str) -> None:
    folder.write({"a.urdf": ARM})
    with open("/dev/full", "wb") as full:
        ran = subprocess.run(
            [sys.executable, "-m", "urdfctl", *words.split()],
            cwd=folder.path,
            env=environment({}),
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert ran.returncode == 2
    assert "No space left on device" in ran.stderr
    assert ran.stderr.count("\n") == 1


@needs_posix
def test_a_place_that_cannot_be_written_is_said_in_one_line(folder: Folder) -> None:
    folder.write({"a.urdf": ARM, "file": ""})
    ran = folder.run("gen-all", "a.urdf", "--type", "effort", "--distro", "noetic", "-o", "file/below")
    assert ran.returncode == 2
    assert ran.stderr.splitlines()[-1].endswith("'file/below' cannot be written: Not a directory")


@needs_posix
def test_killed_at_any_moment_a_generator_leaves_no_file_half_written(folder: Folder) -> None:
    folder.write({"a.urdf": ARM})
    words = ["gen-controllers", "a.urdf", "--type", "effort", "--distro", "noetic", "-o", "c.yaml", "--force"]
    began = time.monotonic()
    assert folder.run(*words).returncode == 0
    took = time.monotonic() - began
    whole = (folder.path / "c.yaml").read_text()
    for part in sample(range(6), 3):
        folder.write({"c.yaml": "old\n"})
        process = subprocess.Popen(
            [sys.executable, "-m", "urdfctl", *words],
            cwd=folder.path,
            env=environment({}),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        time.sleep(took * (0.5 + part / 12))
        process.send_signal(signal.SIGKILL)
        process.wait()
        assert (folder.path / "c.yaml").read_text() in {"old\n", whole}


@needs_posix
def test_an_interrupted_generator_ends_quietly(folder: Folder) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "urdfctl", "gen-controllers", "-", "--type", "effort", "--distro", "noetic"],
        cwd=folder.path,
        env=environment({}),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),  # noqa: PLW1509 (no threads here)
    )
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (130, "")
    assert "Traceback" not in err


@needs_posix
@pytest.mark.parametrize(("words", "status", "told"), SHOWN)
def test_what_files_and_their_names_hold_is_shown_and_not_obeyed(
    folder: Folder, words: str, status: int, told: str
) -> None:
    folder.write(
        {
            "settings/a.urdf": ARM,
            "settings/urdfctl.toml": '"\\u001b[31mred" = 1\n',
            "names/\x1b[31m.urdf": ARM,
            "names/b.urdf": ARM,
            "made/c.yaml": "# made by urdfctl gen-controllers \x1b[31mred.urdf --type effort\n",
        }
    )
    ran = folder.run(*words.split(" "))
    assert (ran.returncode, ran.stderr) == (status, f"urdfctl: {told}\n")
