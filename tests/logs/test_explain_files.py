"""`urdfctl explain LOG --in FOLDER` puts first what is really the case in the files."""

from __future__ import annotations

import json

import pytest
from folder import Folder
from typer.testing import CliRunner, Result

from urdfctl.commands.app import app
from urdfctl.errors import UserError

LOG = """\
[ERROR] [1623.4]: Could not find resource 'elbow' in 'hardware_interface::EffortJointInterface'.
[ERROR] [1623.5]: Failed to load elbow_controller
"""
ROBOT = """\
<robot name="arm">
  <link name="base"/>
  <link name="fore"/>
  <joint name="elbow" type="continuous"><parent link="base"/><child link="fore"/></joint>
  <transmission name="t">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
    <actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator>
  </transmission>
  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
</robot>
"""
LAUNCH = """\
<launch>
  <param name="robot_description" textfile="$(dirname)/robot.urdf"/>
  <rosparam command="load" file="$(dirname)/controllers.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="elbow_controller"/>
</launch>
"""
CONTROLLERS = "elbow_controller:\n  type: effort_controllers/JointEffortController\n  joint: elbow\n"


def command(*words: str, given: str = LOG) -> Result:
    return CliRunner().invoke(app, ["explain", *words], input=given, catch_exceptions=False)


@pytest.fixture
def robot(folder: Folder) -> Folder:
    folder.write(
        {"arm/robot.urdf": ROBOT, "arm/controllers.yaml": CONTROLLERS, "arm/up.launch": LAUNCH, "gazebo.log": LOG}
    )
    return folder


def test_the_cause_that_a_rule_finds_comes_first_with_its_line(robot: Folder) -> None:
    text = command("gazebo.log", "--in", "arm").stdout
    assert "Causes, those in your files first:\n    1. the transmission of 'elbow' names a different interface" in text
    assert "found: arm/controllers.yaml:2:9: controller 'elbow_controller' requires 'elbow'" in text
    assert "urdfctl explain UC461" in text


def test_a_pasted_line_can_be_checked_too(robot: Folder) -> None:
    assert "found: arm/controllers.yaml:2:9" in command(*LOG.splitlines()[0].split(), "--in", "arm").stdout


def test_json_names_the_places_and_the_folder(robot: Folder) -> None:
    log = json.loads(command("-", "--in", "arm", "--format", "json").stdout)
    first = log["messages"][0]["causes"][0]
    assert log["folder"]["folder"] == "arm"
    assert [(found["file"], found["line"], found["code"]) for found in first["found"]] == [
        ("arm/controllers.yaml", 2, "UC461")
    ]


def test_files_without_the_fault_leave_the_causes_in_their_order(robot: Folder) -> None:
    robot.write({"arm/robot.urdf": ROBOT.replace("Position", "Effort")})
    text = command("gazebo.log", "--in", "arm").stdout
    assert "Causes, most likely first:" in text
    assert "urdfctl lint arm" in text


def test_a_folder_without_a_robot_is_the_user_s_error(robot: Folder) -> None:
    robot.write({"empty/readme.txt": "hello"})
    with pytest.raises(UserError, match="nothing to lint in empty"):
        command("gazebo.log", "--in", "empty")


def test_a_rule_is_not_explained_in_a_folder(robot: Folder) -> None:
    with pytest.raises(UserError, match="--in is for messages and logs"):
        command("UC201", "--in", "arm")


def test_the_distro_of_the_files_can_be_named(robot: Folder) -> None:
    prefixed = LOG.splitlines()[0].replace(
        "Could not find resource 'elbow' in 'hardware_interface::EffortJointInterface'.",
        "No matching hardware interface found for 'hardware_interface/PositionJointInterface'",
    )
    assert "found:" not in command("-", "--in", "arm", "--distro", "noetic", given=prefixed).stdout
    assert "(UC226)" in command("-", "--in", "arm", "--distro", "indigo", given=prefixed).stdout


HUMBLE = {
    "arm/robot.urdf": """<robot name="arm">
  <link name="base"/>
  <link name="fore"/>
  <joint name="elbow" type="continuous"><parent link="base"/><child link="fore"/></joint>
  <ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="elbow">
      <command_interface name="position"/>
      <state_interface name="position"/>
    </joint>
  </ros2_control>
</robot>
""",
    "arm/controllers.yaml": """controller_manager:
  ros__parameters:
    update_rate: 100
    elbow_controller:
      type: forward_command_controller/ForwardCommandController
elbow_controller:
  ros__parameters:
    joints: [elbow]
    interface_name: effort
""",
}
NOT_AVAILABLE = (
    "Unable to activate controller 'elbow_controller' since the command interface 'elbow/effort' is not available."
)


def test_a_cause_names_the_other_places_that_belong_to_it_and_the_repair(folder: Folder) -> None:
    folder.write(HUMBLE)
    text = command(NOT_AVAILABLE, "--in", "arm", "--distro", "jazzy").stdout
    assert "found: arm/controllers.yaml:8:14: 'elbow' has no 'effort' command" in text
    assert "see: arm/robot.urdf:8:7: interfaces of 'elbow' are defined here" in text
    answer = json.loads(command(NOT_AVAILABLE, "--in", "arm", "--distro", "jazzy", "--format", "json").stdout)
    [found] = [one for cause in answer["messages"][0]["causes"] for one in cause["found"]]
    assert found["related"][0] == {
        "file": "arm/robot.urdf",
        "line": 8,
        "column": 7,
        "message": "interfaces of 'elbow' are defined here",
    }


def test_a_repair_that_is_likely_only_is_offered_as_a_diff(robot: Folder) -> None:
    drive = "elbow_controller:\n  type: diff_drive_controller/DiffDriveController\n  wheel_seperation: 0.4\n"
    robot.write({"arm/controllers.yaml": f"{drive}  left_wheel: elbow\n  right_wheel: elbow\n"})
    text = command("Could not load controller 'elbow_controller' because controller type", "--in", "arm").stdout
    assert "  urdfctl lint arm --unsafe-fixes --diff --select UC461,UC430  shows what most likely" in text
    assert " --fix " not in text


def test_a_cause_says_how_its_rule_repairs_it(robot: Folder) -> None:
    without = ROBOT.replace("<hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>", "")
    robot.write({"arm/robot.urdf": without})
    text = " ".join(command("gazebo.log", "--in", "arm").stdout.split())
    assert "fix: add <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>, which" in text
