"""Rules on controller files beyond their examples: by distro, and on values close to a fault."""

from __future__ import annotations

from pathlib import Path

import pytest
import robots

from urdfctl.diagnostic import Diagnostic
from urdfctl.load.target import Target

ARM = """\
<robot name="arm">
  <link name="base"/>
  <link name="upper"/>
  <link name="fore"/>
  <link name="tool"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="elbow" type="revolute">
    <parent link="upper"/><child link="fore"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="mount" type="fixed"><parent link="fore"/><child link="tool"/></joint>
  <ros2_control name="hardware" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
MANAGER = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm: {type: %s}
"""
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
FORWARD = "forward_command_controller/ForwardCommandController"
RIGHT = """\
arm:
  ros__parameters:
    joints: [shoulder, elbow]
    command_interfaces: [position]
    state_interfaces: [position]
"""
FORWARDS = "arm:\n  ros__parameters:\n    joints: [%s]\n    interface_name: position\n"


def findings(
    folder: Path, text: str, distro: str | None = "jazzy", robot: str = "", start: tuple[str, ...] | None = None
) -> list[Diagnostic]:
    """Return the findings of UC40 to UC44 in a controller file, alone or beside a robot."""
    file = folder / "controllers.yaml"
    file.write_text(text, encoding="utf-8")
    target = Target(str(file))
    if robot:
        (folder / "robot.urdf").write_text(robot, encoding="utf-8")
        target = Target(str(folder / "robot.urdf"), controllers=(str(file),))
    found = robots.findings(target, distro=distro, workspace=str(folder), started=start)
    return [finding for finding in found if finding.code.startswith(("UC40", "UC41", "UC42", "UC43", "UC44"))]


def told(found: list[Diagnostic]) -> list[str]:
    return [f"{finding.code} {finding.severity.value} {finding.at.line}" for finding in found]


# -- shape -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("slip", ["ros_parameters", "ros__parameter", "rosparams", "ROS__PARAMETERS", "parameters"])
def test_a_misspelt_ros_parameters_is_told_once_and_mended(tmp_path: Path, slip: str) -> None:
    text = (MANAGER % FORWARD).replace("ros__parameters", slip) + FORWARDS % "shoulder"
    found = findings(tmp_path, text)
    if slip == "ros__parameter":  # rcl compares no more than the letters of ros__parameters, which are not all there
        assert told(found)[0] == "UC403 error 2"
    [finding] = [finding for finding in found if finding.code == "UC403"]
    assert finding.fix is not None
    assert finding.fix.safe
    assert finding.fix.edits[0].text == "ros__parameters"


def test_a_controllers_section_without_ros_parameters_is_told_at_its_name(tmp_path: Path) -> None:
    found = findings(tmp_path, MANAGER % FORWARD + "arm:\n  joints: [shoulder]\n  interface_name: position\n")
    assert told(found) == ["UC403 error 5"]


def test_files_of_other_programs_beside_a_robot_are_let_be(tmp_path: Path) -> None:
    of_moveit = "joint_limits: &limits\n  elbow: {max_velocity: 1}\nothers: *limits\nempty: []\nnone:\n"
    assert findings(tmp_path, of_moveit, robot=ARM) == []


def test_a_file_of_ros_1_beside_a_robot_of_ros_2_is_told_once(tmp_path: Path) -> None:
    text = "arm:\n  type: position_controllers/JointGroupPositionController\n  joints: [shoulder]\n"
    assert told(findings(tmp_path, text, robot=ARM)) == ["UC401 error 1"]
    assert told(findings(tmp_path, text)) == ["UC401 warning 1"]  # alone it may be left over


def test_a_list_of_one_map_is_that_map(tmp_path: Path) -> None:
    text = MANAGER % "gpio_controllers/GpioCommandController" + (
        "arm:\n  ros__parameters:\n    gpios: [io]\n    command_interfaces:\n      io:\n        - interfaces: [out]\n"
    )
    assert findings(tmp_path, text) == []


def test_a_name_with_letters_that_no_node_can_have_is_told(tmp_path: Path) -> None:
    text = MANAGER.replace("arm", "arm-left") % "joint_state_broadcaster/JointStateBroadcaster"
    assert told(findings(tmp_path, text)) == ["UC428 error 4"]
    assert findings(tmp_path, text.replace("arm-left", "${name}_states")) == []


# -- types -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("slip", "right"),
    [
        ("joint_trajectory_controler/JointTrajectoryController", TRAJECTORY),
        ("joint_trajectory_controller/JointTrajectoryControler", TRAJECTORY),
        ("joint_trajectory_controller/jointtrajectorycontroller", TRAJECTORY),
        ("joint_trajectory_controller::JointTrajectoryController", TRAJECTORY),
        ("JointTrajectoryController", TRAJECTORY),
        ("joint_trajectory_controller", TRAJECTORY),
        ("joint_trajectory_controller/Trajectory", TRAJECTORY),
        ("position_controllers/JointGroupVelocityController", "velocity_controllers/JointGroupVelocityController"),
        ("gripper_controllers/GripperActionController", "GripperActionController"),
        (
            "position_controllers/ScaledJointTrajectoryController",
            "use 'ur_controllers/ScaledJointTrajectoryController'",
        ),
    ],
)
def test_a_misspelt_type_is_recognised(tmp_path: Path, slip: str, right: str) -> None:
    [finding] = [
        finding for finding in findings(tmp_path, MANAGER % slip + RIGHT) if finding.code in ("UC421", "UC423")
    ]
    assert finding.severity.value == "error"
    assert right in finding.message


@pytest.mark.parametrize(
    ("wrong", "sure"),
    [
        ("joint_trajectory_controller/Trajectory", True),
        ("joint_trajectory_controler/JointTrajectoryController", True),
        ("JointTrajectoryController", False),
        ("position_controllers/JointGroupVelocityController", False),
    ],
)
def test_the_only_type_of_the_package_that_is_named_is_surely_meant(tmp_path: Path, wrong: str, *, sure: bool) -> None:
    [fix] = [one.fix for one in findings(tmp_path, MANAGER % wrong + RIGHT) if one.code == "UC421"]
    assert fix is not None
    assert fix.safe is sure


@pytest.mark.parametrize(
    "own",
    [
        "our_controllers/JointTrajectoryController",
        "our_trajectory_controller/JointTrajectoryController",
        "arm_controllers/ArmController",
        "velocity_estimator/Estimator",
    ],
)
def test_a_type_of_an_own_package_is_no_more_than_worth_knowing(tmp_path: Path, own: str) -> None:
    assert told(findings(tmp_path, MANAGER % own + RIGHT)) == ["UC424 info 4"]


@pytest.mark.parametrize(
    ("distro", "expected"),
    [("foxy", []), ("humble", ["UC422 error 4"]), (None, ["UC422 warning 4"])],
)
def test_a_type_that_is_gone_is_an_error_where_it_is_gone(
    tmp_path: Path, distro: str | None, expected: list[str]
) -> None:
    assert told(findings(tmp_path, MANAGER % "joint_state_controller/JointStateController", distro)) == expected


@pytest.mark.parametrize(("distro", "expected"), [("kilted", []), ("rolling", ["UC422 error 4"]), (None, [])])
def test_a_type_that_coming_distros_drop_is_let_be_elsewhere(
    tmp_path: Path, distro: str | None, expected: list[str]
) -> None:
    text = MANAGER % "position_controllers/JointGroupPositionController" + "arm:\n  ros__parameters:\n    joints: [j]\n"
    assert told(findings(tmp_path, text, distro)) == expected


def test_a_started_controller_that_no_file_knows_has_no_type(tmp_path: Path) -> None:
    found = findings(tmp_path, MANAGER % TRAJECTORY + RIGHT, robot=ARM, start=("arm", "gripper"))
    assert told(found) == ["UC420 error 1"]
    assert "'gripper'" in found[0].message


# -- parameters --------------------------------------------------------------------------------------------------------


def test_an_integer_is_a_number_for_ros_1_and_foxy_alone(tmp_path: Path) -> None:
    text = MANAGER % TRAJECTORY + RIGHT + "    action_monitor_rate: 20\n"
    assert findings(tmp_path, text, "foxy") == []
    [finding] = findings(tmp_path, text, "humble")
    assert (finding.code, finding.severity.value) == ("UC432", "error")
    assert finding.fix is not None
    assert finding.fix.safe
    assert finding.fix.edits[0].text == "20.0"
    [unsure] = findings(tmp_path, text, None)
    assert unsure.severity.value == "warning"
    assert [note.message for note in unsure.notes] == ["applies to galactic and later"]


def test_a_number_that_yaml_takes_for_a_text_is_told_in_ros_1(tmp_path: Path) -> None:
    text = "states:\n  type: joint_state_controller/JointStateController\n  publish_rate: 1e3\n"
    assert told(findings(tmp_path, text, "noetic")) == ["UC432 error 3"]


def test_a_parameter_without_value_is_told_once(tmp_path: Path) -> None:
    text = "states:\n  type: joint_state_controller/JointStateController\n  publish_rate:\n"
    assert told(findings(tmp_path, text, "noetic")) == ["UC406 error 3"]


def test_what_ros_1_reads_for_itself_alone_is_a_warning(tmp_path: Path) -> None:
    text = (
        "arm:\n  type: position_controllers/JointTrajectoryController\n  joints: [a]\n"
        "  allow_partial_joints_goal: 1\n  our_own: 1\n  constraint: {goal_time: 1}\n"
    )
    assert told(findings(tmp_path, text, "noetic")) == ["UC432 warning 4", "UC430 warning 6"]


def test_a_misspelt_name_of_a_needed_parameter_is_one_error(tmp_path: Path) -> None:
    text = MANAGER % TRAJECTORY + RIGHT.replace("state_interfaces", "state_interface")
    found = findings(tmp_path, text)
    assert told(found) == ["UC444 error 9"]
    assert "'state_interfaces'" in found[0].message


def test_parameters_below_the_manager_are_one_error_where_they_are_needed(tmp_path: Path) -> None:
    text = (
        "controller_manager:\n  ros__parameters:\n    update_rate: 100\n    arm:\n      type: " + TRAJECTORY + "\n"
        "      joints: [shoulder]\n      command_interfaces: [position]\n      state_interfaces: [position]\n"
    )
    assert told(findings(tmp_path, text)) == ["UC415 error 6"]


def test_a_section_of_another_namespace_is_not_read(tmp_path: Path) -> None:
    text = MANAGER % TRAJECTORY + RIGHT.replace("arm:", "/robot/arm:")
    assert told(findings(tmp_path, text)) == ["UC416 error 5"]
    assert findings(tmp_path, text.replace("/robot/arm:", "/**/arm:")) == []
    assert findings(tmp_path, text.replace("/robot/arm:", "/arm:")) == []


def test_a_file_that_only_declares_controllers_leaves_their_parameters_to_another(tmp_path: Path) -> None:
    assert findings(tmp_path, MANAGER % TRAJECTORY) == []
    assert told(findings(tmp_path, MANAGER % TRAJECTORY, robot=ARM)) == ["UC431 error 4"]


def test_a_fork_of_a_controller_that_reads_other_parameters_is_told_less_of(tmp_path: Path) -> None:
    own = "".join(f"    own_{number}: {number}\n" for number in range(9))
    text = MANAGER % "mecanum_drive_controller/MecanumDriveController" + "arm:\n  ros__parameters:\n" + own
    assert told(findings(tmp_path, text)) == ["UC431 warning 5"]


def test_what_is_substituted_later_is_not_judged(tmp_path: Path) -> None:
    text = MANAGER % TRAJECTORY + RIGHT + "    action_monitor_rate: $(var rate)\n    interpolation_method: $(var how)\n"
    assert findings(tmp_path, text) == []


def test_controllers_that_are_not_started_are_no_errors(tmp_path: Path) -> None:
    text = MANAGER % TRAJECTORY + RIGHT.replace("[position]", "[postion]")
    assert told(findings(tmp_path, text, start=("arm",))) == ["UC433 error 8", "UC433 error 9"]
    assert told(findings(tmp_path, text, start=())) == ["UC433 warning 8", "UC433 warning 9"]


def test_the_parameters_that_every_node_has_are_known(tmp_path: Path) -> None:
    text = (
        MANAGER % TRAJECTORY
        + RIGHT
        + (
            "    use_sim_time: true\n    update_rate: 50\n    is_async: false\n    type: x/Y\n"
            "    qos_overrides: {/tf: {publisher: {depth: 5}}}\n    start_type_description_service: false\n"
        )
    )
    assert findings(tmp_path, text) == []


@pytest.mark.parametrize(
    ("distro", "expected"),
    [
        ("humble", []),
        ("jazzy", ["UC436 warning 10"]),
        (None, ["UC436 warning 10"]),
    ],
)
def test_a_removed_parameter_is_told_where_it_is_removed(
    tmp_path: Path, distro: str | None, expected: list[str]
) -> None:
    text = MANAGER % TRAJECTORY + RIGHT + "    state_publish_rate: 50.0\n"
    assert told(findings(tmp_path, text, distro)) == expected


def test_a_parameter_that_comes_later_says_since_when(tmp_path: Path) -> None:
    text = MANAGER % TRAJECTORY + RIGHT + "    interpolate_from_desired_state: true\n"
    [finding] = findings(tmp_path, text, "humble")
    assert finding.message == (
        "controller 'arm' does not read 'interpolate_from_desired_state' in humble, only in jazzy and later"
    )
    assert findings(tmp_path, text, None) == []


def test_one_fault_of_a_list_is_told_once(tmp_path: Path) -> None:
    wheels = "    left_wheel_names: %s\n    right_wheel_names: [r]\n    wheel_separation: 1.0\n    wheel_radius: 1.0\n"
    text = MANAGER % "diff_drive_controller/DiffDriveController" + "arm:\n  ros__parameters:\n" + wheels
    assert told(findings(tmp_path, text % "[]")) == ["UC407 error 7"]
    assert told(findings(tmp_path, text % "[1, 2]")) == ["UC432 error 7"]
    assert told(findings(tmp_path, text % "[1, l]")) == ["UC408 error 7"]
    assert told(findings(tmp_path, text % "[l, m]")) == ["UC434 error 8"]


# -- joints ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("joints", "start", "expected"),
    [
        ("shoulder, elbw", ("arm",), ["UC440 error 7"]),
        ("shoulder, elbw", None, ["UC440 error 7"]),
        ("shoulder, wrist", ("arm",), ["UC440 error 7"]),
        ("shoulder, wrist", None, ["UC440 error 7"]),
        ("wrist, finger", ("arm",), ["UC440 error 7"]),
        ("wrist, finger", None, ["UC440 error 7"]),
        ("sholder, elbw", ("arm",), ["UC440 error 7"]),
        ("sholder, elbw", None, ["UC440 error 7"]),
        ("shoulder, mount", None, ["UC441 error 7"]),
        ("shoulder, upper", ("arm",), ["UC440 error 7"]),
        ("shoulder, $(var prefix)elbow", ("arm",), []),
        ("other/shoulder", ("arm",), []),
    ],
)
def test_a_joint_that_is_none_of_the_robots_is_an_error_in_a_file_that_is_named_with_it(
    tmp_path: Path, joints: str, start: tuple[str, ...] | None, expected: list[str]
) -> None:
    assert told(findings(tmp_path, MANAGER % FORWARD + FORWARDS % joints, robot=ARM, start=start)) == expected


@pytest.mark.parametrize("other", ["joint_3", "joint_10"])
def test_another_joint_of_a_row_is_not_taken_for_a_slip(tmp_path: Path, other: str) -> None:
    robot = ARM.replace("shoulder", "joint_1").replace("elbow", "joint_2")
    [finding] = findings(tmp_path, MANAGER % FORWARD + FORWARDS % f"joint_1, {other}", robot=robot)
    assert "did you mean" not in finding.message


def test_a_link_that_is_named_for_its_joint_says_so(tmp_path: Path) -> None:
    [finding] = findings(tmp_path, MANAGER % FORWARD + FORWARDS % "elbow, upper", robot=ARM, start=("arm",))
    assert "did you mean 'shoulder'?" in finding.message
    assert finding.notes[0].message == "'upper' is a link; the joint that moves it is 'shoulder'"


def test_a_link_that_is_called_like_its_joint_is_surely_meant_for_it(tmp_path: Path) -> None:
    robot = ARM.replace('"elbow"', '"elbow_joint"').replace('"fore"', '"elbow"')
    [finding] = findings(tmp_path, MANAGER % FORWARD + FORWARDS % "shoulder, elbow", robot=robot, start=("arm",))
    assert finding.fix is not None
    assert (finding.fix.title, finding.fix.safe) == ("write 'elbow_joint'", True)


# -- extra joints of ROS 1 ---------------------------------------------------------------------------------------------

STATES = "states:\n  type: joint_state_controller/JointStateController\n  publish_rate: 50\n  extra_joints: %s\n"


@pytest.mark.parametrize(
    ("joint", "said"),
    [
        ("{name: caster, position: 0.0, velocity: 1.0e-3}", None),
        ("{name: caster, position: $(arg caster)}", None),
        ("{position: 0.0}", "extra joint has no name and is ignored; add one, e.g. 'name: caster_joint'"),
        (
            "{name: caster, position: 0.0, effort: off}",
            "effort of extra joint 'caster' must be a number with a decimal point; the joint is ignored",
        ),
    ],
)
def test_extra_joints_have_a_name_and_numbers_with_a_decimal_point(
    tmp_path: Path, joint: str, said: str | None
) -> None:
    found = findings(tmp_path, STATES % f"[{{name: wheel}}, {joint}]", "noetic")
    assert [finding.message for finding in found] == ([said] if said else [])


def test_a_whole_number_of_an_extra_joint_is_mended(tmp_path: Path) -> None:
    found = findings(tmp_path, STATES % "[{name: wheel, position: -1}]", "noetic")
    assert told(found) == ["UC442 warning 4"]
    assert found[0].fix is not None
    assert [edit.text for edit in found[0].fix.edits] == ["-1.0"]


# -- values that never arrive, or are not what they seem ---------------------------------------------------------------


def test_a_value_for_all_nodes_that_each_controller_overrides_has_no_effect(tmp_path: Path) -> None:
    shared = "/**:\n  ros__parameters:\n    joints: [nope]\n    use_sim_time: true\n"
    found = findings(tmp_path, MANAGER % FORWARD + shared + FORWARDS % "shoulder, elbow")
    assert told(found) == ["UC438 warning 7"]


def test_a_default_for_all_nodes_that_one_controller_needs_is_accepted(tmp_path: Path) -> None:
    manager = MANAGER % FORWARD + f"    hand: {{type: {FORWARD}}}\n"
    shared = "/**:\n  ros__parameters:\n    interface_name: position\n"
    own = "arm: {ros__parameters: {joints: [shoulder], interface_name: velocity}}\n"
    assert told(findings(tmp_path, manager + shared + own + "hand: {ros__parameters: {joints: [elbow]}}\n")) == []


def test_a_string_tag_makes_a_string_of_a_number(tmp_path: Path) -> None:
    text = (MANAGER % FORWARD).replace("update_rate: 100", "update_rate: !!str 100") + FORWARDS % "shoulder"
    assert told(findings(tmp_path, text)) == ["UC432 error 3"]


def test_a_params_file_of_another_type_is_ignored_by_the_manager(tmp_path: Path) -> None:
    text = (MANAGER % f"{FORWARD}, params_file: 5") + FORWARDS % "shoulder"
    assert told(findings(tmp_path, text)) == ["UC432 warning 4"]


@pytest.mark.parametrize(
    "kind", ["parallel_gripper_controller/GripperActionController", "gripper_controllers/GripperActionController"]
)
def test_a_type_named_after_its_ros_package_is_unknown(tmp_path: Path, kind: str) -> None:
    assert told(findings(tmp_path, MANAGER % kind))[0] == "UC421 error 4"


def test_an_unreadable_file_of_a_plugin_is_taken_for_the_file_of_the_same_name(tmp_path: Path) -> None:
    plugin = (
        '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
        "<parameters>%s</parameters></plugin></gazebo></robot>"
    )
    text = MANAGER % FORWARD + "arm: {ros__parameters: {joints: [shoulder]}}\n"
    beside = ARM.replace("</robot>", plugin % "/opt/ws/install/arm/share/arm/config/controllers.yaml")
    assert [finding.code for finding in findings(tmp_path, text, robot=beside)] == ["UC431"]
    other = ARM.replace("</robot>", plugin % "/opt/ws/install/arm/share/arm/config/more.yaml")
    assert findings(tmp_path, text, robot=other) == []


@pytest.mark.parametrize(("name", "severity"), [("elbw", "error"), ("tilt", "warning")])
def test_a_driver_may_export_other_joints_but_none_that_is_a_slip_of_its_own(
    tmp_path: Path, name: str, severity: str
) -> None:
    ends = '<parent link="a"/><child link="b"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
    robot = f"""<robot name="arm"><link name="a"/><link name="b"/><joint name="elbow" type="revolute">{ends}</joint>
      <ros2_control name="arm" type="system"><hardware><plugin>arm_driver/ArmHardware</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
      </ros2_control></robot>"""
    found = findings(tmp_path, MANAGER % FORWARD + FORWARDS % name, robot=robot, start=("arm",))
    assert [each.severity.value for each in found if each.code == "UC440"] == [severity]
