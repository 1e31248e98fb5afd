"""Controllers that are configured and most likely not started: their errors are warnings that say so."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Rover
from smoking import smoked, target_of, verdicts, whole

from urdfctl.diagnostic import Severity
from urdfctl.smoke.results import RobotResult

OTHER = """
    other: {type: diff_drive_controller/DiffDriveController}
"""
SETTINGS_OF_OTHER = """
other:
  ros__parameters:
    left_wheel_names: [left_wheel]
    right_wheel_names: [right_wheel]
    wheel_separation: 0.9
    wheel_radius: 0.3
    base_frame_id: base_link
"""
LAUNCH = """
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" type="str" value="$(command 'cat $(dirname)/robot.urdf')"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node"><param from="$(dirname)/controllers.yaml"/></node>
  <node pkg="controller_manager" exec="spawner" args="states %s"/>
</launch>
"""


def two_drives(radius: float = 1.0) -> dict[str, str]:
    """A rover whose controller file also has a drive with the measures of another robot."""
    first = Rover().yaml(radius=radius)
    yaml = first.replace("\nbase:\n", f"{OTHER.rstrip()}\nbase:\n", 1) + SETTINGS_OF_OTHER
    return {"robot.urdf": Rover().urdf(), "controllers.yaml": yaml}


def misfits(result: RobotResult) -> set[tuple[str, Severity, bool]]:
    """The controllers whose measures differ, how severe that is, and whether a note says that they are not started."""
    return {
        (finding.message.split("'")[1], finding.severity, bool(finding.notes))
        for finding in result.linted.outcome.diagnostics
        if finding.code == "UC913"
    }


@pytest.mark.parametrize(
    ("spawned", "expected"),
    [
        ("base", {("other", Severity.WARNING, True)}),
        ("other", {("other", Severity.ERROR, False)}),
        ("base --inactive other", {("other", Severity.ERROR, False)}),
        ("$(env WHICH)", {("other", Severity.ERROR, False)}),
    ],
)
def test_a_controller_that_the_launch_file_neither_starts_nor_loads_gets_warnings(
    tmp_path: Path, spawned: str, expected: set[tuple[str, Severity, bool]]
) -> None:
    made = smoked(target_of(tmp_path, {**two_drives(), "a.launch.xml": LAUNCH % spawned}), distro="jazzy")
    assert misfits(made) == expected
    assert verdicts(made)["other"].startswith("failed" if (Severity.ERROR in {s for _, s, _ in expected}) else "warned")


def test_one_that_the_user_asks_for_is_tested_as_if_it_was_started(tmp_path: Path) -> None:
    target = target_of(tmp_path, {**two_drives(), "a.launch.xml": LAUNCH % "base"})
    assert misfits(smoked(target, only=("other",), distro="jazzy")) == {("other", Severity.ERROR, False)}


def test_without_a_launch_file_the_drive_that_fits_is_taken_for_the_one_that_is_started(tmp_path: Path) -> None:
    made = smoked(target_of(tmp_path, two_drives()), distro="jazzy")
    assert misfits(made) == {("other", Severity.WARNING, True)}
    made = smoked(target_of(tmp_path, two_drives(radius=2.0)), distro="jazzy")
    assert misfits(made) == {("base", Severity.ERROR, False), ("other", Severity.ERROR, False)}


def test_what_follows_from_wrong_measures_is_not_reported_too(tmp_path: Path) -> None:
    files = {"robot.urdf": Rover().urdf(), "controllers.yaml": Rover().yaml(radius=2.0)}
    made = whole(target_of(tmp_path, files), distro="jazzy")
    assert {finding.code for finding in made.linted.outcome.diagnostics} == {"UC913"}
    assert verdicts(made)["base"] == "failed move"
