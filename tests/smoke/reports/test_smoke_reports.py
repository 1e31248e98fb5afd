"""The reports of smoke tests: what each verdict looks like as text, for JUnit and as JSON."""

from __future__ import annotations

import json
from xml.etree import ElementTree as ET

import pytest

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.lint.results import Outcome, TargetResult
from urdfctl.model.stage import Stage
from urdfctl.smoke.reports import conditions, render_smoke, report_of, stages_reached
from urdfctl.smoke.results import ControllerResult, Curve, RobotResult, Verdict

PASSED = ControllerResult("arm", "acme/Arm", Verdict.PASSED, Stage.DEACTIVATE, tested=("moved",), seconds=0.5)
FAILED = PASSED._replace(name="hand", verdict=Verdict.FAILED, stage=Stage.CONFIGURE, reason="its joint is unknown")
BLOCKED = FAILED._replace(name="thumb", reason="controller 'hand' fails", blocked_by="hand")
WARNED = PASSED._replace(name="head", verdict=Verdict.WARNED, reason="it is hardly strong enough")
SKIPPED = PASSED._replace(name="lamp", verdict=Verdict.SKIPPED, stage=Stage.LOAD, reason="not simulated", tested=())
UNTESTED = PASSED._replace(name="leg", untested={"feedback": "it has no sensor"})


def robot(*controllers: ControllerResult, ros: int = 2, **fields: object) -> RobotResult:
    """Return the smoke test of a robot with some controllers, in MuJoCo."""
    linted = TargetResult(
        path="robot.urdf",
        ros=ros,
        distro="jazzy",
        distro_from=None,
        simulator=None,
        complete=True,
        library=False,
        robot="r",
        links=2,
        files=("robot.urdf",),
        outcome=Outcome([], []),
    )
    linted = linted._replace(**{name: fields.pop(name) for name in ("launch", "distro_from") if name in fields})
    return RobotResult(linted, controllers, "jazzy", "mujoco", 1.25, **fields)  # type: ignore[arg-type]


def text(*robots: RobotResult) -> list[str]:
    return render_smoke(report_of(robots, []), "text").splitlines()


def junit(*robots: RobotResult) -> ET.Element:
    return ET.fromstring(render_smoke(report_of(robots, []), "junit"))


def test_controllers_are_proposed_for_the_robot_with_the_most_joints_that_move() -> None:
    paths = {"camera.urdf": 0, "arm.urdf": 6, "gripper.urdf": 2}
    bare = [robot(ros=1)._replace(linted=robot().linted._replace(path=path, idle=paths[path])) for path in paths]
    assert text(*bare)[-1].endswith("see what 'urdfctl gen-all arm.urdf' proposes")
    spaced = robot()._replace(linted=robot().linted._replace(path="my arm.urdf"))
    assert "gen-all 'my arm.urdf'" in text(spaced)[-1]


def test_each_controller_has_a_line_with_its_verdict_and_why() -> None:
    assert text(robot(PASSED, FAILED, WARNED, SKIPPED)) == [
        "robot.urdf (jazzy; mujoco, 1.2 s)",
        "  arm   passed   load > configure > activate > move > deactivate  tested: moved",
        "  hand  failed   load > configure failed: its joint is unknown",
        "  head  warned   load > configure > activate > move > deactivate  it is hardly strong enough; tested: moved",
        "  lamp  skipped  load  not simulated",
        "no findings in robot.urdf (jazzy)",
        "4 controllers: 1 passed, 1 failed, 1 warned, 1 skipped",
    ]


def test_controllers_that_only_read_are_not_all_that_a_robot_needs() -> None:
    states = PASSED._replace(name="states", tested=("started", "read"))
    more = "name the files of others with --controllers, or see what 'urdfctl gen-all robot.urdf' proposes"
    assert text(robot(states))[-1] == f"1 controller: 1 passed; none of them moves a joint: {more}"
    assert text(robot(states), robot(PASSED))[-1] == "2 controllers: 2 passed"
    assert text(robot(states, SKIPPED))[-1] == "2 controllers: 1 passed, 1 skipped"


def test_the_summary_counts_one_controller_as_one() -> None:
    assert text(robot(PASSED))[-1] == "1 controller: 1 passed"
    assert text(robot(PASSED), robot(PASSED))[-1] == "2 controllers: 2 passed"


@pytest.mark.parametrize(("ros", "stages"), [(1, "load > activate"), (2, "load > configure > activate")])
def test_controllers_of_ros_1_are_not_configured(ros: int, stages: str) -> None:
    assert stages_reached(PASSED._replace(stage=Stage.ACTIVATE), ros) == stages


def test_a_robot_is_named_after_the_launch_file_that_starts_it_unless_that_is_its_file() -> None:
    assert text(robot(PASSED, launch="arm.launch.py"))[0].startswith("arm.launch.py: robot.urdf (")
    assert text(robot(PASSED, launch="robot.urdf"))[0].startswith("robot.urdf (")


@pytest.mark.parametrize(
    ("source", "told"),
    [("package.xml", "jazzy from package.xml; mujoco, 1.2 s"), ("--distro", "jazzy; mujoco, 1.2 s")],
)
def test_the_evidence_for_a_distro_is_told_unless_an_option_names_it(source: str, told: str) -> None:
    assert conditions(robot(PASSED, distro_from=source)) == told


def test_each_controller_is_a_test_case_and_one_cause_is_one_failure() -> None:
    suite = junit(robot(PASSED, FAILED, BLOCKED, WARNED, SKIPPED, UNTESTED))[0]
    cases = {case.get("name"): [(inner.tag, inner.get("message")) for inner in case] for case in suite}
    assert cases == {
        "arm": [],
        "hand": [("failure", "configure: its joint is unknown")],
        "thumb": [("skipped", "controller 'hand' fails")],
        "head": [],
        "lamp": [("skipped", "not simulated")],
        "leg": [],
        "leg: feedback": [("skipped", "it has no sensor")],
    }


def test_the_counts_of_a_suite_and_of_all_suites_are_those_of_their_cases() -> None:
    document = junit(robot(PASSED, FAILED), robot(SKIPPED, BLOCKED, UNTESTED))
    names = ("tests", "failures", "skipped")
    counts = [[int(suite.attrib[name]) for name in names] for suite in document]
    assert counts[:2] == [[2, 1, 0], [4, 0, 3]]
    assert [int(document.attrib[name]) for name in names] == [sum(column) for column in zip(*counts, strict=True)]


def test_a_finding_that_fails_a_controller_is_not_a_second_failure() -> None:
    """One fault in a pipeline is one failure: that of its controller. Other findings have their own."""
    place = Location("robot.urdf", line=1, column=1, end_line=1, end_column=2, start=0, end=1)
    messages = (FAILED.reason, "another fault")
    findings = [Diagnostic("UC915", "effort-limit-too-low", Severity.ERROR, told, place) for told in messages]
    told = render_smoke(report_of([robot(FAILED)], findings), "junit")
    assert told.count("<failure") == 2
    assert told.count(FAILED.reason) == 1


def test_json_has_the_verdicts_and_what_was_measured() -> None:
    curve = Curve("arm", "elbow", "position", (0.0, 1.0, 2.0), (0.0, 0.5, 1.0), (0.0, 0.2, 0.9))
    data = json.loads(render_smoke(report_of([robot(PASSED, FAILED, curves=(curve,))], []), "json"))
    assert [(one["name"], one["verdict"], one["engine"]) for one in data["controllers"]] == [
        ("arm", "passed", "mujoco"),
        ("hand", "failed", "mujoco"),
    ]
    assert data["measurements"] == [
        {
            "robot": "robot.urdf",
            "controller": "arm",
            "joint": "elbow",
            "quantity": "position",
            "commanded": 1.0,
            "measured": 0.9,
            "error": -0.1,
            "largest_error": 0.3,
        }
    ]
