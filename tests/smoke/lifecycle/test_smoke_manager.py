"""How far each controller gets in the controller manager, and the words with which it is rejected."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from smoking import checked, smoked, target_of, verdicts

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, HARDWARE
from urdfctl.smoke.run import SmokeRequest
from urdfctl.smoke.statics.check import StaticCheck, check_statically

FORWARD = "forward_command_controller/ForwardCommandController"


def files(yaml: str, hardware: str = HARDWARE) -> dict[str, str]:
    return {"robot.urdf": hardware, "controllers.yaml": yaml}


def manager(**types: str) -> str:
    declared = "".join(f"    {name}: {{type: {kind}}}\n" for name, kind in types.items())
    return f"controller_manager:\n  ros__parameters:\n{declared}"


def section(name: str, parameters: str) -> str:
    return f"{name}:\n  ros__parameters: {{{parameters}}}\n"


ELBOW = "joints: [elbow], interface_name: position"
NOISE = "forward_command_controller/FowardCommandController"


def verdicts_and_lines(
    folder: Path, yaml: str, hardware: str = HARDWARE, only: tuple[str, ...] = (), **options: object
) -> list[str]:
    """Return the verdicts on the controllers, then the lines of the manager."""
    options = {"distro": "jazzy", **options}
    made = smoked(target_of(folder, files(yaml, hardware)), only, **options)
    remarks = [note.message for finding in made.linted.outcome.diagnostics for note in finding.notes]
    notes = [remark for remark in remarks if remark.startswith("the controller manager")]
    return [f"{name}: {verdict}" for name, verdict in verdicts(made).items()] + notes


def test_a_controller_that_nothing_stops_is_not_called_passed(tmp_path: Path) -> None:
    assert verdicts_and_lines(tmp_path, manager(arm=FORWARD) + section("arm", ELBOW)) == ["arm: skipped activate"]


def test_controllers_started_together_come_in_their_order_and_the_later_one_is_refused(tmp_path: Path) -> None:
    yaml = manager(one=FORWARD, two=FORWARD) + section("one", ELBOW) + section("two", ELBOW)
    assert verdicts_and_lines(tmp_path, yaml, started=("two", "one")) == [
        "two: skipped activate",
        "one: failed activate",
        (
            "the controller manager says: Unable to activate controller 'one' since the command interface "
            "'elbow/position' is currently claimed by another controller."
        ),
    ]


def test_controllers_that_nothing_starts_are_judged_one_at_a_time(tmp_path: Path) -> None:
    yaml = manager(one=FORWARD, two=FORWARD) + section("one", ELBOW) + section("two", ELBOW)
    assert verdicts_and_lines(tmp_path, yaml) == ["one: skipped activate", "two: skipped activate"]


@pytest.mark.parametrize(
    ("kind", "parameters", "verdict", "words"),
    [
        (NOISE, ELBOW, "failed load", f"Loader for controller 'arm' (type '{NOISE}') not found."),
        ("''", ELBOW, "failed load", "The 'type' param was not defined for 'arm'."),
        (
            FORWARD,
            "joints: [], interface_name: position",
            "failed load",
            "Could not initialize the controller named 'arm'",
        ),
        (
            FORWARD,
            "joints: [elbow, elbow], interface_name: position",
            "failed configure",
            (
                "The command interfaces of the controller 'arm' are not unique. Please make sure that the command "
                "interfaces are unique"
            ),
        ),
        (
            FORWARD,
            "joints: [elbow], interface_name: effort",
            "failed activate",
            "Unable to activate controller 'arm' since the command interface 'elbow/effort' is not available.",
        ),
        (
            "joint_trajectory_controller/JointTrajectoryController",
            "joints: [elbow], command_interfaces: [position], state_interfaces: [velocity]",
            "failed load",
            "Could not initialize the controller named 'arm'",
        ),
    ],
    ids=["type unknown", "type missing", "joints empty", "joint twice", "not offered", "combination"],
)
def test_a_refusal_of_ros2_quotes_the_manager(
    tmp_path: Path, kind: str, parameters: str, verdict: str, words: str
) -> None:
    yaml = manager(arm=kind) + section("arm", parameters)
    assert verdicts_and_lines(tmp_path, yaml) == [f"arm: {verdict}", f"the controller manager says: {words}"]


MISSPELT = "effort_controllers/JointEffrtController"
TRANSMISSION = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
"""
PID = "pid: {p: 1.0, i: 0.0, d: 1.0}"


@pytest.mark.parametrize(
    ("yaml", "verdict", "words"),
    [
        (f"arm: {{type: {MISSPELT}, joint: elbow}}", "failed load",
         f"Could not load controller 'arm' because controller type '{MISSPELT}' does not exist."),
        (f"arm: {{type: effort_controllers/JointPositionController, joint: shoulder, {PID}}}", "failed load",
         "Could not find resource 'shoulder' in 'hardware_interface::EffortJointInterface'."),
        ("arm: {type: effort_controllers/JointPositionController, joint: elbow}", "failed load",
         "Initializing controller 'arm' failed"),
        ("arm: {type: effort_controllers/JointTrajectoryController, joints: [elbow]}", "failed activate",
         "Could not start controller with name 'arm'"),
    ],
    ids=["type unknown", "no transmission", "no gains", "no gains to start with"],
)  # fmt: skip
def test_a_refusal_of_ros1_quotes_the_manager(tmp_path: Path, yaml: str, verdict: str, words: str) -> None:
    lines = verdicts_and_lines(tmp_path, yaml, TRANSMISSION, distro="noetic", simulator="gazebo-classic")
    assert lines == [f"arm: {verdict}", f"the controller manager says: {words}"]


def test_the_code_of_lint_is_named_if_it_is_only_one(tmp_path: Path) -> None:
    yaml = "arm: {type: position_controllers/JointPositionController, joint: elbow}"
    made = smoked(target_of(tmp_path, files(yaml, TRANSMISSION)), distro="noetic", simulator="gazebo-classic")
    [found] = made.linted.outcome.diagnostics
    assert found.message.endswith("cannot be loaded: no hardware offers joint 'elbow' in the PositionJointInterface")
    assert [note.message for note in found.notes] == [
        "the controller manager says: Could not find resource 'elbow' in 'hardware_interface::PositionJointInterface'.",
        "urdfctl lint reports it as UC461",
    ]


def test_the_manager_is_not_quoted_if_it_never_sees_the_file(tmp_path: Path) -> None:
    yaml = f"arm: {{type: effort_controllers/JointPositionController, joint: shoulder, {PID}, gain: }}"
    lines = verdicts_and_lines(tmp_path, yaml, TRANSMISSION, distro="noetic", simulator="gazebo-classic")
    assert lines == ["arm: failed load"]


def test_two_controllers_of_one_joint_are_a_conflict_in_ros1(tmp_path: Path) -> None:
    kind = f"{{type: effort_controllers/JointPositionController, joint: elbow, {PID}}}"
    lines = verdicts_and_lines(
        tmp_path, f"one: {kind}\ntwo: {kind}", TRANSMISSION, distro="noetic", started=("one", "two"), simulator="gz"
    )
    assert lines == [
        "one: skipped activate",
        "two: failed activate",
        "the controller manager says: Could not switch controllers, due to resource conflict",
    ]


def test_a_controller_of_ros1_without_type_is_not_loaded(tmp_path: Path) -> None:
    lines = verdicts_and_lines(
        tmp_path, f"arm: {{joint: elbow, {PID}}}", TRANSMISSION, distro="noetic", started=("arm",)
    )
    assert lines[-1] == (
        "the controller manager says: Could not load controller 'arm' because the type was not specified."
    )


def test_a_robot_that_is_refused_stops_all_of_them(tmp_path: Path) -> None:
    lines = verdicts_and_lines(
        tmp_path, manager(arm=FORWARD) + section("arm", ELBOW), HARDWARE + '<link name="other"/>'
    )
    assert lines == ["arm: failed load"]


def test_a_test_can_be_limited_to_some_controllers(tmp_path: Path) -> None:
    yaml = manager(one=FORWARD, two=NOISE) + section("one", ELBOW)
    assert verdicts_and_lines(tmp_path, yaml, only=("one",)) == ["one: skipped activate"]


def test_a_comment_silences_a_finding(tmp_path: Path) -> None:
    yaml = manager(arm=NOISE + "}  # {urdfctl: ignore[UC903] of another package").replace("package}", "package")
    made = smoked(target_of(tmp_path, files(yaml)), distro="jazzy")
    assert verdicts(made) == {"arm": "failed load"}
    assert made.linted.outcome.diagnostics == []


MIMIC_COMMANDED = GRIPPER.replace(
    '<joint name="finger">\n          <command',
    '<joint name="thumb"><command_interface name="position"/></joint>\n<joint name="finger">\n          <command',
)
"""The parser of ros2_control rejects it from jazzy on."""


def test_an_unknown_distro_is_never_the_most_permissive_one(tmp_path: Path) -> None:
    made = smoked(target_of(tmp_path, files(GRIPPER_CONTROLLER, MIMIC_COMMANDED)))
    [finding] = made.linted.outcome.diagnostics
    both = "it becomes active in humble, iron; it cannot be activated in jazzy to rolling: the hardware is rejected"
    assert (finding.code, finding.message.partition("unknown: ")[2]) == ("UC970", both)
    assert verdicts(made) == {"states": "warned activate", "gripper": "warned activate"}
    assert [result.reason for result in made.controllers] == [f"depends on the ROS distro: {both}"] * 2
    assert made.controllers[0].by_distro["kilted"] == "cannot be activated: the hardware is rejected"
    assert [note.message for note in finding.notes][-1] == "the same holds for 'gripper'"


@pytest.mark.parametrize(("distro", "verdict"), [("iron", "skipped activate"), ("kilted", "failed activate")])
def test_a_known_distro_decides(tmp_path: Path, distro: str, verdict: str) -> None:
    made = smoked(target_of(tmp_path, files(GRIPPER_CONTROLLER, MIMIC_COMMANDED)), distro=distro)
    assert (verdicts(made)["gripper"], made.distro) == (verdict, distro)


def test_a_verdict_that_all_possible_distros_share_is_certain(tmp_path: Path) -> None:
    made = smoked(target_of(tmp_path, files(manager(arm=NOISE) + section("arm", ELBOW))))
    assert (made.linted.distro, verdicts(made)) == (None, {"arm": "failed load"})
    assert [finding.code for finding in made.linted.outcome.diagnostics] == ["UC903"]


def test_a_robot_without_controllers_has_none(tmp_path: Path) -> None:
    made = smoked(target_of(tmp_path, {"robot.urdf": HARDWARE}), distro="jazzy")
    assert (made.controllers, made.linted.outcome.diagnostics) == ((), [])


def test_controllers_without_a_robot_are_judged_as_far_as_they_go(tmp_path: Path) -> None:
    path = tmp_path / "controllers.yaml"
    path.write_text(manager(arm=NOISE), encoding="utf-8")
    assert verdicts(smoked(Target(str(path)), distro="jazzy")) == {"arm": "failed load"}


def test_a_controller_before_one_that_is_refused_is_refused_too(tmp_path: Path) -> None:
    pid = "pid_controller/PidController"
    yaml = manager(low=pid, high=FORWARD) + section("high", "joints: [low/elbow], interface_name: velocity")
    given = (
        "dof_names: [elbow], command_interface: {}, reference_and_state_interfaces: [velocity], "
        "gains: {{elbow: {{p: 1.0}}}}"
    )
    velocity = HARDWARE.replace(
        '<state_interface name="position"/>', '<state_interface name="position"/><state_interface name="velocity"/>'
    )
    sound = verdicts_and_lines(tmp_path, yaml + section("low", given.format("position")), velocity)
    assert sound == ["low: skipped activate", "high: skipped activate"]
    broken = verdicts_and_lines(tmp_path, yaml + section("low", given.format("effort")), velocity)
    assert broken[:2] == ["low: failed activate", "high: failed activate"]
    given_up = smoked(
        target_of(tmp_path, files(yaml + section("low", given.format("effort")), velocity)), distro="jazzy"
    )
    [finding] = given_up.linted.outcome.diagnostics
    assert "controller 'low' cannot be activated" in finding.message
    assert finding.notes[-1].message == "it also stops controller 'high'"
    assert given_up.controllers[1].reason == (
        "it needs 'low/elbow/velocity' of controller 'low', which never becomes active"
    )


# -- what stops more than one controller -------------------------------------------------------------------------------

STEERING = "ackermann_steering_controller/AckermannSteeringController"
GEOMETRY = "wheelbase: 1.0, traction_track_width: 1.0, traction_wheels_radius: 0.1"
JOINTS = "traction_joints_names: [shoulder, elbow], steering_joints_names: [shoulder, elbow]"


def test_a_controller_that_ends_the_manager_stops_the_others(tmp_path: Path) -> None:
    car = section("car", f"{GEOMETRY}, {JOINTS}, velocity_rolling_window_size: 0")
    yaml = manager(arm=FORWARD, car=STEERING) + section("arm", ELBOW) + car
    made = smoked(target_of(tmp_path, files(yaml)), distro="jazzy")
    reasons = {result.name: result.reason for result in made.controllers}
    assert verdicts(made) == {"arm": "failed activate", "car": "failed activate"}
    assert reasons["arm"] == "controller 'car' ends the process of the controller manager"


def test_hardware_that_stays_unconfigured_stops_its_controllers(tmp_path: Path) -> None:
    name = re.findall(r'<ros2_control name="(\w+)"', HARDWARE)[0]
    state = f"    hardware_components_initial_state: {{unconfigured: [{name}]}}\n"
    yaml = manager(arm=FORWARD) + state + section("arm", ELBOW)
    made = smoked(target_of(tmp_path, files(yaml)), distro="jazzy", started=("arm",))
    assert verdicts(made) == {"arm": "failed activate"}


@pytest.mark.parametrize(("distro", "verdict"), [("jazzy", "failed activate"), ("humble", "skipped activate")])
def test_an_empty_list_for_the_node_of_the_hardware_stops_all_controllers(
    tmp_path: Path, distro: str, verdict: str
) -> None:
    hardware = re.sub(r'<ros2_control name="\w+"', '<ros2_control name="Arm"', HARDWARE)
    yaml = manager(arm=FORWARD, hand=FORWARD) + section("arm", "joints: []") + section("hand", ELBOW)
    made = smoked(target_of(tmp_path, files(yaml, hardware)), distro=distro)
    assert verdicts(made)["hand"] == verdict


def test_a_section_for_another_namespace_stops_only_its_controller(tmp_path: Path) -> None:
    yaml = manager(arm=FORWARD, hand=FORWARD) + section("'/*/arm'", ELBOW) + section("hand", ELBOW)
    made = smoked(target_of(tmp_path, files(yaml)), distro="jazzy")
    assert verdicts(made)["hand"] == "skipped activate"


def test_a_file_with_parameters_that_have_no_value_is_not_read(tmp_path: Path) -> None:
    yaml = manager(arm=FORWARD, hand=FORWARD) + "arm:\n  ros__parameters:\n" + section("hand", ELBOW)
    made = smoked(target_of(tmp_path, files(yaml)), distro="jazzy")
    assert verdicts(made) == {"arm": "failed load", "hand": "failed load"}


def test_what_rejected_hardware_does_not_offer_is_no_fault_of_its_own(tmp_path: Path) -> None:
    hardware = TRANSMISSION.replace(
        "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>", ""
    )
    yaml = f"arm: {{type: effort_controllers/JointPositionController, joint: elbow, {PID}}}"
    made = smoked(target_of(tmp_path, files(yaml, hardware)), distro="noetic", simulator="gazebo-classic")
    assert [finding.code for finding in made.linted.outcome.diagnostics] == ["UC902"]
    assert (made.controllers[0].reason, made.controllers[0].blocked_by) == ("the hardware is rejected", "hardware")


# -- what one fault stops, and nothing else ----------------------------------------------------------------------------


def test_a_wrong_section_of_another_node_stops_no_controller(tmp_path: Path) -> None:
    yaml = manager(arm=FORWARD, hand=FORWARD) + section("arm", ELBOW) + section("hand", ELBOW)
    made = smoked(target_of(tmp_path, files(yaml + "camera:\n  ros__parameters: []\n")), distro="jazzy")
    assert verdicts(made) == {"arm": "skipped activate", "hand": "skipped activate"}


def test_a_wrong_section_stops_its_controller_alone_and_is_reported_where_it_is(tmp_path: Path) -> None:
    yaml = manager(arm=FORWARD, hand=FORWARD) + section("arm", ELBOW) + section("hand", "joints: 5, interface_name: x")
    made = smoked(target_of(tmp_path, files(yaml)), distro="jazzy")
    assert verdicts(made) == {"arm": "skipped activate", "hand": "failed load"}
    [finding] = made.linted.outcome.diagnostics
    assert finding.excerpt[finding.at.column - 1 :].startswith("5, interface_name")


def test_a_broken_file_is_one_fault_of_all_its_controllers(tmp_path: Path) -> None:
    yaml = manager(arm=FORWARD, hand=FORWARD) + "arm:\n  ros__parameters:\n    joints:\n" + section("hand", ELBOW)
    made = smoked(target_of(tmp_path, files(yaml)), distro="jazzy")
    [finding] = made.linted.outcome.diagnostics
    assert [result.blocked_by for result in made.controllers] == ["", "arm"]
    assert finding.notes[-1].message == "it also stops controller 'hand'"
    assert not any("manager says" in note.message for note in finding.notes)


def test_a_file_of_parameters_that_the_manager_does_not_read_stops_the_controllers_in_it(tmp_path: Path) -> None:
    parts = {
        "robot.urdf": HARDWARE,
        "controllers.yaml": manager(arm=FORWARD, hand=FORWARD) + section("arm", ELBOW),
        "hand.yaml": "hand:\n  ros__parameters:\n    interface_name: position\n    joints: [elbow, 5]\n",
    }
    made = smoked(target_of(tmp_path, parts), distro="jazzy")
    assert verdicts(made) == {"arm": "skipped activate", "hand": "failed load"}


def test_controllers_of_two_namespaces_are_told_apart(tmp_path: Path) -> None:
    of_both = "".join(
        f"{side}:\n  controller_manager:\n    ros__parameters:\n      arm: {{type: {FORWARD}}}\n"
        f"  arm:\n    ros__parameters: {{joints: {joints}, interface_name: position}}\n"
        for side, joints in (("left", "[elbow]"), ("right", "5"))
    )
    made = smoked(target_of(tmp_path, files(of_both)), distro="jazzy")
    assert verdicts(made) == {"/left/arm": "skipped activate", "/right/arm": "failed load"}
    [finding] = made.linted.outcome.diagnostics
    assert finding.excerpt.strip() == "ros__parameters: {joints: 5, interface_name: position}"


def test_a_controller_that_is_started_in_the_wrong_namespace_is_reported_where_it_is_started(tmp_path: Path) -> None:
    launch = """
        <launch>
          <param name="robot_description" textfile="$(dirname)/robot.urdf"/>
          <rosparam file="$(dirname)/controllers.yaml" command="load"/>
          <node name="spawner" pkg="controller_manager" type="spawner" ns="/bot" args="arm"/>
        </launch>
    """
    yaml = f"robot:\n  arm: {{type: effort_controllers/JointPositionController, joint: elbow, {PID}}}\n"
    parts = {"robot.urdf": TRANSMISSION, "controllers.yaml": yaml, "robot.launch": launch}
    made = smoked(target_of(tmp_path, parts), distro="noetic", simulator="gazebo-classic")
    found = {finding.message: Path(finding.at.file).name for finding in made.linted.outcome.diagnostics}
    assert found == {
        "controller '/bot/arm' cannot be loaded: controller 'arm' is spawned in namespace '/bot', but declared in "
        "'/robot'": "robot.launch"
    }


@pytest.mark.parametrize(
    ("package", "more", "verdict"),
    [
        ("elsewhere", {}, {"arm": "skipped activate"}),
        ("arm", {"more.yaml": manager(hand=FORWARD) + section("hand", ELBOW)}, {"arm": "failed load"}),
    ],
)
def test_a_controller_whose_file_is_in_an_unknown_package_is_not_called_undeclared(
    tmp_path: Path, package: str, more: dict[str, str], verdict: dict[str, str]
) -> None:
    launch = f"""
        <launch>
          <node pkg="controller_manager" exec="ros2_control_node">
            <param from="$(find-pkg-share {package})/more.yaml"/>
          </node>
          <node pkg="controller_manager" exec="spawner" args="arm"/>
        </launch>
    """
    parts = {
        "robot.urdf": HARDWARE,
        "robot.launch.xml": launch,
        "package.xml": "<package format='3'><name>arm</name></package>",
        **more,
    }
    made = smoked(target_of(tmp_path, parts), ("arm",), distro="jazzy")
    assert verdicts(made) == verdict


def test_the_path_that_the_simulator_does_not_find_stops_all_controllers_once(tmp_path: Path) -> None:
    plugin = """
        <gazebo>
          <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
            <parameters>$HOME/ws/src/arm/controllers.yaml</parameters>
          </plugin>
        </gazebo>
    """
    launch = """
        <launch>
          <node pkg="ros_gz_sim" exec="create" args="-file $(dirname)/robot.urdf"/>
          <node pkg="robot_state_publisher" exec="robot_state_publisher">
            <param name="robot_description" value="$(command 'cat $(dirname)/robot.urdf')" type="str"/>
          </node>
          <node pkg="controller_manager" exec="spawner" args="arm hand"/>
        </launch>
    """
    hardware = HARDWARE.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    parts = {"robot.urdf": f"{hardware}{plugin}", "robot.launch.xml": launch}
    made = smoked(target_of(tmp_path, parts), distro="jazzy")
    assert verdicts(made) == {"arm": "failed load", "hand": "failed load"}
    [finding] = made.linted.outcome.diagnostics
    assert "'$HOME/ws/src/arm/controllers.yaml' is not expanded" in finding.message
    assert Path(finding.at.file).name == "robot.urdf"


GRIPPER_PART = """
    <robot name="gripper">
      <joint name="mount" type="fixed"><parent link="tool0"/><child link="palm"/></joint><link name="palm"/>
    </robot>
"""


@pytest.mark.parametrize("name", ["gripper.urdf", "gripper.xacro"])
@pytest.mark.parametrize("distro", ["noetic", "jazzy"])
def test_a_part_that_hangs_on_a_link_of_another_file_is_not_a_robot(tmp_path: Path, name: str, distro: str) -> None:
    made = smoked(target_of(tmp_path, {name: GRIPPER_PART}), distro=distro)
    assert (made.part_of, made.linted.outcome.diagnostics) == ("tool0", [])


def test_a_robot_of_which_a_part_is_not_here_is_no_part_itself(tmp_path: Path) -> None:
    include = '<xacro:include filename="$(find absent_arm)/urdf/arm.xacro"/>'
    opened = '<robot name="gripper" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    robot = GRIPPER_PART.replace('<robot name="gripper">', f"{opened}{include}")
    assert smoked(target_of(tmp_path, {"robot.xacro": robot}), distro="jazzy").part_of == ""


def test_a_robot_with_controllers_and_an_unknown_link_cannot_be_spawned(tmp_path: Path) -> None:
    parts = {"robot.urdf": GRIPPER_PART, "controllers.yaml": manager(arm=FORWARD) + section("arm", ELBOW)}
    made = smoked(target_of(tmp_path, parts), distro="jazzy")
    assert (made.part_of, [finding.code for finding in made.linted.outcome.diagnostics]) == ("", ["UC901"])


def static_check_of(folder: Path, yaml: str, robot: str = HARDWARE, **options: object) -> StaticCheck:
    target = target_of(folder, files(yaml, robot))
    return check_statically(lint_target(Loader(Settings(**options)), target, Selection()))  # type: ignore[arg-type]


def test_the_update_rate_is_that_of_the_manager_or_of_the_generation_of_ros(tmp_path: Path) -> None:
    yaml = manager(arm=FORWARD) + section("arm", ELBOW)
    assert static_check_of(tmp_path, yaml, distro="jazzy").rate == 100.0
    faster = yaml.replace("ros__parameters:\n", "ros__parameters:\n    update_rate: 250\n", 1)
    assert static_check_of(tmp_path, faster, distro="jazzy").rate == 250.0
    ros1 = f"arm: {{type: effort_controllers/JointPositionController, joint: elbow, {PID}}}"
    assert static_check_of(tmp_path, ros1, TRANSMISSION, distro="noetic", simulator="gazebo-classic").rate == 1000.0


@pytest.mark.parametrize(("links", "planned"), [(790, True), (810, False)])
def test_a_robot_of_more_than_800_links_is_not_simulated(tmp_path: Path, links: int, planned: bool) -> None:
    chain = "".join(
        f'<link name="p{n}"/><joint name="q{n}" type="fixed"><parent link="{f"p{n - 1}" if n else "fore"}"/>'
        f'<child link="p{n}"/></joint>'
        for n in range(links - 3)
    )
    target = target_of(tmp_path, files(manager(arm=FORWARD) + section("arm", ELBOW), HARDWARE + chain))
    made = checked(Loader(Settings(distro="jazzy")), target, SmokeRequest(engines=("pybullet",)))
    codes = [finding.code for finding in made.result.linted.outcome.diagnostics]
    assert (made.plan is not None, "UC921" in codes) == (planned, not planned)
