"""Which controllers an error stops: those of its manager, of its file or of its launch, and the cause that is named."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoking import smoked, target_of, verdicts

from urdfctl.rules.smoke.common import HARDWARE
from urdfctl.smoke.results import RobotResult

FORWARD = "forward_command_controller/ForwardCommandController"
PARAMETERS = "joints: [elbow], interface_name: position"


def manager(rate: str, indent: str = "", *names: str) -> str:
    declared = "".join(f"    {name}: {{type: {FORWARD}}}\n" for name in names)
    sections = "".join(f"{name}:\n  ros__parameters: {{{PARAMETERS}}}\n" for name in names)
    text = f"controller_manager:\n  ros__parameters:\n    update_rate: {rate}\n{declared}{sections}"
    return "".join(f"{indent}{line}\n" for line in text.splitlines())


def in_jazzy(folder: Path, yaml: str, robot: str = HARDWARE) -> RobotResult:
    return smoked(target_of(folder, {"robot.urdf": robot, "controllers.yaml": yaml}), distro="jazzy")


def test_a_wrong_rate_of_the_manager_stops_all_its_controllers(tmp_path: Path) -> None:
    assert set(verdicts(in_jazzy(tmp_path, manager("100", "", "arm", "hand"))).values()) == {"skipped activate"}
    made = in_jazzy(tmp_path, manager("fast", "", "arm", "hand"))
    assert verdicts(made) == {"arm": "failed load", "hand": "failed load"}
    [finding] = made.linted.outcome.diagnostics
    assert finding.notes[-1].message == "it also stops controller 'hand'"


def test_a_wrong_rate_stops_only_the_controllers_of_its_namespace(tmp_path: Path) -> None:
    yaml = "left:\n" + manager("fast", "  ", "arm", "hand") + "right:\n" + manager("100", "  ", "arm")
    made = verdicts(in_jazzy(tmp_path, yaml))
    assert made == {"/left/arm": "failed load", "hand": "failed load", "/right/arm": "skipped activate"}


ELBOW = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
"""
EFFORT = "{type: effort_controllers/JointEffortController, joint: elbow}"
BROKEN = "{type: effort_controllers/JointEffortController, joint: elbow, gain: }"


@pytest.mark.parametrize(
    ("launched", "expected"),
    [
        (True, {"arm": "failed load", "hand": "failed load"}),
        (False, {"arm": "failed load", "hand": "skipped activate"}),
    ],
)
def test_a_file_that_roslaunch_cannot_load_stops_all_that_it_starts(
    launched: bool, expected: dict[str, str], tmp_path: Path
) -> None:
    launch = """
        <launch>
          <param name="robot_description" textfile="$(dirname)/robot.urdf"/>
          <rosparam file="$(dirname)/arm.yaml" command="load"/>
          <rosparam file="$(dirname)/hand.yaml" command="load"/>
        </launch>
    """
    parts = {"robot.urdf": ELBOW, "arm.yaml": f"arm: {BROKEN}\n", "hand.yaml": f"hand: {EFFORT}\n"}
    target = target_of(tmp_path, {**parts, "robot.launch": launch} if launched else parts)
    made = smoked(target, distro="noetic", simulator="gazebo-classic")
    assert verdicts(made) == expected


# -- the cause that is named -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("others", "note"),
    [
        (1, []),
        (2, ["lint reports 1 more error of this kind"]),
        (3, ["lint reports 2 more errors of this kind"]),
    ],
)
def test_more_errors_of_a_robot_are_counted(others: int, note: list[str], tmp_path: Path) -> None:
    ends = '<parent link="base"/><child link="nowhere{n}"/>'
    loose = "".join(f'<joint name="j{n}" type="fixed">{ends.format(n=n)}</joint>' for n in range(others))
    made = in_jazzy(tmp_path, manager("100", "", "arm"), HARDWARE + loose)
    [finding] = [one for one in made.linted.outcome.diagnostics if one.code == "UC901"]
    assert [remark.message for remark in finding.notes][1:] == note


def test_a_type_that_does_not_exist_is_the_cause_before_other_errors(tmp_path: Path) -> None:
    yaml = manager("100", "", "arm").replace(FORWARD, "forward_command_controller/FowardCommandController")
    both = yaml.replace("joints: [elbow]", "joints: [elbow, elbow]")
    for text in (yaml, both):
        [finding] = in_jazzy(tmp_path, text).linted.outcome.diagnostics
        assert finding.code == "UC903"
        assert "FowardCommandController" in finding.message


TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"


@pytest.mark.parametrize(
    ("type_name", "parameters", "kind"),
    [
        (TRAJECTORY, "command_interfaces: [position], state_interfaces: [position, velocity]", "state"),
        (FORWARD, "interface_name: velocity", "command"),
    ],
)
def test_an_interface_that_no_hardware_offers_is_named_with_its_kind(
    type_name: str, parameters: str, kind: str, tmp_path: Path
) -> None:
    """The hardware has positions only."""
    yaml = manager("100", "", "arm").replace("interface_name: position", parameters).replace(FORWARD, type_name)
    [result] = in_jazzy(tmp_path, yaml).controllers
    assert result.reason == f"no hardware offers the {kind} interface 'elbow/velocity'"


# -- links that Gazebo drops ----------------------------------------------------------------------------------------

IN_GAZEBO = HARDWARE.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
TOOL = """
    <link name="tool"/>
    <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
"""
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
OF_THE_WRIST = """
    <ros2_control name="hand" type="system">
      <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
      <joint name="wrist"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""


def test_a_link_that_gazebo_drops_stops_only_the_controllers_of_the_joints_that_go_with_it(tmp_path: Path) -> None:
    yaml = manager("100", "", "arm", "hand") + "hand:\n  ros__parameters: {joints: [wrist], interface_name: position}\n"
    yaml = yaml.replace(f"hand:\n  ros__parameters: {{{PARAMETERS}}}\n", "")
    made = in_jazzy(tmp_path, yaml, IN_GAZEBO + OF_THE_WRIST + TOOL)
    assert verdicts(made) == {"arm": "skipped activate", "hand": "failed activate"}
    [finding] = [one for one in made.linted.outcome.diagnostics if one.code == "UC905"]
    assert "link 'tool' of joint 'wrist' has no <inertial>" in finding.message


def test_a_robot_of_which_gazebo_drops_all_moving_joints_is_not_spawned(tmp_path: Path) -> None:
    robot = f'<robot name="loose"><link name="fore">{MASS}</link>{TOOL}{OF_THE_WRIST}</robot>'
    made = in_jazzy(tmp_path, manager("100", "", "arm").replace("elbow", "wrist"), robot)
    assert verdicts(made) == {"arm": "failed load"}


TRANSMISSION_OF_THE_WRIST = ELBOW.replace("elbow", "wrist")
GAZEBO_OF_ROS1 = """
    <launch>
      <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
      <param name="robot_description" textfile="$(dirname)/robot.urdf"/>
      <rosparam file="$(dirname)/arm.yaml" command="load"/>
      <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
      <node name="spawner" pkg="controller_manager" type="spawner" args="arm"/>
    </launch>
"""
PLUGIN = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so">%s</plugin></gazebo>'


@pytest.mark.parametrize(
    ("more", "expected"), [("", {"arm": "skipped activate"}), (TRANSMISSION_OF_THE_WRIST, {"arm": "failed activate"})]
)
def test_gazebo_of_ros_1_starts_no_controller_if_a_transmission_has_a_joint_that_it_drops(
    more: str, expected: dict[str, str], tmp_path: Path
) -> None:
    parts = {
        "robot.urdf": ELBOW + more + TOOL + PLUGIN % "",
        "arm.yaml": f"arm: {EFFORT}\n",
        "robot.launch": GAZEBO_OF_ROS1,
    }
    assert verdicts(smoked(target_of(tmp_path, parts), distro="noetic")) == expected


@pytest.mark.parametrize(
    ("plugin", "why"),
    [
        (PLUGIN % "", ""),
        ("", "no <plugin> of the robot runs ros_control"),
        (PLUGIN % "<robotNamespace>/left</robotNamespace>", "spawner asks in namespace '/'"),
    ],
)
def test_controllers_that_reach_no_manager_do_not_pass(plugin: str, why: str, tmp_path: Path) -> None:
    parts = {"robot.urdf": ELBOW + plugin, "arm.yaml": f"arm: {EFFORT}\n", "robot.launch": GAZEBO_OF_ROS1}
    made = smoked(target_of(tmp_path, parts), distro="noetic")
    assert verdicts(made) == {"arm": "failed load" if why else "skipped activate"}
    assert why in (made.controllers[0].reason or "")


ONLY_SHOWN = """
    <launch>
      <param name="robot_description" textfile="$(dirname)/robot.urdf"/>
      <rosparam file="$(dirname)/arm.yaml" command="load"/>
      <node name="planner" pkg="arm_planner" type="plan"/>
    </launch>
"""


@pytest.mark.parametrize(("launch", "verdict"), [(GAZEBO_OF_ROS1, "failed"), (ONLY_SHOWN, "skipped")])
def test_a_driver_may_offer_what_transmissions_for_gazebo_do_not(launch: str, verdict: str, tmp_path: Path) -> None:
    position = EFFORT.replace("effort_controllers/JointEffort", "position_controllers/JointPosition")
    parts = {"robot.urdf": ELBOW + PLUGIN % "", "arm.yaml": f"arm: {position}\n", "robot.launch": launch}
    made = smoked(target_of(tmp_path, parts), distro="noetic")
    assert [each.verdict.value for each in made.controllers] == [verdict]
