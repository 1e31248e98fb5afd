"""What the rules on <ros2_control> say of interfaces, limits, parameters, plugins and transmissions, by distro."""

from __future__ import annotations

from pathlib import Path

import pytest
from arm import Robot, notes

MOCK = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
GZ = "<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
ELBOW = '<joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>'
STATE = '<state_interface name="position"/>'
FINGER = """
    <link name="finger"/>
    <joint name="grip" type="prismatic">
      <parent link="fore"/><child link="finger"/><limit lower="0" upper="1" effort="1" velocity="1"/>
    </joint>
"""
MIMIC = FINGER.replace("</joint>", '<mimic joint="elbow"/></joint>')


@pytest.fixture
def robot(tmp_path: Path) -> Robot:
    return Robot(tmp_path)


def component(inside: str, attributes: str = 'name="arm" type="system"') -> str:
    """A part of a robot: one <ros2_control>."""
    return f"<ros2_control {attributes}>{inside}</ros2_control>"


def joint(inside: str, hardware: str = MOCK) -> str:
    """A component with the joint elbow."""
    return component(f'{hardware}<joint name="elbow">{inside}</joint>')


def hardware(inside: str) -> str:
    """A component on mock hardware with parameters."""
    return component(f"<hardware><plugin>mock_components/GenericSystem</plugin>{inside}</hardware>{ELBOW}")


def plugin(name: str, attributes: str = 'name="arm" type="system"') -> str:
    """A component with a plugin."""
    return component(f"<hardware><plugin>{name}</plugin></hardware>{ELBOW}", attributes)


def told(robot: Robot, part: str, distro: str | None = "jazzy", **options: str) -> list[str]:
    """Severities and codes of what the family finds."""
    return [found for found in robot.says(part, distro=distro, **options) if " UC3" in found]


# -- values of interfaces --------------------------------------------------------------------------------------------


def initial(value: str, attributes: str = "") -> str:
    """A component whose state interface has an initial value."""
    parameter = f'<param name="initial_value">{value}</param>'
    return joint(f'<state_interface name="position"{attributes}>{parameter}</state_interface>')


@pytest.mark.parametrize("value", ["0", "-1.5", "+.5", "1e-3", "2.", " 0.5 ", ""])
def test_initial_values_that_are_numbers_are_taken(robot: Robot, value: str) -> None:
    assert told(robot, initial(value)) == []


@pytest.mark.parametrize("value", ["home", "90deg", "0,5", "inf", "nan", "true", "${pi/2}", "1e999"])
def test_initial_values_that_are_none_are_refused_from_jazzy_on(robot: Robot, value: str) -> None:
    assert told(robot, initial(value)) == ["error UC331"]
    assert told(robot, initial(value), "humble") == ["warning UC331"]


@pytest.mark.parametrize(
    ("kind", "value", "expected"),
    [
        ("bool", "true", []),
        ("bool", "1", ["error UC331"]),
        ("int32", "3", []),
        ("int32", "3.5", ["error UC331"]),
        ("float32", "3.5", []),
    ],
)
def test_an_initial_value_is_of_its_interface_s_type(robot: Robot, kind: str, value: str, expected: list[str]) -> None:
    assert told(robot, initial(value, f' data_type="{kind}"')) == expected


def limited(lower: str, upper: str, interface: str = "position") -> str:
    """A component whose command interface has limits."""
    limits = f'<param name="min">{lower}</param><param name="max">{upper}</param>'
    return joint(f'<command_interface name="{interface}">{limits}</command_interface>{STATE}')


@pytest.mark.parametrize(
    ("part", "expected"),
    [
        (limited("-1", "1"), []),
        (limited("low", "1"), ["warning UC332"]),
        (limited("-inf", "inf"), ["warning UC332", "warning UC332"]),
        (limited("1", "-1"), ["warning UC333"]),
        (limited("-1.0004", "1"), []),
        (limited("-1.5", "1.5"), ["info UC334"]),
        (limited("-2", "2", "velocity"), []),
        (limited("-2.5", "2", "velocity"), ["info UC334"]),
        (limited("-10", "11", "effort"), ["info UC334"]),
        (limited("-10", "10", "jerk"), ["warning UC352"]),
    ],
)
def test_limits_are_numbers_in_order_within_the_urdf_s(robot: Robot, part: str, expected: list[str]) -> None:
    assert told(robot, part) == expected


def test_limits_beyond_the_urdf_s_are_told_once_with_both(robot: Robot) -> None:
    found = robot.only("UC334", limited("-1.5", "1.5"), distro="jazzy")
    assert found.message == (
        "command interface 'position' of joint 'elbow' has 'min' of -1.5 and 'max' of 1.5, "
        "beyond the URDF's 'lower' of -1 and 'upper' of 1"
    )


@pytest.mark.parametrize(("name", "meant"), [("Min", "min"), ("MAX", "max"), ("maximum", "max"), ("lower", "min")])
def test_a_limit_s_name_is_mended(robot: Robot, name: str, meant: str) -> None:
    limit = f'<param name="{name}">0.5</param>'
    found = robot.only("UC352", joint(f'<command_interface name="position">{limit}</command_interface>{STATE}'))
    assert f'<param name="{meant}">' in robot.fixed(found)


# -- interfaces ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("part", "expected"),
    [
        (joint(""), ["warning UC335"]),
        (joint('<param name="id">3</param>'), []),
        (component(f'{MOCK}{ELBOW}<gpio name="io"/>'), ["warning UC335"]),
        (component(f'<hardware><plugin>my/Driver</plugin></hardware>{ELBOW}<gpio name="io"/>'), ["info UC335"]),
        (MIMIC + component(f'{MOCK}{ELBOW}<joint name="grip"/>'), []),
        (joint(STATE + STATE), ["warning UC336"]),
        (component(MOCK + ELBOW + ELBOW), ["warning UC337"]),
        (component(f'{MOCK}{ELBOW}<gpio name="elbow">{STATE}</gpio>'), ["warning UC337"]),
        (component(f'{MOCK}{ELBOW}<joint name="elbow"><state_interface name="effort"/></joint>'), []),
        (joint('<comand_interface name="position"/><state_interface name="velocity"/>'), ["warning UC338"]),
        (joint('<state_interfce name="velocity"/>'), ["warning UC338"]),
        (joint(f"{STATE}<hardwareInterface>EffortJointInterface</hardwareInterface>"), ["warning UC338"]),
        (joint('<state_interface name="position" max="1"/>'), ["warning UC339"]),
        (component(MOCK + ELBOW, 'name="arm" type="system" color="red"'), ["warning UC339"]),
        (joint('<command_interface name="position"/>'), ["info UC346"]),
        (joint(f'<command_interface name="postion"/>{STATE}'), ["warning UC345"]),
        (joint(f'<command_interface name="position_pid"/>{STATE}'), []),
        (joint(f'<command_interface name="gripper_force"/>{STATE}'), []),
        (component(f'{MOCK}{ELBOW}<sensor name="s"><command_interface name="a"/></sensor>'), ["warning UC343"]),
    ],
)
def test_interfaces_that_are_lost_are_told(robot: Robot, part: str, expected: list[str]) -> None:
    assert told(robot, part) == expected


@pytest.mark.parametrize(
    ("part", "humble", "jazzy"),
    [
        (joint(f'{STATE}<limits enable="false"/>'), ["info UC338"], []),
        (component(MOCK + ELBOW, 'name="arm" type="system" rw_rate="50"'), ["warning UC339"], []),
        (component(MOCK + ELBOW, 'name="arm" type="system" is_async="true"'), ["warning UC339"], []),
        (joint('<state_interface name="position" data_type="double"/>'), ["warning UC339"], []),
        (joint(f'<param name="initial_position">0.5</param>{STATE}'), ["warning UC342"], ["warning UC342"]),
        (joint(f'<param name="initial_value">0.5</param>{STATE}'), ["warning UC342"], ["warning UC342"]),
    ],
)
def test_what_only_some_distros_read_is_told_where_it_is_lost(
    robot: Robot, part: str, humble: list[str], jazzy: list[str]
) -> None:
    assert told(robot, part, "humble") == humble
    assert told(robot, part, "jazzy") == jazzy


def follower(parameters: str) -> str:
    """A component with a joint `grip` that has parameters."""
    return component(f'{MOCK}{ELBOW}<joint name="grip">{parameters}{STATE}</joint>')


def test_a_mimic_in_a_parameter_is_what_the_distro_takes_it_for(robot: Robot) -> None:
    old = follower('<param name="mimic">elbow</param><param name="multiplier">-1</param>')
    assert told(robot, FINGER + old, "humble") == []
    assert told(robot, MIMIC + old, None) == []
    assert told(robot, MIMIC + old, "jazzy") == ["warning UC341"]
    found = robot.only("UC341", FINGER + old, distro="jazzy")
    assert found.fix is not None
    assert '<mimic joint="elbow" multiplier="-1"/>' in found.fix.title
    unknown = follower('<param name="mimic">elbwo</param>')
    assert told(robot, FINGER + unknown, "humble") == ["error UC341"]
    assert "did you mean 'elbow'?" in robot.only("UC341", FINGER + unknown, distro="humble").message


# -- plugins and their parameters ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "distro", "expected"),
    [
        ("mock_components/GenericSystem", "humble", []),
        ("mock_components/GenericSystem", "foxy", ["error UC353"]),
        ("fake_components/GenericSystem", "jazzy", ["error UC353"]),
        ("fake_components/GenericSystem", None, []),
        ("mock_components::GenericSystem", "jazzy", ["error UC353"]),
        ("mock_components/genericsystem", "jazzy", ["error UC353"]),
        ("mock_components/GenericActuator", "jazzy", ["error UC353"]),
        ("mock_component/GenericSystem", "jazzy", ["error UC353"]),
        ('"mock_components/GenericSystem"', "jazzy", ["error UC353"]),
        ("my_components/GenericSystem", "jazzy", []),
        ("${plugin}", "jazzy", ["error UC353"]),
        ("gazebo_ros2_control/GazeboSystem", "jazzy", ["warning UC353"]),
        ("gazebo_ros2_control/GazeboSystem", "humble", []),
        ("gz_ros2_control/GzSimSystem", "jazzy", ["warning UC353"]),
        ("gz_ros2_control/GazeboSimSystem", "galactic", ["warning UC353"]),
        ("my_robot/MyHardware", None, []),
    ],
)
def test_plugins_are_told_where_the_distro_has_none_of_the_name(
    robot: Robot, name: str, distro: str | None, expected: list[str]
) -> None:
    assert told(robot, plugin(name), distro) == expected


def test_a_plugin_s_name_is_mended(robot: Robot) -> None:
    found = robot.only("UC353", plugin("mock_components::GenericSystem"), distro="jazzy")
    assert "<plugin>mock_components/GenericSystem</plugin>" in robot.fixed(found)


def test_a_plugin_of_another_type_is_an_error_where_no_condition_chose_it(robot: Robot) -> None:
    sensor = 'name="arm" type="sensor"'
    assert "error UC354" in told(robot, plugin("mock_components/GenericSystem", sensor))
    chosen = '<xacro:if value="true"><plugin>mock_components/GenericSystem</plugin></xacro:if>'
    part = component(f'<hardware>{chosen}</hardware><sensor name="s">{STATE}</sensor>', sensor)
    assert told(robot, part, name="robot.xacro") == ["warning UC354"]


@pytest.mark.parametrize(
    ("inside", "hardware", "distro", "expected"),
    [
        (f'<command_interface name="acceleration"/>{STATE}', MOCK, "jazzy", []),
        (f'<command_interface name="acceleration"/>{STATE}', GZ, "jazzy", ["error UC355"]),
        ('<state_interface name="torque"/>', GZ, "jazzy", ["error UC355"]),
        (f'<command_interface name="position_pid"/>{STATE}', GZ.replace("gz_", "gazebo_"), "humble", ["warning UC353"]),
        (f'<command_interface name="acceleration"/>{STATE}', GZ, None, ["warning UC355"]),
    ],
)
def test_interfaces_are_told_that_the_simulator_does_not_have(
    robot: Robot, inside: str, hardware: str, distro: str | None, expected: list[str]
) -> None:
    assert told(robot, joint(inside, hardware), distro) == expected


@pytest.mark.parametrize(
    ("parameter", "humble", "jazzy"),
    [
        ('<param name="calculate_dynamics">true</param>', [], []),
        ('<param name="calculate_dynamics">yes</param>', ["warning UC357"], ["error UC357"]),
        ('<param name="calculate_dynamics"/>', ["warning UC357"], ["error UC357"]),
        ('<param name="calculate_dynamics"><!-- no -->false</param>', [], []),
        ('<param name="position_state_following_offset">none</param>', ["warning UC357"], ["error UC357"]),
        ('<param name="fake_sensor_commands">true</param>', ["warning UC356"], ["warning UC356"]),
        ('<param name="serial_port">/dev/ttyUSB0</param>', ["warning UC356"], ["warning UC356"]),
        (
            '<param name="disable_commands" value="true"/>',
            ["warning UC357", "warning UC339"],
            ["error UC357", "warning UC339"],
        ),
    ],
)
def test_parameters_of_mock_hardware_are_known_and_of_their_types(
    robot: Robot, parameter: str, humble: list[str], jazzy: list[str]
) -> None:
    assert told(robot, hardware(parameter), "humble") == humble
    assert told(robot, hardware(parameter), "jazzy") == jazzy


def test_parameters_of_the_hardware_that_mock_hardware_stands_in_for_may_stay(robot: Robot) -> None:
    choice = '<xacro:if value="true"><plugin>mock_components/GenericSystem</plugin></xacro:if>'
    part = component(f'<hardware>{choice}<param name="serial_port">/dev/tty</param></hardware>{ELBOW}')
    assert told(robot, part, name="robot.xacro") == []


def test_of_two_parameters_of_a_name_the_last_counts(robot: Robot) -> None:
    twice = '<param name="calculate_dynamics">true</param><param name="calculate_dynamics">{}</param>'
    assert told(robot, hardware(twice.format("false"))) == ["warning UC340"]
    assert told(robot, hardware(twice.format("true"))) == ["info UC340"]


# -- names with blanks -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("distro", "expected"),
    [("humble", ["error UC351"]), ("jazzy", ["warning UC351"]), ("rolling", []), (None, ["warning UC351"])],
)
def test_blanks_in_a_plugin_belong_to_it_in_old_releases(robot: Robot, distro: str | None, expected: list[str]) -> None:
    assert told(robot, plugin("\n  mock_components/GenericSystem\n"), distro) == expected


def test_blanks_are_taken_out_of_names(robot: Robot) -> None:
    found = robot.only("UC351", joint('<state_interface name="position "/>'), distro="humble")
    assert '<state_interface name="position"/>' in robot.fixed(found)
    broken = robot.only("UC351", plugin("  mock_components/GenericSystem "), distro="humble")
    assert "<plugin>mock_components/GenericSystem</plugin>" in robot.fixed(broken)


# -- transmissions ---------------------------------------------------------------------------------------------------


def gear(inside: str, kind: str = "SimpleTransmission") -> str:
    """A component of my own with a transmission."""
    named = f'<transmission name="gear"><plugin>transmission_interface/{kind}</plugin>{inside}</transmission>'
    return component(f"<hardware><plugin>my/Arm</plugin></hardware>{ELBOW}{named}")


ENDS = '<joint name="elbow" role="joint1">{}</joint><actuator name="motor" role="actuator1"/>'


@pytest.mark.parametrize(
    ("part", "distro", "expected"),
    [
        (gear(ENDS), "jazzy", []),
        (gear(ENDS, "NopeTransmission"), "jazzy", ["warning UC347"]),
        (gear(ENDS, "DifferentialTransmission"), "jazzy", ["warning UC348", "warning UC348"]),
        (gear(ENDS.replace("<actuator", "<motor")), "jazzy", ["warning UC348", "warning UC338"]),
        (gear(ENDS.format("<mechanical_reduction>0.0</mechanical_reduction>")), "jazzy", ["warning UC349"]),
        (gear(ENDS.format("<offset>zero</offset>")), "humble", ["warning UC349"]),
        (gear(ENDS.format("<offset>zero</offset>")), "foxy", ["error UC349", "warning UC347"]),
        (gear(ENDS.format("<mechanicalReduction>2</mechanicalReduction>")), "jazzy", ["warning UC338"]),
    ],
)
def test_transmissions_are_what_their_loaders_take(robot: Robot, part: str, distro: str, expected: list[str]) -> None:
    assert sorted(told(robot, part, distro)) == sorted(expected)


# -- comments --------------------------------------------------------------------------------------------------------

CLASSIC = """
    <gazebo><plugin filename="libgazebo_ros2_control.so" name="c"><parameters>a.yaml</parameters></plugin></gazebo>
    <ros2_control name="arm" type="system">
      <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin><!-- {} --></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""


@pytest.mark.parametrize("comment", ["see http://example.org", "a:b", "issue#1"])
def test_comments_that_yaml_takes_are_left_alone(robot: Robot, comment: str) -> None:
    assert told(robot, CLASSIC.format(comment), "humble") == []


@pytest.mark.parametrize("comment", ["a: b", "a:\n b", "issue #1"])
def test_comments_that_break_yaml_are_told_for_gazebo_classic_in_humble(robot: Robot, comment: str) -> None:
    assert told(robot, CLASSIC.format(comment), "humble") == ["warning UC359"]
    assert told(robot, CLASSIC.format(comment), "iron") == []
    assert robot.only("UC359", CLASSIC.format(comment), distro="humble").excerpt.count("<!--") == 1


def test_a_component_that_is_misspelt_is_missing(robot: Robot) -> None:
    part = component(MOCK + ELBOW).replace("ros2_control", "Ros2_control")
    assert robot.says(part, distro="jazzy") == ["error UC154"]
    assert robot.says(part) == ["warning UC154"]


def test_the_notes_lead_to_the_other_place(robot: Robot) -> None:
    assert notes(robot.only("UC336", joint(STATE + STATE), distro="jazzy")) == "it is here"
