"""How a migration writes: the same bytes in each way, whatever the files are like, and all files or none."""

from __future__ import annotations

import os
import signal
import stat
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest
from folder import Folder, environment
from migrated_packages import FILES, MANIFEST, MIGRATED, ROBOT, content
from moved_packages import FILES as OF_ROS1

from urdfctl.errors import UserError
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.source.disk.folders import delete_folder

needs_posix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such rights, links and signals")
STRANGE = {
    "plain/package.xml": MANIFEST.replace("arm", "plain"),
    "plain/urdf/arm.urdf.xacro": ROBOT,
    "crlf/package.xml": MANIFEST.replace("arm", "crlf").replace("\n", "\r\n"),
    "crlf/urdf/arm.urdf.xacro": ROBOT.replace("\n", "\r\n"),
    "with blank/package.xml": MANIFEST.replace("arm", "blank"),
    "with blank/urdf/my arm.urdf.xacro": ROBOT.rstrip("\n"),
    "tabs/package.xml": MANIFEST.replace("arm", "tabs"),
    "tabs/urdf/arm.urdf.xacro": ROBOT.replace("  ", "\t"),
    "bom/package.xml": MANIFEST.replace("arm", "bom"),
    "bom/urdf/ärm.urdf.xacro": b"\xef\xbb\xbf" + ROBOT.replace("hardware -->", "Gerät -->").encode(),
    "latin/package.xml": MANIFEST.replace("arm", "latin"),
    "latin/urdf/arm.urdf.xacro": b'<?xml version="1.0" encoding="ISO-8859-1"?>\n'
    + ROBOT.replace("hardware -->", "Gerät -->").encode("latin-1"),
}
"""Packages with one robot each."""
OLD, NEW = b"ign_ros2_control/IgnitionSystem", b"gz_ros2_control/GazeboSimSystem"


def test_a_diff_writing_in_place_and_a_copy_give_the_same_bytes_for_strange_files(folder: Folder) -> None:
    before = {name: text.encode() if isinstance(text, str) else text for name, text in STRANGE.items()}
    folder.write({f"{root}/{name}": data for root in ("applied", "placed") for name, data in before.items()})
    for root in ("applied", "placed"):
        subprocess.run(["git", "init", "-q", root], cwd=folder.path, check=True)
    command = [sys.executable, "-m", "urdfctl", "migrate", ".", "--to", "jazzy"]
    shown = subprocess.run(
        command, cwd=folder.path / "applied", env=environment({}), stdout=subprocess.PIPE, check=False
    )
    assert shown.returncode == 1
    apply = ["git", "apply", "--whitespace=nowarn"]
    subprocess.run(apply, cwd=folder.path / "applied", input=shown.stdout, check=True)
    copied = folder.run("migrate", "placed", "--to", "jazzy", "-o", "copied")
    placed = folder.run("migrate", "placed", "--to", "jazzy", "--in-place", "--force")
    assert (copied.returncode, placed.returncode) == (0, 0), copied.stderr + placed.stderr
    wanted = {name: data.replace(OLD, NEW) for name, data in before.items()}
    for root in ("applied", "placed", "copied"):
        found = {name: data for name, data in content(folder, root).items() if not name.startswith(".git/")}
        assert {name: found[name] for name in wanted} == wanted, root
        assert found.keys() - wanted.keys() == ({"MIGRATION.md"} if root != "applied" else set())


def test_what_is_written_into_a_file_with_crlf_ends_its_lines_so(folder: Folder) -> None:
    folder.write(OF_ROS1)
    folder.write({f"crlf/{name}": text.replace("\n", "\r\n") for name, text in OF_ROS1.items()})
    for source in ("arm", "crlf/arm"):
        assert folder.run("migrate", source, "--to", "jazzy", "--in-place").returncode == 0
    plain, crlf = content(folder), content(folder, "crlf/arm")
    kept = [name.removeprefix("arm/") for name in OF_ROS1 if not name.endswith(".launch")]
    assert {name: crlf[name] for name in kept} == {name: plain[name].replace(b"\n", b"\r\n") for name in kept}
    assert b"\r" not in crlf["launch/arm.launch.py"]
    assert folder.run("migrate", "crlf/arm", "--to", "jazzy").stdout == ""


@needs_posix
def test_a_copy_keeps_rights_and_links(folder: Folder) -> None:
    folder.write({**FILES, "arm/scripts/go.sh": "#!/bin/sh\n", "outside.txt": "1"})
    arm = folder.path / "arm"
    (arm / "scripts/go.sh").chmod(0o755)
    (arm / "urdf/arm.urdf.xacro").chmod(0o444)
    links = {"urdf/same.xacro": "arm.urdf.xacro", "robots": "urdf", "gone": "nowhere", "out.txt": "../outside.txt"}
    for name, leads_to in links.items():
        (arm / name).symlink_to(leads_to)
    for _ in range(2):  # the second time into a folder that exists
        ran = folder.run("migrate", "arm", "--to", "jazzy", "-o", "deep/new", "--force")
        assert ran.returncode == 0, ran.stderr
    new = folder.path / "deep/new"
    rights = {name: stat.S_IMODE((new / name).stat().st_mode) for name in ("scripts/go.sh", "urdf/arm.urdf.xacro")}
    assert rights == {"scripts/go.sh": 0o755, "urdf/arm.urdf.xacro": 0o444}
    shown = {name: os.readlink(new / name) for name in links}
    assert shown == {**links, "out.txt": str(folder.path / "outside.txt")}
    assert (new / "robots/same.xacro").read_text() == MIGRATED
    assert folder.run("migrate", "arm", "--to", "jazzy", "--in-place").returncode == 0
    assert (arm / "urdf/same.xacro").is_symlink()
    assert stat.S_IMODE((arm / "urdf/arm.urdf.xacro").stat().st_mode) == 0o444


@needs_posix
@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_leaves_all_files_as_they_were(folder: Folder) -> None:
    folder.write({**FILES, "arm/more/arm.urdf.xacro": ROBOT})
    before = content(folder)
    (folder.path / "arm/urdf").chmod(0o555)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    (folder.path / "arm/urdf").chmod(0o755)
    assert (ran.returncode, content(folder)) == (2, before)


def test_a_report_that_cannot_be_written_leaves_all_files_as_they_were(folder: Folder) -> None:
    folder.write({**FILES, "report/a.txt": "1"})
    before = content(folder)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place", "--report", "report")
    assert (ran.returncode, "'report' is a folder" in ran.stderr) == (2, True)
    assert content(folder) == before


# -- a run that is killed ----------------------------------------------------------------------------------------------

KILLING = """\
import os, shutil, signal, sys
left = int(sys.argv[1])
def killing(module, name):
    real = getattr(module, name)
    def call(*paths, **more):
        global left
        left -= ".urdfctl-cache" not in str(paths[0])
        if left < 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return real(*paths, **more)
    setattr(module, name, call)
"""
IN_PLACE = """
for name in ("replace", "unlink"):
    killing(os, name)
from urdfctl.migrate.writing import write_changes
from urdfctl.output.change import Change
changes = [Change(os.path.realpath(name), b"1", b"2") for name in ("a", "b")]
sys.exit(len(write_changes(changes, ("MIGRATION.md", b"2"))))
"""
AS_COPY = """
from urdfctl.migrate.trial.scratch import Scratch
scratch = Scratch(["arm"])
for name in ("copyfile", "copymode"):
    killing(shutil, name)
for name in ("replace", "rename"):
    killing(os, name)
from urdfctl.migrate.writing import write_copy
sys.exit(len(write_copy(scratch, os.path.realpath("arm"), "new", ("new/MIGRATION.md", b"2"))))
"""


def killed(folder: Folder, code: str, calls: int) -> bool:
    """Run code that is killed at a call that writes, and return whether it was."""
    environ = {**os.environ, "XDG_CACHE_HOME": str(folder.path / ".urdfctl-cache")}
    command = [sys.executable, "-c", KILLING + code, str(calls)]
    ran = subprocess.run(command, cwd=folder.path, env=environ, capture_output=True, check=False)
    assert ran.returncode in (0, -signal.SIGKILL), ran.stderr
    return ran.returncode != 0


@needs_posix
@pytest.mark.parametrize("calls", range(4))
def test_files_and_report_are_restored_after_a_run_that_was_killed_at_a_rename(folder: Folder, calls: int) -> None:
    before = {"a": b"1", "b": b"1"}
    folder.write(before)
    assert killed(folder, IN_PLACE, calls) == (calls < 3)
    cache = str(folder.path / ".urdfctl-cache")
    code = "from urdfctl.output.journal import restore_unfinished as restore; restore()"
    subprocess.run([sys.executable, "-c", code], env={**os.environ, "XDG_CACHE_HOME": cache}, check=True)
    found = {name: data for name, data in content(folder, ".").items() if not name.startswith(".urdfctl-cache")}
    assert found == (before if calls < 3 else {"a": b"2", "b": b"2", "MIGRATION.md": b"2"})


@needs_posix
@pytest.mark.parametrize("calls", range(8))
def test_a_copy_is_complete_or_not_there_whenever_its_run_is_killed(folder: Folder, calls: int) -> None:
    folder.write(FILES)
    before = content(folder)
    was_killed = killed(folder, AS_COPY, calls)
    assert content(folder) == before
    new = folder.path / "new"
    assert new.exists() != was_killed
    if was_killed:
        assert not killed(folder, AS_COPY, 100)
    assert content(folder, "new") == {**before, "MIGRATION.md": b"2"}
    assert Path(new / "MIGRATION.md").is_file()


def test_a_copy_that_another_program_deleted_is_not_written(tmp_path: Path) -> None:
    package = tmp_path / "arm"
    package.mkdir()
    (package / "package.xml").write_text(MANIFEST)
    with closing(Scratch([str(package)])) as scratch:
        scratch.check()
        delete_folder(os.path.dirname(scratch.root))
        with pytest.raises(UserError, match="was deleted by another program; run urdfctl again"):
            scratch.check()
