"""The workspace of a file: named, else a repository or workspace around it, else here, else its package or folder."""

from __future__ import annotations

from pathlib import Path

import pytest
from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.source.workspaces.workspace import workspace_of

PACKAGE = "<package><name>arm</name></package>"


def workspace(folder: Folder, file: str, named: str | None = None) -> str:
    found = Path(workspace_of(str(folder.path / file), named))
    return found.relative_to(folder.path).as_posix()


@pytest.fixture
def elsewhere(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> Folder:
    """A folder beside the files is the current one."""
    (folder.path / "elsewhere").mkdir()
    monkeypatch.chdir(folder.path / "elsewhere")
    return folder


def test_a_named_workspace_comes_first(folder: Folder) -> None:
    folder.write({"repo/.git/HEAD": "", "repo/arm/arm.xacro": "", "wide/x": ""})
    assert workspace(folder, "repo/arm/arm.xacro", "wide") == "wide"


def test_the_nearest_repository_around_the_file_bounds_it(elsewhere: Folder) -> None:
    elsewhere.write({".git/HEAD": "", "repo/.git/HEAD": "", "repo/arm/package.xml": PACKAGE, "repo/arm/arm.xacro": ""})
    assert workspace(elsewhere, "repo/arm/arm.xacro") == "repo"


def test_the_file_git_of_a_worktree_or_submodule_counts_too(elsewhere: Folder) -> None:
    elsewhere.write({"repo/.git": "gitdir: ../x", "repo/arm/arm.xacro": ""})
    assert workspace(elsewhere, "repo/arm/arm.xacro") == "repo"


def test_a_folder_src_with_packages_makes_a_workspace(elsewhere: Folder) -> None:
    elsewhere.write({"ws/src/group/arm/package.xml": PACKAGE, "ws/src/group/arm/urdf/arm.xacro": ""})
    assert workspace(elsewhere, "ws/src/group/arm/urdf/arm.xacro") == "ws"


def test_the_folder_src_of_a_package_makes_none(elsewhere: Folder) -> None:
    elsewhere.write({"arm/package.xml": PACKAGE, "arm/src/arm.cpp": "", "arm/urdf/arm.xacro": ""})
    assert workspace(elsewhere, "arm/urdf/arm.xacro") == "arm"


def test_a_folder_src_without_packages_makes_none(folder: Folder) -> None:
    folder.write({"project/src/main.py": "", "project/arm.xacro": ""})
    assert workspace(folder, "project/arm.xacro") == "."


def test_from_the_current_folder_on_when_the_file_lies_in_it(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    folder.write({"repo/.git/HEAD": "", "repo/vendor/arm/.git/HEAD": "", "repo/vendor/arm/arm.xacro": ""})
    monkeypatch.chdir(folder.path / "repo")
    assert workspace(folder, "repo/vendor/arm/arm.xacro") == "repo"
    monkeypatch.chdir(folder.path / "repo/vendor/arm")
    assert workspace(folder, "repo/vendor/arm/arm.xacro") == "repo/vendor/arm"


def test_without_a_repository_the_current_folder_if_the_file_lies_in_it(folder: Folder) -> None:
    folder.write({"arm/package.xml": PACKAGE, "arm/urdf/arm.xacro": ""})
    assert workspace(folder, "arm/urdf/arm.xacro") == "."


def test_else_the_package_of_the_file(elsewhere: Folder) -> None:
    elsewhere.write({"arm/package.xml": PACKAGE, "arm/urdf/arm.xacro": ""})
    assert workspace(elsewhere, "arm/urdf/arm.xacro") == "arm"


def test_else_the_folder_of_the_file(elsewhere: Folder) -> None:
    elsewhere.write({"lone/urdf/arm.xacro": ""})
    assert workspace(elsewhere, "lone/urdf/arm.xacro") == "lone/urdf"


# -- what the bounds allow -------------------------------------------------------------------------------------------

INCLUDING = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="{}"/>
  <link name="base"/>
</robot>
"""
PART = "<robot><link name='part'/></robot>"


def codes(settings: Settings) -> list[str]:
    linted = lint_target(Loader(settings), Target("robot/arm.xacro"), Selection(select=("UC0",))).result
    return [diagnostic.code for diagnostic in linted.outcome.diagnostics]


def test_an_include_outside_the_workspace_is_refused_and_allowed_by_each_of_three_options(folder: Folder) -> None:
    folder.write({"robot/arm.xacro": INCLUDING.format("../parts/part.xacro"), "parts/part.xacro": PART})
    assert codes(Settings(workspace="robot")) == ["UC016"]
    assert codes(Settings(workspace=".")) == []
    assert codes(Settings(workspace="robot", package_paths=("parts",))) == []
    assert codes(Settings(workspace="robot", trust=True)) == []


def test_a_link_out_of_the_workspace_is_no_way_out(folder: Folder) -> None:
    folder.write({"robot/arm.xacro": INCLUDING.format("part.xacro"), "parts/part.xacro": PART})
    (folder.path / "robot/part.xacro").symlink_to(folder.path / "parts/part.xacro")
    assert codes(Settings(workspace="robot")) == ["UC016"]


def test_a_package_that_the_environment_names_may_be_read(folder: Folder) -> None:
    folder.write(
        {
            "robot/arm.xacro": INCLUDING.format("$(find parts)/part.xacro"),
            "opt/parts/package.xml": "<package><name>parts</name></package>",
            "opt/parts/part.xacro": PART,
        }
    )
    assert codes(Settings(workspace="robot")) == ["UC003"]
    assert codes(Settings(workspace="robot", environ={"ROS_PACKAGE_PATH": str(folder.path / "opt")})) == []
