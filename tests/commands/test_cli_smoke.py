"""`urdfctl smoke` on the command line: the robots tested, the reports, and the exit status."""

from __future__ import annotations

import json
import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from click.testing import Result
from folder import CHECKOUT, Folder
from smoking import smoked_in_workers
from smoking_engines import needs_pybullet
from typer.testing import CliRunner

from urdfctl.commands.app import app
from urdfctl.commands.find.smoke import SmokeOptions, run_smoke
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.lint.job import job_for, perform_alone
from urdfctl.load.target import Target
from urdfctl.rules.examples import unmarked
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE
from urdfctl.smoke import run
from urdfctl.smoke.engines import installed
from urdfctl.smoke.reports import render_smoke
from urdfctl.smoke.run import ConfiguredPaths, SmokeRequest, load_and_judge

SAMPLES = CHECKOUT / "samples"
SOUND = ["mybot", "my_robot", "radu"]
NONE = ("--engine", "none")


def smoke(*words: object) -> Result:
    """Run `urdfctl smoke` with some words in this process, except for its workers."""
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
def test_progress_is_told_without_a_terminal_if_it_is_asked_for(folder: Folder) -> None:
    words = ("smoke", str(SAMPLES / "my_robot"), "--engine", "pybullet")
    assert folder.run(*words).stderr == ""
    assert "[1/2] " in folder.run(*words, "--progress").stderr


def test_quiet_shows_only_the_findings_and_statistics_count_them() -> None:
    sample = SAMPLES / "broken" / "mybot"
    whole, quiet = smoke(sample, *NONE), smoke(sample, *NONE, "-q", "--statistics")
    findings = [line for line in whole.stdout.splitlines() if " error UC9" in line]
    assert [line for line in quiet.stdout.splitlines() if " error UC9" in line] == findings
    assert quiet.stdout.startswith(findings[0])
    assert whole.stdout.endswith(" failed\n")
    assert re.search(r"\n +\d  error   UC9\d\d [a-z-]+\n$", quiet.stdout)


@pytest.mark.parametrize("name", [*SOUND, "broken/mybot"])
def test_the_stages_called_from_python_make_the_report_of_the_command(name: str) -> None:
    group = ConfiguredPaths((str(SAMPLES / name),), Config(), Settings())
    tests = run.smoke([group], SmokeRequest())
    assert render_smoke(run.report(tests, [group]), "text") == smoke(SAMPLES / name, *NONE).stdout


def test_each_stage_hands_the_next_one_what_it_needs() -> None:
    group, request = ConfiguredPaths((str(SAMPLES / "mybot"),), Config(), Settings()), SmokeRequest()
    planned = run.plan(run.find(group), group, request)
    assert {Path(robot.target.path).name for robot in planned} == {"mybot.xacro", "control.launch"}
    checked = run.check([robot.target for robot in planned], [robot.settings for robot in planned], request)
    assert list(run.move(checked, request, group.settings)) == [robot.result for robot in checked]
    assert {each.verdict.value for robot in checked for each in robot.result.controllers} == {"skipped"}


def test_the_report_goes_to_a_file(tmp_path: Path) -> None:
    done = smoke(SAMPLES / "mybot", *NONE, "-o", tmp_path / "report.json", "--format", "json")
    assert (done.exit_code, done.stdout) == (0, "")
    assert json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))["controllers"]
    refused = smoke(SAMPLES / "mybot", *NONE, "-o", "a", "--format", "json=b")
    assert isinstance(refused.exception, UserError)
    assert "--output-file takes one report" in str(refused.exception)


@pytest.mark.parametrize(
    ("environ", "coloured"),
    [({}, False), ({"FORCE_COLOR": "1"}, True), ({"FORCE_COLOR": "1", "NO_COLOR": "1"}, False)],
)
def test_colours_are_forced_by_force_color(folder: Folder, environ: dict[str, str], *, coloured: bool) -> None:
    done = folder.run("smoke", str(SAMPLES / "mybot"), *NONE, environ=environ)
    assert ("\x1b[" in done.stdout) is coloured


def test_the_help_lists_the_formats_of_smoke() -> None:
    assert "--format [text|json|junit|sarif|github|gitlab]" in smoke("--help").stdout


@needs_pybullet
@pytest.mark.parametrize("name", SOUND)
def test_a_sound_sample_passes_when_it_is_moved(name: str) -> None:
    done = smoke(SAMPLES / name, "--engine", "pybullet")
    assert done.exit_code == 0, done.stdout
    assert " passed   load > " in done.stdout
    assert "skipped" not in done.stdout


@needs_pybullet
def test_it_is_simulated_by_default(tmp_path: Path) -> None:
    report = json.loads(smoke(SAMPLES / "radu", "--format", "json").stdout)
    assert {(controller["verdict"], controller["engine"]) for controller in report["controllers"]} == {
        ("passed", " and ".join(installed()))
    }


def test_without_an_engine_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("urdfctl.smoke.engines.engine.NAMES", ())
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
    report = json.loads(smoke(SAMPLES / "mybot", *NONE, "--format", "json").stdout)
    assert report["findings"] == []
    assert [
        (controller["type"], controller["verdict"], controller["stage"]) for controller in report["controllers"]
    ] == [
        ("joint_state_controller/JointStateController", "skipped", "activate"),
        ("effort_controllers/JointVelocityController", "skipped", "activate"),
        ("effort_controllers/JointVelocityController", "skipped", "activate"),
    ]
    assert report["controllers"][0]["name"] == "joint_state_controller"
    assert report["controllers"][0]["reason"] == "not simulated: no physics engine was used"


def test_junit_has_a_test_case_for_each_controller() -> None:
    root = ET.fromstring(
        smoke(SAMPLES / "broken" / "my_robot", *NONE, "--distro", "noetic", "--format", "junit").stdout
    )
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
        report = json.loads(smoke(SAMPLES, *NONE, "--format", "json", *words).stdout)
        return [(target["robot"], *target["controllers"]) for target in report["targets"]]

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
    assert "no controllers are declared for this robot" in smoke(robot, *NONE).stdout


SPARE = """\
controller_manager:
  ros__parameters:
    update_rate: 50
    mover: {type: joint_trajectory_controller/JointTrajectoryController}
mover:
  ros__parameters: {joints: [unknown], command_interfaces: [position], state_interfaces: [position]}
"""


def bare_robot(folder: Path) -> Path:
    """A robot with hardware, and nothing that controls it."""
    robot = folder / "robot.urdf"
    robot.write_text(unmarked({"robot.urdf": HARDWARE})[0]["robot.urdf"], encoding="utf-8")
    return robot


def test_a_run_that_tested_no_controller_is_not_green(tmp_path: Path) -> None:
    robot = bare_robot(tmp_path)
    done = smoke(robot, *NONE)
    assert done.exit_code == 5
    assert "nothing was tested: no controllers found; name their file with --controllers, or see what" in done.stdout
    assert f"'urdfctl gen-all {robot}' proposes\n" in done.stdout
    assert smoke(bare_robot(tmp_path), *NONE, "--allow-empty").exit_code == 0


def test_a_run_without_a_robot_says_that_models_in_sdf_are_not_read(tmp_path: Path) -> None:
    (tmp_path / "model.sdf").write_text("<sdf version='1.9'><model name='ball'><link name='ball'/></model></sdf>")
    (tmp_path / "world.launch").write_text('<launch><node pkg="gazebo_ros" type="gzserver" name="gazebo"/></launch>')
    done = smoke(tmp_path, *NONE)
    assert done.exit_code == 5
    assert "there is no robot in URDF or xacro here; models in SDF are not read\n" in done.stdout


def test_a_run_that_tested_no_controller_names_a_controller_file_that_no_robot_uses(tmp_path: Path) -> None:
    robot, config = bare_robot(tmp_path), tmp_path / "config" / "spare.yaml"
    config.parent.mkdir()
    config.write_text(SPARE, encoding="utf-8")
    told = smoke(tmp_path, *NONE).stdout
    assert f"no robot uses '{config}': urdfctl smoke {robot} --controllers {config}\n" in told
    config.write_text("planner_server: {ros__parameters: {update_rate: 5}}\n", encoding="utf-8")
    assert "no robot uses" not in smoke(tmp_path, *NONE).stdout


def test_a_run_that_tested_no_controller_fails_in_junit_too(tmp_path: Path) -> None:
    root = ET.fromstring(smoke(bare_robot(tmp_path), *NONE, "--format", "junit").stdout)
    assert root.get("failures") == "1"
    assert [case.get("name") for case in root.iter("testcase") if case.find("failure") is not None] == [
        "nothing was tested"
    ]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--only", "hand"), "--only: no robot has a controller 'hand'"),
        (("--controllers", "extar.yaml"), "file does not exist: 'extar.yaml'"),
    ],
)
def test_an_option_that_matches_nothing_is_an_error(tmp_path: Path, words: tuple[str, ...], message: str) -> None:
    with pytest.raises(UserError, match=re.escape(message)):
        raise smoke(bare_robot(tmp_path), *NONE, *words).exception or AssertionError


def test_a_folder_without_robots_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(UserError, match=r"nothing to test in .*: name a robot or a launch file"):
        raise smoke(tmp_path, *NONE).exception or AssertionError


def test_a_named_controller_file_is_read_wherever_it_is(tmp_path: Path) -> None:
    inside = tmp_path / "inside"
    inside.mkdir()
    outside = tmp_path / "extra.yaml"
    outside.write_text(CONTROLLERS % ("arm", "joints: [elbow]"), encoding="utf-8")
    done = smoke(bare_robot(inside), "--workspace", inside, "--controllers", outside, *NONE)
    assert "2 controllers: 2 skipped" in done.stdout


def test_a_terminal_gets_colours(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert run_smoke(SmokeOptions(paths=(str(SAMPLES / "radu"),), engine="none")) == 0
    assert "velocity_controller" in capsys.readouterr().out


def test_a_robot_that_takes_too_much_is_reported(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text("<robot name='r'>" + '<link name="a"/>' * 50_000 + "</robot>", encoding="utf-8")
    [made] = smoked_in_workers([Target(str(path))], [Settings(timeout=0.05)], SmokeRequest())
    assert [finding.code for finding in made.linted.outcome.diagnostics] == ["UC014"]


def test_a_worker_can_begin_with_a_job_alone() -> None:
    path = str(SAMPLES / "radu" / "urdf" / "radu.urdf.xacro")
    job = job_for(load_and_judge, Target(path), Settings(), details=SmokeRequest()._asdict())
    assert perform_alone(json.loads(json.dumps(job)))["linted"]["robot"] == "radu"


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["--engine", "nonne"], "unknown engine 'nonne'; did you mean 'none'?"),
        (["--shard", "3/2"], "--shard must be K/N with K from 1 to N"),
        (["--duration", "0", *NONE], "--duration must be a number of seconds up to 60, not 0"),
        (["--jobs", "-1"], "--jobs must be a number of robots"),
        (["--format", "jsn"], "unknown format 'jsn'; did you mean 'json'?"),
        (["--format", "json="], "--format json= requires the name of a file"),
        (["--report", ""], "--report requires the name of a file"),
        (["--controllers", ""], "--controllers requires the name of a file"),
        (["--shard", ""], "--shard must be K/N"),
    ],
)
def test_a_meaningless_option_is_an_error_of_the_user(words: list[str], why: str) -> None:
    done = smoke(SAMPLES / "radu", *words)
    assert isinstance(done.exception, UserError)
    assert why in str(done.exception)


def test_a_page_of_html_is_written(tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    assert smoke(SAMPLES / "radu", *NONE, "--report", path).exit_code == 0
    text = path.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "velocity_controller" in text
    assert "<h3>The robot" in text
