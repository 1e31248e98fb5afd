"""Limits of 0 in the URDF: an error where the simulator or the controller manager applies them to each command."""

from __future__ import annotations

from pathlib import Path

import pytest
import robots

from urdfctl.load.target import Target

_MASS = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
_ARM = (
    f'<robot name="arm"><link name="world"/><link name="tool">{_MASS}</link><joint name="wrist" type="revolute">'
    '<parent link="world"/><child link="tool"/><limit lower="%s" upper="1" %s/></joint>%s</robot>'
)
_COMMANDED = (
    '<ros2_control name="arm" type="system"><hardware><plugin>%s</plugin></hardware>'
    '<joint name="wrist"><command_interface name="%s"/><state_interface name="position"/></joint></ros2_control>'
)
_TRANSMISSION = (
    '<transmission name="drive"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="wrist"><hardwareInterface>hardware_interface/%s</hardwareInterface></joint>'
    '<actuator name="motor"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>'
    '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>'
)
_GZ, _CLASSIC, _MOCK = (
    "gz_ros2_control/GazeboSimSystem",
    "gazebo_ros2_control/GazeboSystem",
    "mock_components/GenericSystem",
)


@pytest.mark.parametrize(
    ("limit", "hardware", "command", "distro", "expected"),
    [
        ('effort="0" velocity="1"', _GZ, "position", "jazzy", "UC161 error"),
        ('effort="1" velocity="0"', _GZ, "velocity", "jazzy", "UC131 error"),
        ('effort="1" velocity="0"', _CLASSIC, "position", "humble", "UC131 warning"),
        ('effort="0" velocity="1"', _CLASSIC, "position", "humble", None),
        ('effort="0" velocity="1"', _CLASSIC, "effort", "humble", "UC161 error"),
        ('effort="1" velocity="0"', _MOCK, "position", "kilted", "UC131 error"),
        ('effort="1" velocity="0"', _MOCK, "position", "jazzy", "UC131 warning"),
        ('effort="0" velocity="1"', _MOCK, "position", "kilted", None),
        ('effort="0" velocity="1"', _MOCK, "effort", "kilted", "UC161 error"),
        ('effort="0" velocity="1"', _MOCK, 'effort"/><command_interface name="position', "kilted", None),
        ('effort="0" velocity="1"', _GZ, 'effort"/><command_interface name="position', "jazzy", "UC161 error"),
        ('effort="1" velocity="0"', _GZ, 'velocity"/><command_interface name="effort', "jazzy", "UC131 warning"),
    ],
)
def test_a_limit_of_zero_is_an_error_where_the_runtime_applies_it_to_the_command(
    tmp_path: Path, limit: str, hardware: str, command: str, distro: str, expected: str | None
) -> None:
    found = _found(tmp_path, _ARM % ("-1", limit, _COMMANDED % (hardware, command)), distro=distro)
    assert found == ([expected] if expected else [])


@pytest.mark.parametrize(
    ("limit", "interface", "expected"),
    [
        ('effort="1" velocity="0"', "PositionJointInterface", "UC131 error"),
        ('effort="1" velocity="0"', "EffortJointInterface", "UC131 warning"),
        ('effort="0" velocity="1"', "VelocityJointInterface", "UC161 error"),
        ('effort="0" velocity="1"', "PositionJointInterface", None),
    ],
)
def test_gazebo_of_ros_1_never_moves_a_joint_whose_command_it_limits_to_zero(
    tmp_path: Path, limit: str, interface: str, expected: str | None
) -> None:
    kind = interface.removesuffix("JointInterface").lower()
    controller = f"wrist_controller: {{type: {kind}_controllers/JointGroup{kind.title()}Controller, joints: [wrist]}}\n"
    (tmp_path / "controllers.yaml").write_text(controller, encoding="utf-8")
    found = _found(tmp_path, _ARM % ("-1", limit, _TRANSMISSION % interface), distro="noetic")
    assert found == ([expected] if expected else [])


def test_a_joint_without_range_is_an_error_where_the_simulator_keeps_it_in_place(tmp_path: Path) -> None:
    in_gz = _ARM % ("1", 'effort="1" velocity="1"', _COMMANDED % (_GZ, "position"))
    mocked = _ARM % ("1", 'effort="1" velocity="1"', _COMMANDED % (_MOCK, "position"))
    assert _found(tmp_path, in_gz, distro="jazzy") == ["UC132 error"]
    assert _found(tmp_path, mocked, distro="jazzy") == ["UC132 warning"]


def test_gazebo_of_ros_1_takes_each_position_of_reversed_limits_for_the_upper_one(tmp_path: Path) -> None:
    controller = "wrist_controller: {type: position_controllers/JointGroupPositionController, joints: [wrist]}\n"
    (tmp_path / "controllers.yaml").write_text(controller, encoding="utf-8")
    reversed_limits = _ARM % ("2", 'effort="1" velocity="1"', _TRANSMISSION % "PositionJointInterface")
    assert _found(tmp_path, reversed_limits, distro="noetic") == ["UC125 error"]
    assert _found(tmp_path, reversed_limits.replace("Position", "Velocity"), distro="noetic") == ["UC125 warning"]


def _found(folder: Path, text: str, **options: str) -> list[str]:
    """Return code and severity of the findings on limits in a robot."""
    path = folder / "robot.urdf"
    path.write_text(text, encoding="utf-8")
    target = Target(str(path), controllers=tuple(map(str, folder.glob("*.yaml"))))
    found = robots.findings(target, ("UC125", "UC131", "UC132", "UC161"), workspace=str(folder), **options)
    return [f"{each.code} {each.severity.value}" for each in found]
