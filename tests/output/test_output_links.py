"""Nothing is written through a symbolic link that leads out of a workspace, by whatever command."""

from __future__ import annotations

import json
import os
import re
import sys
from pathlib import Path

import pytest
from folder import Folder
from generating import command

from urdfctl.errors import UserError
from urdfctl.output.change import Change
from urdfctl.output.links import destination
from urdfctl.output.writing import write_file
from urdfctl.output.writing_all import write_all

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links need rights on Windows")
ROBOT = """\
<robot name="r">
  <link name="base"/><link name="fore"/>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="fore"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="5" velocity="1"/></joint>
  <ros2_control name="hw" type="system"><hardware><plugin>ign_ros2_control/IgnitionSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
WRONG = ROBOT.replace('lower="-1" upper="1"', 'lower="1" upper="-1"')
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
arm:
  ros__parameters: {joints: [elbow], command_interfaces: [position], state_interfaces: [position]}
"""
MANIFEST = '<package format="3"><name>arm</name></package>\n'
BODY = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
SOUND = re.sub(r"<ros2_control.*</ros2_control>", "", ROBOT, flags=re.DOTALL)
SOUND = SOUND.replace('<link name="base"/><link name="fore"/>', f'<link name="base"/><link name="fore">{BODY}')
FILES = {
    "urdf/r.urdf": ROBOT,
    "urdf/s.urdf": SOUND,
    "config/c.yaml": CONTROLLERS,
    "package.xml": MANIFEST,
    ".git/HEAD": "",
}
GENERATE = "urdf/r.urdf --distro jazzy"
STARTS = "urdf/s.urdf --distro jazzy --simulator none --hardware mock"
"""A robot that would start: others are refused before anything is written."""
WRITERS = [
    *(f"lint urdf/r.urdf --format {name}=@" for name in "text concise json jsonl sarif github gitlab junit".split()),
    "lint urdf/r.urdf -o @",
    "lint urdf/r.urdf --report @",
    "lint urdf/r.urdf --write-baseline @",
    "lint urdf/r.urdf --fix --unsafe-fixes --format json=@",
    *(f"smoke urdf/r.urdf --engine none --format {name}=@" for name in "text json junit sarif github".split()),
    "smoke urdf/r.urdf --engine none -o @",
    "smoke urdf/r.urdf --engine none --report @",
    "smoke urdf/r.urdf --engine none --write-baseline @",
    "show . --format json=@",
    "expand urdf/r.urdf -o @ --force",
    "expand urdf/r.urdf -o @",
    "why urdf/r.urdf elbow --format json=@",
    "diff urdf/r.urdf urdf/r.urdf --format json=@",
    *(f"graph . --format {name}=@" for name in "mermaid dot svg html json".split()),
    "view urdf/r.urdf -o @",
    "view urdf/r.urdf --image @.png",
    "explain UC101 -o @",
    *(f"{name} {GENERATE} --type trajectory -o @ --force" for name in ("gen-controllers", "gen-launch")),
    f"gen-controllers {GENERATE} --type trajectory -o @",
    f"gen-ros2-control {GENERATE} -o @ --force",
    f"gen-gazebo {GENERATE} --simulator gz -o @ --force",
    "gen-transmissions urdf/r.urdf --distro noetic -o @ --force",
    "convert urdf/r.urdf --to mjcf -o @ --force",
    f"gen-gazebo {GENERATE} --simulator gz --into @.xacro",
    "gen-transmissions urdf/r.urdf --distro noetic --into @.xacro",
    "migrate . --to jazzy --report @",
    "migrate . --to jazzy --in-place --force --report @",
    "migrate . --to jazzy -o new --report @",
]


def tree(folder: Path) -> dict[str, bytes]:
    """The files and links below a folder, with what is in them or where they lead, and the empty folders."""
    found = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        found[name] = os.readlink(path).encode() if path.is_symlink() else b"" if path.is_dir() else path.read_bytes()
    return found


def checkout(folder: Folder, links: dict[str, str]) -> dict[str, bytes]:
    """Make a checkout with some links, and files of the user beside it; work in it, and return all that is there."""
    folder.write({f"checkout/{name}": text for name, text in FILES.items()})
    ends = {"": "of the user\n", ".png": "of the user\n", ".xacro": ROBOT}
    kept = {f"home/{name}{end}": text for name in ("file", "deep/file") for end, text in ends.items()}
    folder.write(kept)
    os.chdir("checkout")
    for name, leads_to in links.items():
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        os.symlink(leads_to, name)
    return tree(folder.path)


@pytest.mark.parametrize("words", WRITERS)
@pytest.mark.parametrize("target", ["report", "out/file"])
def test_no_command_writes_through_a_committed_link(folder: Folder, words: str, target: str) -> None:
    ends = ("", ".png", ".xacro")
    links = {f"report{end}": f"../home/file{end}" for end in ends} if target == "report" else {"out": "../home/deep"}
    before = checkout(folder, links)
    end = next(end for end in (".png", ".xacro", "") if f"@{end}" in words)
    name, link = f"{target}{end}", f"report{end}" if target == "report" else "out"
    leads_to = folder.path / "home" / ("deep" if link == "out" else f"file{end}")
    ran = command(*words.replace("@", target).split())
    assert ran.stderr.splitlines()[-1] == (
        f"urdfctl: '{name}' is not written: '{link}' is a symbolic link that leads out of the workspace, "
        f"to '{leads_to}'; delete the link, or name another file"
    )
    assert (ran.returncode, tree(folder.path)) == (2, before)


@pytest.mark.parametrize(
    ("link", "words"),
    [
        ("robot.html", "view urdf/r.urdf"),
        ("MIGRATION.md", "migrate . --to jazzy --in-place --force"),
        ("new/MIGRATION.md", "migrate . --to jazzy -o new --force"),
        ("new/package.xml", "migrate . --to jazzy -o new --force"),
        ("new/urdf", "migrate . --to jazzy -o new --force"),
        ("new", "migrate . --to jazzy -o new --force"),
        ("new", "migrate . --to jazzy -o new/more --force"),
        ("new/config", f"gen-all {STARTS} --type trajectory -o new"),
        ("new/config", f"gen-all {GENERATE} --type trajectory -o new --force"),
        ("new/package.xml", f"gen-all {GENERATE} --type trajectory -o new --force"),
        ("new", f"gen-all {GENERATE} --type trajectory -o new --force"),
        ("new", f"gen-all {STARTS} --type trajectory -o new/more"),
        ("urdfctl.toml", "init --distro jazzy"),
        ("urdfctl.toml", "init --distro jazzy --force"),
        (".pre-commit-config.yaml", "init --distro jazzy --pre-commit"),
        (".github", "init --distro jazzy --workflow"),
        (".github/workflows", "init --distro jazzy --workflow"),
        (".github/workflows/urdfctl.yaml", "init --distro jazzy --workflow --pre-commit"),
    ],
)
@pytest.mark.parametrize("leads_to", ["home/deep", "home/nothing"])
def test_no_command_writes_through_a_link_in_a_place_that_it_chooses(
    folder: Folder, link: str, words: str, leads_to: str
) -> None:
    before = checkout(folder, {link: str(folder.path / leads_to)})
    ran = command(*words.split())
    assert (ran.returncode, tree(folder.path)) == (2, before)
    assert f"{link}' is a symbolic link that leads out of the workspace, to '{folder.path / leads_to}'" in ran.stderr


def test_gen_check_updates_no_file_through_a_link(folder: Folder) -> None:
    checkout(folder, {"config/made.yaml": "../../home/file"})
    outside = folder.path / "home/file"
    outside.write_text("# made by urdfctl gen-controllers urdf/r.urdf --type trajectory --distro jazzy\n")
    before = tree(folder.path)
    assert (command("gen-check", "config", "--update").returncode, tree(folder.path)) == (2, before)


def test_a_fix_or_a_migration_changes_no_file_through_a_link(folder: Folder) -> None:
    checkout(folder, {"urdf/linked.urdf": "../../home/wrong.urdf", "more": "../home"})
    folder.write({"home/wrong.urdf": WRONG})
    before = tree(folder.path)
    command("lint", "urdf/linked.urdf", "more/wrong.urdf", "--fix", "--unsafe-fixes", "--distro", "jazzy")
    assert tree(folder.path) == before
    command("migrate", ".", "--to", "jazzy", "--in-place", "--force")
    assert (folder.path / "home/wrong.urdf").read_text() == WRONG
    assert Path("urdf/linked.urdf").is_symlink()


def test_several_files_are_written_together_or_refused_together(folder: Folder) -> None:
    before = checkout(folder, {"link": "../home/file"})
    [problem] = write_all([Change(os.path.abspath(name), None, b"new") for name in ("first", "link")])
    assert "checkout/link' is a symbolic link that leads out of the workspace" in problem
    assert tree(folder.path) == before


def test_a_link_within_a_link_is_looked_at_too(folder: Folder) -> None:
    checkout(folder, {"first": "second", "second": "../home/file"})
    for path in ("first", "urdf/../first", os.path.abspath("first")):
        with pytest.raises(UserError, match=r"'.*first' is a symbolic link that leads out of the workspace"):
            destination(path)
    os.chdir("..")
    os.symlink("checkout/second", "own")  # a link of the user's to a link of the checkout
    with pytest.raises(UserError, match=r"'.*checkout/second' is a symbolic link that leads out of the workspace"):
        destination("own")


def test_a_link_cannot_widen_its_workspace(folder: Folder) -> None:
    folder.write({"home/.git/HEAD": ""})
    checkout(folder, {"out": "../home"})
    os.chdir(folder.path / "home")
    with pytest.raises(UserError, match=r"'.*checkout/out' is a symbolic link that leads out of the workspace"):
        destination(str(folder.path / "checkout/out/file"))


def test_what_belongs_to_git_counts_as_outside(folder: Folder) -> None:
    checkout(folder, {"report": ".git/config"})
    with pytest.raises(
        UserError, match=r"'report' is a symbolic link that leads to what belongs to git, '.*/\.git/config'"
    ):
        write_file("report", "text", force=True)


def test_a_link_to_itself_is_not_written(folder: Folder) -> None:
    checkout(folder, {"loop": "loop"})
    with pytest.raises(UserError, match="'loop' cannot be written: Too many levels of symbolic links"):
        write_file("loop", "text", force=True)


def test_links_within_the_workspace_and_links_of_the_system_are_followed(folder: Folder) -> None:
    checkout(folder, {"inside": "urdf", "again.urdf": "inside/r.urdf"})
    write_file("again.urdf", "new", force=True)
    assert (Path("again.urdf").is_symlink(), Path("urdf/r.urdf").read_text()) == (True, "new")
    os.symlink(folder.path / "home", folder.path / "own")  # as /tmp on macOS, or a home folder that is a link
    write_file(str(folder.path / "own/report"), "text", force=False)
    assert (folder.path / "home/report").read_text() == "text"
    write_file(os.devnull, "text", force=False)
    Path("urdf/r.urdf").write_text(ROBOT)
    reported = folder.run("lint", "urdf/r.urdf", "--format", "json=/dev/stdout", cwd=Path.cwd())
    assert json.loads(reported.stdout)["version"] == 1
    migrated = folder.run("migrate", ".", "--to", "jazzy", "-o", "copy", "--report", "/dev/stdout", cwd=Path.cwd())
    assert migrated.stdout.startswith("# "), migrated.stderr


def test_without_a_repository_the_current_folder_or_the_package_is_the_workspace(folder: Folder) -> None:
    folder.write({"plain/a": "", "pack/package.xml": MANIFEST, "pack/a": "", "home/file": ""})
    for name in ("plain", "pack"):
        os.symlink("../home/file", f"{name}/link")
    assert destination("plain/link") == str(folder.path / "home/file")  # within the current folder
    os.chdir("plain")
    for path in ("link", "../pack/link"):
        with pytest.raises(UserError, match="leads out of the workspace"):
            destination(path)
    assert destination(str(folder.path / "plain/a")) == str(folder.path / "plain/a")
