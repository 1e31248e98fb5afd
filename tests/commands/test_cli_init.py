"""`urdfctl init`: a configuration that lint and smoke then use."""

from __future__ import annotations

import json
from types import SimpleNamespace
from typing import Any

import pytest
from folder import Folder
from generating import command

from urdfctl import __version__
from urdfctl.commands.editor import init, origin
from urdfctl.errors import UserError

ROBOT = """<robot name="r"><link name="a"/><link name="b"/>
  <joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>{}</robot>"""
GZ = '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/></gazebo>'
PACKAGE = "<package format='3'><name>p</name></package>"


def test_the_robots_of_a_folder_are_written(folder: Folder) -> None:
    folder.write({"p/package.xml": PACKAGE, "p/urdf/r.urdf": ROBOT.format(GZ), "p/urdf/s.urdf": ROBOT.format("")})
    ran = command("init", "--distro", "jazzy", "--simulator", "gz")
    assert ran.returncode == 0
    assert (folder.path / "urdfctl.toml").read_text() == (
        'distro = "jazzy"\nsimulator = "gz"\n\n[[robot]]\npath = "p/urdf/r.urdf"\n\n[[robot]]\npath = "p/urdf/s.urdf"\n'
    )
    assert "'.pre-commit-config.yaml' is not written; --pre-commit adds it" in ran.stderr
    lint = command("lint", "--show-settings").stdout
    assert "jazzy" in lint
    assert "urdfctl.toml" in lint


def test_what_is_detected_is_written_and_the_rest_left_open(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(GZ)})
    ran = command("init")
    text = (folder.path / "urdfctl.toml").read_text()
    assert text.startswith('# distro = "jazzy"\nsimulator = "gz"\n')
    assert "ROS distro is unknown; set it in 'urdfctl.toml', or use --distro" in ran.stderr


def test_the_hook_and_the_workflow_are_written_once(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format("")})
    words = ("init", "--distro", "jazzy", "--pre-commit", "--workflow")
    assert command(*words).returncode == 0
    assert "- id: urdfctl-check" in (folder.path / ".pre-commit-config.yaml").read_text()
    assert (
        "urdfctl check . --distro jazzy --format github" in (folder.path / ".github/workflows/urdfctl.yaml").read_text()
    )
    assert command("init").stderr == "urdfctl: 'urdfctl.toml' exists; --force overwrites it\n"
    for again in (command(*words), command(*words, "--force")):
        assert "'.pre-commit-config.yaml' exists; add this to it if it is missing:" in again.stderr


def test_a_configuration_that_is_there_stays_and_gets_the_baseline(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(""), "urdfctl.toml": 'distro = "jazzy"\nexclude = ["old"]\n'})
    ran = command("init", "--workflow", "--baseline")
    assert ran.returncode == 0
    assert "these are the findings for" not in ran.stderr
    assert "'urdfctl.toml' stays; --force writes it anew" in ran.stderr
    text = (folder.path / "urdfctl.toml").read_text()
    assert text == 'baseline = "urdfctl-baseline.json"\ndistro = "jazzy"\nexclude = ["old"]\n'
    assert "--distro jazzy" in (folder.path / ".github/workflows/urdfctl.yaml").read_text()


def test_the_baseline_that_a_kept_configuration_names_is_the_one_that_is_written(folder: Folder) -> None:
    kept = 'distro = "jazzy"\n"baseline" = "ci/known findings.json"\n'
    folder.write({"r.urdf": ROBOT.format('<joint name="k" type="sideways"/>'), "urdfctl.toml": kept, "ci/x": ""})
    ran = command("init", "--baseline")
    assert ran.returncode == 0
    assert (folder.path / "urdfctl.toml").read_text() == kept
    assert json.loads((folder.path / "ci/known findings.json").read_text())["findings"]
    assert not (folder.path / "urdfctl-baseline.json").exists()
    assert ran.stderr.endswith("--write-baseline 'ci/known findings.json'\n")
    assert command("check", ".", "--engine", "none").returncode == 0


@pytest.mark.parametrize("engines", [(), ("mujoco",)])
def test_the_baseline_is_written_by_what_the_workflow_runs(
    folder: Folder, monkeypatch: pytest.MonkeyPatch, engines: tuple[str, ...]
) -> None:
    monkeypatch.setattr(init, "installed", lambda: engines)
    folder.write({"r.urdf": ROBOT.format("")})
    step = command("init", "--workflow", "--baseline", "--distro", "jazzy").stderr.splitlines()[-1]
    without_motion = "" if engines else " --engine none"
    assert step == f"urdfctl: next: urdfctl check .{without_motion} --write-baseline urdfctl-baseline.json"


def test_a_folder_without_robots_is_refused(folder: Folder) -> None:
    assert command("init").stderr == "urdfctl: no robot found in '.'\n"
    assert command("init", "none").stderr == "urdfctl: folder 'none' does not exist\n"


def files_written(folder: Folder) -> tuple[str, str]:
    """The hook and the workflow that init writes."""
    folder.write({"r.urdf": ROBOT.format("")})
    assert command("init", "--distro", "jazzy", "--pre-commit", "--workflow").returncode == 0
    names = (".pre-commit-config.yaml", ".github/workflows/urdfctl.yaml")
    hook, workflow = ((folder.path / name).read_text() for name in names)
    return hook, workflow


def installed_from(monkeypatch: pytest.MonkeyPatch, said: dict[str, Any] | None, remote: str = "") -> None:
    """Let urdfctl be installed from there: what pip wrote of it, and the remote of the repository around it."""
    text = None if said is None else json.dumps(said)
    monkeypatch.setattr(origin, "distribution", lambda _: SimpleNamespace(read_text=lambda _: text))
    monkeypatch.setattr(origin, "repository_of", lambda _: "/clone")
    monkeypatch.setattr(origin, "remote_of", lambda _: remote)
    monkeypatch.setattr(origin, "commit_of", lambda *_: "c0ffee")


def test_a_release_is_installed_from_the_index(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    installed_from(monkeypatch, None)
    hook, workflow = files_written(folder)
    assert f'additional_dependencies: ["urdfctl=={__version__}"]' in hook
    assert f'pip install "urdfctl[smoke]=={__version__}"' in workflow


def test_the_commit_of_a_repository_is_installed_with_its_account(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    installed_from(monkeypatch, {"url": "https://github.com/someone/urdfctl", "vcs_info": {"commit_id": "abc123"}})
    hook, workflow = files_written(folder)
    assert "language: python" in hook
    assert 'pip install "urdfctl[smoke] @ git+https://github.com/someone/urdfctl@abc123"' in workflow
    assert f"# - uses: someone/urdfctl@v{__version__}" in workflow


def test_a_clone_is_named_by_its_remote_and_commit(monkeypatch: pytest.MonkeyPatch) -> None:
    installed_from(monkeypatch, {"url": "file:///clone", "dir_info": {}}, "git@github.com:someone/urdfctl.git")
    found = origin.origin()
    assert (found.requirement, found.account) == ("urdfctl @ git+https://github.com/someone/urdfctl@c0ffee", "someone")
    assert "push it" in found.lacks


def test_what_does_not_exist_before_a_release_is_said(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    installed_from(monkeypatch, {"url": "file:///clone", "dir_info": {}})
    folder.write({"r.urdf": ROBOT.format("")})
    ran = command("init", "--distro", "jazzy", "--pre-commit", "--workflow")
    assert f"the workflow cannot install urdfctl before there is a release {__version__} of urdfctl" in ran.stderr
    assert "language: system" in (folder.path / ".pre-commit-config.yaml").read_text()


def test_a_folder_in_no_repository_has_no_remote(monkeypatch: pytest.MonkeyPatch) -> None:
    def none(_: str) -> str:
        raise UserError("in no repository")

    installed_from(monkeypatch, {"url": "file:///clone"})
    monkeypatch.setattr(origin, "repository_of", none)
    assert origin.origin().account is None


def test_a_baseline_hides_what_is_found_today_and_nothing_else(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format('<joint name="k" type="sideways"/>')})
    assert command("init", "--distro", "jazzy", "--baseline").returncode == 0
    assert (folder.path / "urdfctl.toml").read_text().startswith('baseline = "urdfctl-baseline.json"\n')
    assert json.loads((folder.path / "urdfctl-baseline.json").read_text())["findings"]
    said = command("init", "--distro", "jazzy", "--baseline", "--force").stderr
    assert "these are the findings for jazzy: without a distro, lint counts what others find, too" in said
    assert said.endswith("urdfctl: next: urdfctl check . --engine none --write-baseline urdfctl-baseline.json\n")
    assert command("check", ".", "--engine", "none").returncode == 0
    folder.write({"r.urdf": ROBOT.format('<joint name="k" type="sideways"/><joint name="k2" type="upwards"/>')})
    assert command("check", ".", "--engine", "none").returncode == 1
