"""`urdfctl smoke` in a pipeline: which findings count, what is known, and what a report of JUnit says."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from click.testing import Result
from smoking_engines import needs_pybullet
from typer.testing import CliRunner

from urdfctl.commands.app import app
from urdfctl.errors import UserError
from urdfctl.rules.examples import unmarked
from urdfctl.rules.smoke.common import CONTROLLERS, GAINS, HARDWARE, LIFT


def smoke(folder: Path, *words: str) -> Result:
    """Run `urdfctl smoke` without an engine on the robot in a folder."""
    controllers = ("--controllers", str(folder / "controllers.yaml"), "--distro", "jazzy", "--engine", "none")
    return CliRunner().invoke(app, ["smoke", str(folder / "robot.urdf"), *controllers, *words])


def write(folder: Path, robot: str, controllers: str) -> Path:
    """Write a robot with its controllers, both in the short form of rule examples."""
    files, _ = unmarked({"robot.urdf": robot, "controllers.yaml": controllers})
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder


@pytest.fixture
def weak(tmp_path: Path) -> Path:
    """Return a folder with a lift that cannot carry its weight: one error, UC915."""
    return write(tmp_path, LIFT.replace('effort="500"', 'effort="20"'), GAINS % "mover")


@pytest.fixture
def scanty(tmp_path: Path) -> Path:
    """Return a folder with a lift that carries its weight with hardly any margin: one warning, UC950."""
    return write(tmp_path, LIFT.replace('effort="500"', 'effort="50"'), GAINS % "mover")


def test_an_ignored_finding_does_not_fail_its_controller(weak: Path) -> None:
    assert smoke(weak).exit_code == 1
    done = smoke(weak, "--ignore", "UC915", "--format", "json")
    assert done.exit_code == 0
    report = json.loads(done.stdout)
    assert report["findings"] == []
    assert [entry["verdict"] for entry in report["controllers"]] == ["skipped", "warned"]


def test_only_selected_findings_count(weak: Path) -> None:
    assert smoke(weak, "--select", "UC915").exit_code == 1
    assert smoke(weak, "--select", "UC93").exit_code == 0


def test_a_warning_fails_a_run_that_says_so(scanty: Path) -> None:
    assert smoke(scanty).exit_code == 0
    assert smoke(scanty, "--fail-on", "warning").exit_code == 1
    assert smoke(scanty, "--fail-on", "warning", "--exit-zero").exit_code == 0


def test_a_known_finding_is_hidden(weak: Path) -> None:
    known = str(weak / "known.json")
    assert smoke(weak, "--write-baseline", known).exit_code == 0
    done = smoke(weak, "--baseline", known)
    assert (done.exit_code, "UC915" in done.stdout) == (0, False)
    assert "hidden finding: joint 'lift' needs" in done.stdout


@pytest.mark.parametrize(
    ("words", "message"),
    [(("--fail-on", "fatal"), "--fail-on must be error"), (("--select", "XX"), "no rule's code begins with 'XX'")],
)
def test_a_meaningless_option_is_an_error(weak: Path, words: tuple[str, ...], message: str) -> None:
    done = smoke(weak, *words)
    assert isinstance(done.exception, UserError)
    assert message in str(done.exception)


def test_one_fault_of_the_robot_is_one_failure_of_junit(tmp_path: Path) -> None:
    robot = HARDWARE.replace("<plugin>mock_components/GenericSystem</plugin>", "")
    write(tmp_path, robot, CONTROLLERS % ("arm", "joints: [shoulder, elbow]"))
    root = ET.fromstring(smoke(tmp_path, "--format", "junit").stdout)
    assert root.get("failures") == "1"
    assert {case.get("name"): [part.tag for part in case] for case in root.iter("testcase")} == {
        "states": ["skipped"],
        "arm": ["skipped"],
        next(case.get("name") for case in root.iter("testcase") if "UC902" in str(case.get("name"))): ["failure"],
    }


def test_a_failed_controller_is_one_failure_of_junit(weak: Path) -> None:
    root = ET.fromstring(smoke(weak, "--format", "junit").stdout)
    assert root.get("failures") == "1"
    (failed,) = [case for case in root.iter("testcase") if case.find("failure") is not None]
    assert failed.get("name") == "mover"


def test_one_error_of_several_controllers_is_one_failure_of_junit(tmp_path: Path) -> None:
    yaml = (CONTROLLERS % ("arm", "joints:")).replace("update_rate: 100", "update_rate:")
    write(tmp_path, HARDWARE, yaml)
    root = ET.fromstring(smoke(tmp_path, "--format", "junit").stdout)
    kinds = {case.get("name"): [part.tag for part in case] for case in root.iter("testcase")}
    assert (kinds["states"], kinds["arm"]) == (["failure"], ["skipped"])
    assert root.get("failures") == "1"


@needs_pybullet
def test_junit_has_the_time_of_each_controller_and_json_what_was_measured(tmp_path: Path) -> None:
    write(tmp_path, LIFT, GAINS % "mover")
    junit = tmp_path / "junit.xml"
    options = ("--engine", "pybullet", "--format", "json", "--format", f"junit={junit}")
    report = json.loads(smoke(tmp_path, *options).stdout)
    times = {case.get("name"): float(case.get("time") or 0) for case in ET.parse(junit).iter("testcase")}
    assert times["mover"] > 0.01
    [measured] = [each for each in report["measurements"] if each["controller"] == "mover"]
    [curve] = [each for each in report["curves"] if each["controller"] == "mover"]
    assert (measured["joint"], measured["quantity"]) == ("lift", "position")
    assert measured["error"] == pytest.approx(curve["measured"][-1] - curve["commanded"][-1], abs=1e-4)
    assert abs(measured["error"]) <= measured["largest_error"] < 0.05


def test_each_robot_is_tested_with_the_configuration_around_it(tmp_path: Path) -> None:
    for distro in ("humble", "jazzy"):
        (tmp_path / distro).mkdir()
        write(tmp_path / distro, LIFT.replace('effort="500"', 'effort="20"'), GAINS % "mover")
        (tmp_path / distro / "urdfctl.toml").write_text(f'distro = "{distro}"', encoding="utf-8")
    paths = [str(tmp_path / distro / "robot.urdf") for distro in ("humble", "jazzy")]
    done = CliRunner().invoke(app, ["smoke", *paths, "--engine", "none"])
    for distro in ("humble", "jazzy"):
        assert f"{distro}/robot.urdf ({distro} from urdfctl.toml" in done.stdout


def test_a_file_is_ignored_where_its_own_configuration_says_so(weak: Path) -> None:
    (weak / "urdfctl.toml").write_text('[per-file-ignores]\n"*" = ["UC915"]', encoding="utf-8")
    assert smoke(weak).exit_code == 0
    other = weak / "other"
    other.mkdir()
    (other / "robot.urdf").write_text("<robot name='other'><link name='base'/></robot>", encoding="utf-8")
    (other / "urdfctl.toml").write_text("", encoding="utf-8")
    assert smoke(weak, str(other / "robot.urdf"), "--select", "UC915").exit_code == 0
