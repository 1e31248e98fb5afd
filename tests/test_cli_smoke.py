"""`urdfctl smoke` on the command line: what is tested, how it is told, and the exit status."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from click.testing import Result
from folder import CHECKOUT, Folder
from smoking_engines import needs_pybullet
from typer.testing import CliRunner

from urdfctl.cli.app import app
from urdfctl.cli.smoke_command import Asked, run_smoke
from urdfctl.errors import UserError
from urdfctl.load import Target
from urdfctl.rules.examples import unmarked
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE
from urdfctl.settings import Settings
from urdfctl.smoke.job import Wanted, perform, smoke_all

SAMPLES = CHECKOUT / "samples"
SOUND = ["mybot", "my_robot", "radu"]
NONE = ("--engine", "none")


def smoke(*words: object) -> Result:
    """`urdfctl smoke` with some words, in this process (but for its workers)."""
    return CliRunner().invoke(app, ["smoke", *map(str, words)])


@pytest.mark.parametrize("name", SOUND)
def test_a_sound_sample_is_found_with_its_controllers_and_nothing_is_wrong(name: str) -> None:
    done = smoke(SAMPLES / name, *NONE)
    assert (done.exit_code, done.stderr) == (0, "")
    assert " skipped  load > " in done.stdout
    assert "failed" not in done.stdout


@pytest.mark.parametrize("name", SOUND)
def test_a_broken_sample_fails(name: str) -> None:
    done = smoke(SAMPLES / "broken" / name, *NONE)
    assert done.exit_code == 1
    assert " failed   " in done.stdout


@needs_pybullet
@pytest.mark.parametrize("name", SOUND)
def test_a_sound_sample_passes_when_it_is_moved(name: str) -> None:
    done = smoke(SAMPLES / name, "--engine", "pybullet")
    assert done.exit_code == 0, done.stdout
    assert " passed   load > " in done.stdout
    assert "skipped" not in done.stdout


@needs_pybullet
def test_it_is_moved_where_nothing_is_said(tmp_path: Path) -> None:
    said = json.loads(smoke(SAMPLES / "radu", "--format", "json").stdout)
    assert {(one["verdict"], one["engine"]) for one in said["controllers"]} == {("passed", "pybullet")}


def test_without_an_engine_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("urdfctl.smoke.engines.NAMES", ())
    done = smoke(SAMPLES / "radu")
    assert isinstance(done.exception, UserError)
    assert str(done.exception) == (
        "no physics engine is installed: pip install 'urdfctl[smoke]', or use --engine none to test without moving "
        "anything"
    )


def test_the_command_is_one_process(folder: Folder) -> None:
    done = folder.run("smoke", str(SAMPLES / "mybot"), *NONE)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.endswith("3 controllers: 3 skipped\n")


def test_json_has_an_entry_for_each_controller() -> None:
    said = json.loads(smoke(SAMPLES / "mybot", *NONE, "--format", "json").stdout)
    assert said["findings"] == []
    assert [(one["type"], one["verdict"], one["stage"]) for one in said["controllers"]] == [
        ("joint_state_controller/JointStateController", "skipped", "activate"),
        ("effort_controllers/JointVelocityController", "skipped", "activate"),
        ("effort_controllers/JointVelocityController", "skipped", "activate"),
    ]
    assert said["controllers"][0]["name"] == "joint_state_controller"
    assert said["controllers"][0]["reason"].startswith("structural only")


def test_junit_has_a_test_case_for_each_controller() -> None:
    root = ET.fromstring(smoke(SAMPLES / "broken" / "my_robot", *NONE, "--format", "junit").stdout)
    cases = {case.get("name"): [child.tag for child in case] for case in root.iter("testcase")}
    assert cases["joint1_position_controller"] == ["failure"]
    assert cases["joint_state_controller"] == ["skipped"]
    assert root.get("tests") == str(sum(len(suite) for suite in root))


@pytest.mark.parametrize("form", ["sarif", "github"])
def test_other_forms_are_those_of_lint(tmp_path: Path, form: str) -> None:
    done = smoke(SAMPLES / "broken" / "radu", *NONE, f"--format={form}={tmp_path / 'out'}")
    assert done.exit_code == 1
    assert "UC902" in (tmp_path / "out").read_text(encoding="utf-8")


def test_shards_share_the_robots_out() -> None:
    def robots(*words: str) -> list[tuple[str, ...]]:
        said = json.loads(smoke(SAMPLES, *NONE, "--format", "json", *words).stdout)
        return [(target["robot"], *target["controllers"]) for target in said["targets"]]

    parts = robots("--shard", "1/2") + robots("--shard", "2/2")
    assert sorted(parts) == sorted(robots())
    assert len(set(parts)) == len(parts)


def test_controllers_and_names_may_be_given(tmp_path: Path) -> None:
    robot = tmp_path / "robot.urdf"
    plain, _ = unmarked({"robot.urdf": HARDWARE})
    robot.write_text(plain["robot.urdf"], encoding="utf-8")
    yaml = tmp_path / "extra.yaml"
    yaml.write_text(CONTROLLERS % ("arm", "joints: [elbow]"), encoding="utf-8")
    done = smoke(robot, "--controllers", yaml, *NONE)
    assert "2 controllers: 2 skipped" in done.stdout
    assert "no controllers\n" in smoke(robot, "--controllers", yaml, "--only", "hand", *NONE).stdout
    assert "no controller is declared for it" in smoke(robot, *NONE).stdout


def test_a_folder_without_robots_says_so(tmp_path: Path) -> None:
    done = smoke(tmp_path, *NONE)
    assert done.exit_code == 0
    assert "no robot found in" in done.stderr


def test_a_terminal_is_shown_colours(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    monkeypatch.delenv("NO_COLOR", raising=False)
    asked = Asked((str(SAMPLES / "radu"),), Wanted())
    assert run_smoke(asked, Settings()) == 0
    assert "velocity_controller" in capsys.readouterr().out


def test_a_robot_that_takes_too_much_is_told_so(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text("<robot name='r'>" + '<link name="a"/>' * 50_000 + "</robot>", encoding="utf-8")
    [made] = smoke_all([Target(str(path))], Settings(timeout=0.05), Wanted())
    assert [one.code for one in made.linted.outcome.diagnostics] == ["UC014"]


def test_a_worker_can_begin_with_a_job_alone() -> None:
    path = str(SAMPLES / "radu" / "urdf" / "radu.urdf.xacro")
    job = {"target": Target(path)._asdict(), "settings": Settings().to_json(), "wanted": Wanted()._asdict()}
    job = json.loads(json.dumps(job))
    assert perform(job)["linted"]["robot"] == "radu"


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["--engine", "nonne"], "unknown engine 'nonne'; did you mean 'none'?"),
        (["--shard", "3/2"], "--shard is written K/N, K from 1 to N"),
        (["--duration", "0", *NONE], "--duration is a number of seconds up to 60, not 0"),
        (["--jobs", "-1"], "--jobs is a number of robots"),
        (["--format", "jsn"], "unknown format 'jsn'; did you mean 'json'?"),
        (["--format", "json="], "--format json= names no file"),
        (["--report", ""], "--report names no file"),
        (["--controllers", ""], "--controllers names no file"),
        (["--shard", ""], "--shard is written K/N"),
    ],
)
def test_what_means_nothing_is_an_error_of_the_user(words: list[str], why: str) -> None:
    done = smoke(SAMPLES / "radu", *words)
    assert isinstance(done.exception, UserError)
    assert why in str(done.exception)


def test_a_page_of_html_is_written(tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    assert smoke(SAMPLES / "radu", *NONE, "--report", path).exit_code == 0
    text = path.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "velocity_controller" in text
    assert "the robot at spawn" in text
