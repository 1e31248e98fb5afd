"""A migration as commits, one for each step, and with names of the project's own."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from classic_packages import CONTROL, CONTROLLERS, base
from folder import Folder
from ros1_packages import arm, migrated, transmission

WORDS = ("migrate", "--from", "humble", "--to", "jazzy", "--simulator", "gz")
MANIFEST = """\
<package format="3">
  <name>base</name><version>1.0.0</version><description>it</description>
  <maintainer email="a@b.c">a</maintainer><license>MIT</license>
  <exec_depend>gazebo_ros2_control</exec_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""


def git(*words: str) -> str:
    own = ("-c", "user.name=a", "-c", "user.email=a@b.c")
    return subprocess.run(["git", *own, *words], check=True, capture_output=True, text=True).stdout


@pytest.fixture
def repository(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> Folder:
    for name in ("AUTHOR", "COMMITTER"):
        monkeypatch.setenv(f"GIT_{name}_NAME", "a")
        monkeypatch.setenv(f"GIT_{name}_EMAIL", "a@b.c")
    folder.write({"package.xml": MANIFEST})
    folder.write({"urdf/base.xacro": base(CONTROL)})
    folder.write({"config/controllers.yaml": CONTROLLERS})
    folder.write({"doc/old/note.txt": "It is not committed again.\n"})
    git("init", "--quiet")
    git("add", "--all")
    git("commit", "--quiet", "--message", "one")
    return folder


def test_each_step_is_a_commit_with_its_authority(repository: Folder) -> None:
    ran = repository.run(*WORDS, "--commits")
    assert ran.returncode == 0, ran.stderr
    titles = git("log", "--format=%s").splitlines()
    assert titles[0] == "Report the migration to jazzy"
    assert "Migrate to jazzy: Packages of Gazebo Classic (classic-manifest)" in titles
    assert git("status", "--porcelain") == ""
    body = git("log", "--format=%b", "--grep", "classic-control-plugin")
    assert "- the plugin for ros2_control became" in body
    assert "(gz_ros2_control doc/index.rst" in body
    files = git("log", "--format=", "--name-only", "--grep", "classic-manifest").split()
    assert files == ["package.xml"]


def test_the_commits_together_are_what_in_place_makes(repository: Folder) -> None:
    assert repository.run(*WORDS, "--commits").returncode == 0
    names = git("ls-files").split()
    made = {name: Path(name).read_bytes() for name in names}
    git("reset", "--quiet", "--hard", git("rev-list", "--max-parents=0", "HEAD").strip())
    assert repository.run(*WORDS, "--in-place").returncode == 0
    assert made == {name: Path(name).read_bytes() for name in names}


@pytest.mark.parametrize("words", [(), ("--force",)])
def test_nothing_is_committed_beside_changes_of_the_user(repository: Folder, words: tuple[str, ...]) -> None:
    repository.write({"doc/old/note.txt": "It is changed.\n"})
    ran = repository.run(*WORDS, "--commits", *words)
    assert ran.returncode == 2
    assert "is in a repository with changes that are not committed; commit them first" in ran.stderr
    assert len(git("log", "--format=%s").splitlines()) == 1


def test_without_a_repository_nothing_is_committed(folder: Folder) -> None:
    folder.write({"package.xml": MANIFEST})
    ran = folder.run(*WORDS, "--commits")
    assert ran.returncode == 2
    assert "is in no git repository" in ran.stderr


def test_a_hook_of_the_repository_does_not_run(repository: Folder) -> None:
    hook = Path(".git/hooks/pre-commit")
    hook.parent.mkdir(exist_ok=True)
    hook.write_text("#!/bin/sh\nexit 1\n")
    hook.chmod(0o755)
    assert repository.run(*WORDS, "--commits").returncode == 0


OWN = """\
[migrate.names]
"acme/Stiff" = "acme_control/Stiff"
"acme_driver" = "acme_ros2_driver"
"/acme/cmd" = "/acme/command"
"""
LAUNCH = """\
<launch>
  <node pkg="{package}" type="node" name="driver"><remap from="cmd" to="/acme/cmd"/></node>
  <rosparam file="$(find arm)/config/c.yaml" command="load"/>
  <node pkg="controller_manager" type="spawner" name="s" args="stiff"/>
</launch>
"""


@pytest.mark.parametrize("own", [OWN, ""])
def test_names_of_the_project_have_the_successors_that_it_names(folder: Folder, own: str) -> None:
    files = {
        "urdfctl.toml": own,
        "launch/arm.launch": LAUNCH.format(package="acme_driver"),
        "config/c.yaml": "stiff:\n  type: acme/Stiff\n  joint: shoulder\n",
        "urdf/arm.xacro": arm(transmission("EffortJointInterface")),
        "src/node.cpp": 'auto topic = "/acme/cmd";\nauto other = "/acme/cmd_vel";\n',
    }
    after = migrated(folder, files)
    launch, report = after["launch/arm.launch.py"], after["MIGRATION.md"]
    assert ('package="acme_ros2_driver"' in launch) is bool(own)
    assert ('"/acme/command"' in launch) is bool(own)
    assert ("check that package 'acme_driver'" in launch) is not bool(own)
    assert ("type: acme_control/Stiff" in after["config/c.yaml"]) is bool(own)
    assert ("port the controller type" in after["config/c.yaml"]) is not bool(own)
    assert ("`src/node.cpp:1`: names '/acme/cmd', which is '/acme/command' now: change it here" in report) is bool(own)
