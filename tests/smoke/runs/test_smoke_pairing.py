"""Launch files that spawn controllers and load no robot are tested with the only robot that has their joints."""

from __future__ import annotations

from pathlib import Path

from folder import Folder
from smoke_robots import ARMS
from smoking import smoked_in_workers, verdicts

from urdfctl.config.settings import Settings
from urdfctl.load.target import Target
from urdfctl.smoke.reports import conditions
from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.run import SmokeRequest

ARM = ARMS["joints that turn level"]
NOETIC = Settings(distro="noetic")
TRANSMISSION = """
<transmission name="elbow_trans">
  <type>transmission_interface/SimpleTransmission</type>
  <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
  <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
</transmission>
</robot>
"""
CONTROLLERS = "mover: {type: effort_controllers/JointEffortController, joint: elbow}\n"
LAUNCH = """\
<launch>
  <rosparam file="$(dirname)/controllers.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="mover"/>
</launch>
"""


def results(folder: Path, robots: dict[str, str]) -> list[RobotResult]:
    """The tests of some robots, and of a launch file for a controller of the joint elbow."""
    Folder(folder).write({**robots, "controllers.yaml": CONTROLLERS, "control.launch": LAUNCH})
    targets = [Target(str(folder / name)) for name in (*robots, "control.launch")]
    return list(smoked_in_workers(targets, [NOETIC] * len(targets), SmokeRequest(), 1))


def arm(elbow: str = "elbow") -> str:
    urdf = ARM.urdf()
    return (urdf[: urdf.rindex("</robot>")] + TRANSMISSION).replace('"elbow"', f'"{elbow}"')


def test_a_launch_file_without_a_robot_gets_the_only_one_with_its_joints(tmp_path: Path) -> None:
    *_, launched = results(tmp_path, {"arm.urdf": arm(), "other.urdf": arm("wrist")})
    assert (launched.linted.path, launched.linted.launch) == (
        str(tmp_path / "arm.urdf"),
        str(tmp_path / "control.launch"),
    )
    assert "paired by its joints: the launch file loads no robot" in conditions(launched)
    [result] = launched.controllers
    assert result.type == "effort_controllers/JointEffortController"
    assert verdicts(launched) == {"mover": "skipped activate"}


def test_of_several_robots_with_the_joints_none_is_chosen(tmp_path: Path) -> None:
    *_, launched = results(tmp_path, {"arm.urdf": arm(), "second.urdf": arm()})
    assert launched.linted.links is None
    assert not launched.paired


def test_a_robot_without_the_joints_is_not_chosen(tmp_path: Path) -> None:
    *_, launched = results(tmp_path, {"arm.urdf": arm("wrist")})
    assert launched.linted.links is None
