"""Packages for nine kinds of robots, in four distros with their simulators, for each kind of command: all of them lint
without a warning and pass the smoke test, or are refused in one line."""

from __future__ import annotations

import re
import shutil
from itertools import product

import pytest
from folder import Folder
from generated_robots import ROBOTS
from generating import command
from sampling import WHOLE, sample
from smoking_engines import needs_pybullet

DISTROS = {
    "noetic": ("none", "gazebo-classic"),
    "humble": ("none", "gz", "gazebo-classic", "mujoco"),
    "jazzy": ("none", "gz", "mujoco"),
    "rolling": ("none", "gz", "mujoco"),
}
KINDS = ("proposed", "position", "velocity", "effort", "trajectory")
REFUSALS = {
    ("sensors", "noetic", "proposed"): "the robot has no joint to control",
    ("mecanum", "noetic", "proposed"): "noetic has no controller for mecanum bases; use --controller NAME=TYPE",
    **{("sensors", "*", kind): "the robot has no joint to control" for kind in KINDS[1:]},
}


SENSORS = """<ros2_control name="io" type="{kind}"><hardware><plugin>{plugin}</plugin></hardware>
  <sensor name="imu_sensor"><state_interface name="orientation.x"/><state_interface name="orientation.y"/>
    <state_interface name="orientation.z"/><state_interface name="orientation.w"/>
    <state_interface name="angular_velocity.x"/><state_interface name="angular_velocity.y"/>
    <state_interface name="angular_velocity.z"/><state_interface name="linear_acceleration.x"/>
    <state_interface name="linear_acceleration.y"/><state_interface name="linear_acceleration.z"/></sensor>
  </ros2_control><gazebo reference="imu_link"><sensor name="imu_sensor" type="imu"/></gazebo>"""


CASES = [
    (robot, distro, simulator, kind)
    for (robot, distro), kind in product(product(ROBOTS, DISTROS), KINDS)
    for simulator in DISTROS[distro]
]
PLUGINS = {
    "gz": "gz_ros2_control/GazeboSimSystem",
    "gazebo-classic": "gazebo_ros2_control/GazeboSystem",
    "mujoco": "mujoco_ros2_control/MujocoSystemInterface",
}


def described(robot: str, distro: str, simulator: str) -> str:
    """The robot; sensors are in a `<ros2_control>` of its own, because generators only extend one by joints."""
    sensors = ""
    if robot == "sensors" and distro != "noetic":
        sensors = SENSORS.format(kind="system", plugin=PLUGINS.get(simulator, "mock_components/GenericSystem"))
    return f'<robot name="r">{ROBOTS[robot]}{sensors}</robot>'


def refusal(robot: str, distro: str, kind: str) -> str | None:
    """How a combination is refused; None if it is possible."""
    return REFUSALS.get((robot, distro, kind)) or REFUSALS.get((robot, "*", kind))


def fault(case: tuple[str, str, str, str], folder: Folder) -> str:
    """What is wrong with the package that is generated for a combination; empty if nothing is."""
    robot, distro, simulator, kind = case
    shutil.rmtree(folder.path / "made", ignore_errors=True)
    folder.write({"r.urdf": described(robot, distro, simulator)})
    words = ["r.urdf", "--distro", distro, "--simulator", simulator, "-o", "made"]
    ran = command("gen-all", *words, *(() if kind == "proposed" else ("--type", kind)))
    expected = refusal(robot, distro, kind)
    if expected:
        return "" if ran.returncode == 2 and expected in ran.stderr and ran.stderr.count("\n") == 1 else ran.stderr
    if ran.returncode:
        return ran.stderr
    lint = command("lint", "made", "--format", "concise", "--fail-on", "warning")
    if lint.returncode:
        return lint.stdout
    smoke = command("smoke", "made", "--engine", "auto" if WHOLE else "none")
    return "" if smoke.returncode == 0 else re.sub(r"(?m)^.* passed .*\n", "", smoke.stdout)


@pytest.mark.parametrize("robot", ROBOTS)
def test_every_combination_lints_and_smokes_clean_or_is_refused(robot: str, folder: Folder) -> None:
    cases = [case for case in CASES if case[0] == robot]
    every = sample(range(len(cases)), 31)
    faults = {cases[index]: found for index in every if (found := fault(cases[index], folder))}
    assert faults == {}


@needs_pybullet
def test_a_car_of_ros1_drives_and_turns(folder: Folder) -> None:
    folder.write({"r.urdf": described("ackermann", "noetic", "gazebo-classic")})
    assert command("gen-all", "r.urdf", "--distro", "noetic", "-o", "made").returncode == 0
    assert "tested: started, drove, turned" in command("smoke", "made", "--engine", "pybullet").stdout
