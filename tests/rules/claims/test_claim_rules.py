"""Messages and severities of the rules on claims, and when they are silent; the rules' examples test the rest."""

from __future__ import annotations

from pathlib import Path

import pytest
from control_session import ARM, POSITION, STATES, VELOCITY, component, joint, transmission
from robots import GAZEBO, Bench, controllers, findings, forward

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

CLAIMS = ("UC45", "UC460", "UC461", "UC462", "UC463", "UC464")


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path, *CLAIMS)


# -- interfaces of ROS 2 ---------------------------------------------------------------------------------------------


def test_an_interface_that_all_joints_lack_is_told_once_where_it_is_named(bench: Bench) -> None:
    [found] = bench.lint(ARM, controllers("arm") + forward("arm", "shoulder, elbow", "effort"))
    assert found.message == (
        "'shoulder' and 'elbow' have no 'effort' command interface, which controller 'arm' claims; "
        "the hardware of 'shoulder' exports: position"
    )
    assert found.excerpt.strip().endswith("interface_name: effort}")
    assert found.excerpt[found.at.column - 1 :].startswith("effort")


def test_an_interface_that_one_joint_lacks_is_told_at_that_joint(bench: Bench) -> None:
    part = component(joint("shoulder", VELOCITY + POSITION + STATES) + joint("elbow"))
    [found] = bench.lint(part, controllers("arm") + forward("arm", "shoulder, elbow", "velocity"))
    assert (
        found.message
        == "'elbow' has no 'velocity' command interface, which controller 'arm' claims; the hardware exports: position"
    )
    assert found.excerpt[found.at.column - 1 :].startswith("elbow")


@pytest.mark.parametrize(
    ("distro", "kind", "expected"),
    [
        ("jazzy", "bool", ["UC475"]),
        ("jazzy", "int32", ["UC475"]),
        ("jazzy", "double", []),
        ("kilted", "bool", []),
        ("kilted", "int32", ["UC475"]),
    ],
)
def test_a_trajectory_controller_reads_doubles_and_since_kilted_bools(
    tmp_path: Path, distro: str, kind: str, expected: list[str]
) -> None:
    part = component(joint("elbow", POSITION + f'<state_interface name="position" data_type="{kind}"/>'))
    jtc = controllers("arm", kind="joint_trajectory_controller/JointTrajectoryController") + (
        "arm:\n  ros__parameters:\n    joints: [elbow]\n    command_interfaces: [position]\n"
        "    state_interfaces: [position]\n"
    )
    found = Bench(tmp_path, "UC475").lint(part, jtc, distro=distro)
    assert [finding.code for finding in found] == expected
    assert all(finding.message.endswith(f"its data type is '{kind}'") for finding in found)


def test_a_joint_that_stands_in_no_component_is_told_once(bench: Bench) -> None:
    jtc = controllers("arm", kind="joint_trajectory_controller/JointTrajectoryController") + (
        "arm:\n  ros__parameters:\n    joints: [shoulder]\n    command_interfaces: [position]\n"
        "    state_interfaces: [position, velocity]\n"
    )
    [said] = bench.says(component(joint("elbow")), jtc)
    assert (
        said == "error UC450 joint 'shoulder' is in the robot, but not in <ros2_control>; "
        "controller 'arm' claims its 'position' command interface"
    )


def test_a_sensor_that_is_misspelt_is_found_by_its_name(bench: Bench) -> None:
    imu = controllers("imu", kind="state_interfaces_broadcaster/StateInterfacesBroadcaster") + (
        "imu:\n  ros__parameters: {interfaces: [imu_sensr/yaw]}\n"
    )
    part = component('<sensor name="imu_sensor"><state_interface name="yaw"/></sensor>')
    [said] = bench.says(part, imu)
    assert said == (
        "warning UC451 no hardware exports 'imu_sensr'; controller 'imu' claims its 'yaw' state interface; "
        "did you mean 'imu_sensor'?"
    )
    assert bench.codes(part, imu, started=("imu",)) == ["error UC451"]


def test_of_a_driver_it_is_not_sure(bench: Bench) -> None:
    part = component(joint("elbow"), plugin="acme_driver/Arm")
    [found] = bench.lint(part, controllers("arm") + forward("arm", "elbow", "effort"))
    assert found.severity.value == "warning"
    assert found.notes[-1].message == "the driver may export more interfaces than the description lists"
    assert bench.lint(part, controllers("arm") + forward("arm", "tcp", "twist.x")) == []


def test_of_a_driver_whose_joints_list_no_interface_nothing_is_said(bench: Bench) -> None:
    hardware = "<hardware><plugin>{}</plugin></hardware>"
    part = f'<ros2_control name="a" type="system">{hardware}<joint name="elbow"/></ros2_control>'
    menu = controllers("arm") + forward("arm", "elbow", "velocity")
    assert bench.codes(part.format("acme_driver/Arm"), menu) == []
    assert bench.codes(part.format("mock_components/GenericSystem"), menu) == ["error UC450"]


def test_controllers_for_the_choice_are_no_fault(bench: Bench) -> None:
    menu = controllers("arm", "pushing") + forward("arm", "elbow") + forward("pushing", "elbow", "effort")
    assert bench.codes(ARM, menu) == ["info UC450"]
    assert bench.codes(ARM, menu, started=("arm",)) == []
    assert bench.codes(ARM, menu, started=("pushing",)) == ["error UC450"]


def test_what_only_some_distros_refuse_is_a_warning_that_names_them(bench: Bench) -> None:
    drive = controllers("base", kind="diff_drive_controller/DiffDriveController") + (
        "base:\n  ros__parameters:\n    left_wheel_names: [shoulder]\n    right_wheel_names: [elbow]\n"
        "    wheel_separation: 1.0\n    wheel_radius: 1.0\n    open_loop: true\n"
    )
    part = component(joint("shoulder", VELOCITY) + joint("elbow", VELOCITY))
    [found] = bench.lint(part, drive, distro=None)
    assert (found.code, found.severity.value) == ("UC451", "warning")
    assert found.notes[-1].message == "applies to humble, iron"  # mock_components exists since humble
    assert bench.lint(part, drive, distro="jazzy") == []


@pytest.mark.parametrize(
    ("part", "yaml"),
    [
        ("", controllers("arm") + forward("arm", "elbow", "effort")),
        (ARM, controllers("arm", kind="acme/Arm") + forward("arm", "elbow", "effort")),
        (ARM, controllers("arm") + forward("arm", "$(var prefix)elbow", "effort")),
        (ARM, controllers("arm") + forward("arm", "elbow", "$(var interface)")),
        (ARM, controllers("arm") + forward("arm", "nobody")),
    ],
    ids=["no component", "unknown type", "joint not known", "interface not known", "misnamed joint"],
)
def test_it_is_silent_where_nothing_can_be_known_or_another_rule_speaks(bench: Bench, part: str, yaml: str) -> None:
    assert bench.lint(part, yaml) == []


def test_a_macro_of_a_library_is_not_judged(bench: Bench) -> None:
    macro = (
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="control" params="name">'
        f"{component(joint('${name}'))}</xacro:macro></robot>"
    )
    assert bench.lint(macro, controllers("arm") + forward("arm", "elbow", "effort"), name="r.xacro") == []


# -- ROS 1 -----------------------------------------------------------------------------------------------------------

EFFORT = "arm: {type: effort_controllers/JointEffortController, joint: elbow}\n"


def test_gazebo_offers_a_joint_in_one_interface_only(bench: Bench) -> None:
    [found] = bench.lint(transmission("elbow") + GAZEBO, EFFORT, distro="noetic")
    assert found.severity.value == "error"
    assert found.message == (
        "controller 'arm' requires 'elbow' in the EffortJointInterface, but the transmission offers the "
        "PositionJointInterface; name 'hardware_interface/EffortJointInterface' in the transmission"
    )


def test_the_type_that_does_the_same_is_named(bench: Bench) -> None:
    yaml = "arm: {type: effort_controllers/JointTrajectoryController, joints: [elbow], gains: {elbow: {p: 1}}}"
    [found] = bench.lint(transmission("elbow") + GAZEBO, yaml, distro="noetic")
    assert found.fix is not None
    assert found.fix.edits[0].text == "position_controllers/JointTrajectoryController"
    assert not found.fix.safe


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"simulator": "gazebo-classic"}, ["error UC461"]),
        ({}, ["warning UC461"]),
        ({"simulator": "none"}, ["info UC461"]),
    ],
)
def test_what_real_hardware_offers_is_only_mentioned(bench: Bench, options: dict[str, str], told: list[str]) -> None:
    assert bench.codes(transmission("elbow"), EFFORT, distro="noetic", **options) == told


def test_a_joint_without_transmission_is_told_unless_another_rule_says_why_it_has_none(bench: Bench) -> None:
    yaml = "arm: {type: position_controllers/JointPositionController, joint: shoulder}\n"
    assert bench.codes(transmission("elbow") + GAZEBO, yaml, distro="noetic") == ["error UC462"]
    broken = transmission("shoulder").replace("hardwareInterface", "interface")
    assert bench.codes(transmission("elbow") + broken + GAZEBO, yaml, distro="noetic") == []
    nested = f"<gazebo>{transmission('shoulder')}</gazebo>"
    assert bench.codes(transmission("elbow") + nested + GAZEBO, yaml, distro="noetic") == []


def test_sensors_of_gazebo_need_no_controller(bench: Bench) -> None:
    yaml = "imu: {type: imu_sensor_controller/ImuSensorController, publish_rate: 50}\n"
    assert bench.codes(transmission("elbow") + GAZEBO, yaml, distro="noetic") == ["error UC463"]
    assert bench.codes(transmission("elbow"), yaml, distro="noetic") == []


# -- gains -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("yaml", "told"),
    [
        (
            "arm: {type: effort_controllers/JointPositionController, joint: elbow}",
            "error UC464 controller 'arm' has no gain 'pid.p'; it is not loaded",
        ),
        (
            "arm: {type: velocity_controllers/JointTrajectoryController, joints: [a, b], gains: {a: {p: 1}}}",
            "error UC464 controller 'arm' has no gain 'gains.b.p'; it crashes when it is started",
        ),
        (
            "hand: {type: effort_controllers/GripperActionController, joint: a}",
            "warning UC464 controller 'hand' has no gain 'gains.a.p'; it does not move",
        ),
        ("arm: {type: position_controllers/JointTrajectoryController, joints: [a, b]}", None),
        ("arm: {type: effort_controllers/JointPositionController, joint: elbow, pid: {p: 0.0}}", None),
    ],
)
def test_gains_of_ros_1(bench: Bench, yaml: str, told: str | None) -> None:
    assert bench.says("", yaml, distro="noetic") == ([told] if told else [])


@pytest.mark.parametrize(
    ("given", "distro", "idle"),
    [
        ("command_interfaces: [effort]", "jazzy", True),
        ("command_interfaces: [effort], gains: {elbow: {p: 0.0, d: 0.0}}", "jazzy", True),
        ("command_interfaces: [effort], gains: {elbow: {p: 10.0}}", "jazzy", False),
        ("command_interfaces: [velocity], gains: {elbow: {ff_velocity_scale: 1.0}}", "humble", False),
        ("command_interfaces: [velocity], open_loop_control: true", "humble", False),
        ("command_interfaces: [velocity]", "kilted", True),
        ("command_interfaces: [position]", "jazzy", False),
        ("command_interfaces: [effort], gains: {elbow: {p: $(var p)}}", "jazzy", False),
        ("command_interfaces: $(var interfaces)", "jazzy", False),
    ],
)
def test_gains_of_ros_2_are_zero_where_none_is_given(bench: Bench, given: str, distro: str, idle: bool) -> None:
    part = component(joint("elbow", '<command_interface name="effort"/>' + VELOCITY + POSITION + STATES))
    yaml = controllers("arm", kind="joint_trajectory_controller/JointTrajectoryController") + (
        f"arm:\n  ros__parameters: {{joints: [elbow], state_interfaces: [position, velocity], {given}}}\n"
    )
    told = "controller 'arm' has only zero gains for 'elbow'; it becomes active but does not move"
    assert bench.says(part, yaml, distro=distro) == [f"warning UC464 {told}"] * idle


# -- hardware that is missing ----------------------------------------------------------------------------------------

BARE = """
<robot name="arm"><link name="base"/><link name="fore"/>
<joint name="elbow" type="revolute"><parent link="base"/><child link="fore"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>%s</robot>
"""
GAZEBO_OF_ROS1 = '<gazebo><plugin name="c" filename="libgazebo_ros_control.so">%s</plugin></gazebo>'
MOVER_OF_ROS1 = "mover: {type: effort_controllers/JointEffortController, joint: elbow}\n"


@pytest.mark.parametrize(
    ("inside", "severity"),
    [
        ("", ["info"]),
        (GAZEBO_OF_ROS1 % "", ["error"]),
        (GAZEBO_OF_ROS1 % "<robotSimType>my_package/OwnHardware</robotSimType>", []),
    ],
)
def test_in_ros_1_controllers_without_transmissions_are_an_error_only_in_gazebos_own_simulation(
    inside: str, severity: list[str], tmp_path: Path
) -> None:
    (tmp_path / "robot.urdf").write_text(BARE % inside, encoding="utf-8")
    (tmp_path / "c.yaml").write_text(MOVER_OF_ROS1, encoding="utf-8")
    target = Target(str(tmp_path / "robot.urdf"), controllers=(str(tmp_path / "c.yaml"),))
    settings = Settings(distro="noetic", workspace=str(tmp_path))
    found = lint_target(Loader(settings), target, Selection(("UC471",))).result.outcome.diagnostics
    assert [finding.severity.value for finding in found] == severity


# -- controllers that have nothing to claim ----------------------------------------------------------------------------


def test_a_broadcaster_without_any_state_interface_is_refused(tmp_path: Path) -> None:
    bench = Bench(tmp_path, "UC472")
    states = controllers("states", kind="joint_state_broadcaster/JointStateBroadcaster")
    assert bench.codes(component(joint("elbow", POSITION)), states) == ["error UC472"]
    assert bench.codes(component(joint("elbow", POSITION + STATES)), states) == []


def test_a_driver_may_export_more_states_than_it_lists(tmp_path: Path) -> None:
    bench = Bench(tmp_path, "UC472")
    states = controllers("states", kind="joint_state_broadcaster/JointStateBroadcaster")
    ours = component(joint("elbow", POSITION)).replace("mock_components/GenericSystem", "our_hardware/Arm")
    assert bench.codes(ours, states) == ["warning UC472"]


@pytest.mark.parametrize(("gpio", "expected"), [("io", []), ("other", ["error UC472"])])
def test_gpio_controllers_need_no_lists_if_the_robot_has_states_of_their_gpios(
    tmp_path: Path, gpio: str, expected: list[str]
) -> None:
    bench = Bench(tmp_path, "UC431", "UC434", "UC472")
    part = component(f'<gpio name="{gpio}"><state_interface name="in"/></gpio>')
    sens = controllers("sens", kind="gpio_controllers/GpioCommandController")
    assert bench.codes(part, sens + "sens: {ros__parameters: {gpios: [io]}}\n") == expected


DRIVEN = {
    "package.xml": "<package><name>hoist</name><run_depend>hoist_driver</run_depend></package>",
    "hoist.urdf": """<robot name="hoist"><link name="base"/><link name="hook"/>
      <joint name="winch" type="continuous"><parent link="base"/><child link="hook"/></joint>
      <transmission name="t"><type>transmission_interface/SimpleTransmission</type>
        <joint name="winch"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
        <actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>%s</robot>""",
    "hoist.yaml": "lift: {type: position_controllers/JointPositionController, joint: winch}\n",
    "hoist.launch": """<launch><param name="robot_description" textfile="$(find hoist)/hoist.urdf"/>
      <rosparam command="load" file="$(find hoist)/hoist.yaml"/>%s
      <node name="spawner" pkg="controller_manager" type="spawner" args="lift"/></launch>""",
}
DRIVER = '<node name="driver" pkg="hoist_driver" type="driver_node"/>'
SIMULATOR = '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'


@pytest.mark.parametrize(
    ("plugin", "started", "expected"), [("", DRIVER, []), (GAZEBO, DRIVER, ["warning"]), (GAZEBO, SIMULATOR, ["error"])]
)
def test_what_a_driver_registers_is_not_judged_by_the_transmissions_of_a_robot_without_plugin(
    plugin: str, started: str, expected: list[str], tmp_path: Path
) -> None:
    for name, text in DRIVEN.items():
        path = tmp_path / name
        path.write_text(text % (plugin if name == "hoist.urdf" else started) if "%s" in text else text)
    target = Target(str(tmp_path / "hoist.urdf"), launch=str(tmp_path / "hoist.launch"))
    assert [one.severity.value for one in findings(target, ("UC461",), distro="noetic")] == expected
