"""The stage at which an error of lint stops a controller."""

from __future__ import annotations

import pytest
from control_session import session

from urdfctl.control.session import Configured
from urdfctl.diagnostic import Finding, Severity, diagnosed
from urdfctl.model.stage import Stage
from urdfctl.smoke.lifecycle.lint_errors import found_by_manager, stage_stopped, stops_controller, stops_parameters
from urdfctl.source.span import Place, SourceText

NOWHERE = Finding(Place(SourceText("/c.yaml", b"x"), 0, end=1), "")
PARAMETERS, CONFIGURES, CHECKED, WORKED_OUT, ACTIVATES = "UC405", "UC439", "UC444", "UC434", "UC441"
"""Rules on errors that stop a file, a controller at one stage, where it checks its parameters, and by the manager."""


def stage(code: str, configured: Configured, ros: int = 2) -> Stage:
    return stage_stopped(diagnosed(code, "", Severity.ERROR, NOWHERE), configured, ros)


def controller(kind: str, parameters: str) -> Configured:
    declared = f"controller_manager:\n  ros__parameters:\n    arm: {{type: {kind}}}\n"
    [made] = session("", f"{declared}arm:\n  ros__parameters: {{{parameters}}}\n").controllers
    return made


FORWARD = controller("forward_command_controller/ForwardCommandController", "joints: [elbow], interface_name: position")
MINE = controller("my_controllers/Mine", "joints: [elbow]")


@pytest.mark.parametrize(
    ("code", "expected"), [(CONFIGURES, Stage.CONFIGURE), (ACTIVATES, Stage.ACTIVATE), (PARAMETERS, Stage.LOAD)]
)
def test_an_error_stops_a_controller_at_the_stage_of_its_rule_in_ros_2(code: str, expected: Stage) -> None:
    """What keeps a file from being read stops its controllers when they are loaded."""
    assert stage(code, FORWARD) is expected
    assert stage(code, FORWARD, ros=1) is Stage.LOAD


def test_a_missing_parameter_stops_on_load_and_a_wrong_one_where_it_is_checked() -> None:
    missing = controller("joint_trajectory_controller/JointTrajectoryController", "joints: [elbow]")
    assert stage(CHECKED, missing) is Stage.LOAD
    assert stage(CHECKED, MINE) is Stage.LOAD
    assert stage(CHECKED, FORWARD) is Stage.CONFIGURE


def test_errors_that_the_manager_works_out_are_not_counted_twice() -> None:
    for code, manager, own in ((WORKED_OUT, True, False), (CONFIGURES, False, True), (PARAMETERS, False, True)):
        error = diagnosed(code, "", Severity.ERROR, NOWHERE)
        assert (found_by_manager(error), stops_controller(error)) == (manager, own)
    assert (stops_parameters(PARAMETERS), stops_parameters(CONFIGURES)) == (True, False)


def test_a_robot_or_hardware_that_is_rejected_is_no_fault_of_a_controller() -> None:
    for code in ("UC101", "UC301"):
        assert not stops_controller(diagnosed(code, "", Severity.ERROR, NOWHERE))
