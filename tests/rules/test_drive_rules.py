"""Speeds and frames of drives, compared with the robot."""

from __future__ import annotations

from pathlib import Path
from textwrap import indent

import pytest
import robots

from urdfctl.load.target import Target
from urdfctl.rules.examples import completed

WHEELS = """
    <ros2_control name="base" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="velocity"/><state_interface name="position"/></joint>
      <joint name="elbow"><command_interface name="velocity"/><state_interface name="position"/></joint>
    </ros2_control>
"""
DRIVE = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    drive: {type: diff_drive_controller/DiffDriveController}
drive:
  ros__parameters:
    left_wheel_names: [shoulder]
    right_wheel_names: [elbow]
    wheel_separation: 0.4
    wheel_radius: 0.1
"""


def found(folder: Path, more: str, code: str, distro: str = "kilted") -> list[str]:
    """Return the messages about the drive with more parameters; its joints may turn at 2 rad/s."""
    robot, controllers = folder / "robot.urdf", folder / "controllers.yaml"
    robot.write_text(completed("robot.urdf", WHEELS), encoding="utf-8")
    controllers.write_text(DRIVE + indent(more, "    ") + "\n", encoding="utf-8")
    target = Target(str(robot), controllers=(str(controllers),))
    return [finding.message for finding in robots.findings(target, (code,), distro=distro, workspace=str(folder))]


@pytest.mark.parametrize(
    ("limits", "told"),
    [
        ("linear.x.max_velocity: 0.2", ""),
        ("linear.x.max_velocity: 0.5", "at 0.5 m/s the wheels turn at 5 rad/s"),
        ("angular.z.max_velocity: 1.0", ""),
        ("angular.z.max_velocity: 2.0", "at 2 rad/s the wheels turn at 4 rad/s"),
        ("linear.x: {has_velocity_limits: false, max_velocity: 0.5}", ""),
        ("linear.x.max_velocity: .nan", ""),
    ],
)
def test_a_drive_may_not_ask_for_wheels_that_turn_faster_than_their_joints(
    tmp_path: Path, limits: str, told: str
) -> None:
    messages = found(tmp_path, limits, "UC474")
    assert [message.partition(",")[0] for message in messages] == ([told] if told else [])
    assert all("max_velocity' to 0.2," in one or "max_velocity' to 1," in one for one in messages)


def test_until_jazzy_ros2_does_not_limit_the_wheels(tmp_path: Path) -> None:
    assert found(tmp_path, "linear.x.max_velocity: 0.5", "UC474", "humble") == []


@pytest.mark.parametrize(
    ("frame", "told"),
    [("base_frame_id: base", 0), ("enable_odom_tf: false", 0), ("odom_frame_id: odom", 1)],
)
def test_the_default_base_frame_must_be_a_link_if_it_is_published(tmp_path: Path, frame: str, told: int) -> None:
    messages = found(tmp_path, frame, "UC445")
    assert len(messages) == told
    assert all(
        one.endswith("has no 'base_frame_id', and the robot has no link 'base_link' (its default)") for one in messages
    )


@pytest.mark.parametrize(("frame", "told"), [("one/base", 0), ("/one/base", 0), ("one/bse", 1), ("two/base", 1)])
def test_a_base_frame_may_have_a_namespace_or_be_a_link_with_a_slash(tmp_path: Path, frame: str, told: int) -> None:
    urdf = completed("robot.urdf", WHEELS).replace('"base"', '"one/base"')
    (tmp_path / "robot.urdf").write_text(urdf, encoding="utf-8")
    text = DRIVE + indent(f"base_frame_id: {frame}\n", "    ")
    (tmp_path / "controllers.yaml").write_text(text, encoding="utf-8")
    target = Target(str(tmp_path / "robot.urdf"), controllers=(str(tmp_path / "controllers.yaml"),))
    assert len(robots.findings(target, ("UC445",), distro="kilted", workspace=str(tmp_path))) == told
