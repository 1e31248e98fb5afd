"""Rules on interfaces, limits and transmissions of <ros2_control>, by distro."""

from __future__ import annotations

import pytest
from components import ELBOW, FINGER, MIMIC, MOCK, STATE, component, joint, told
from robots import Robot, notes

# -- values of interfaces --------------------------------------------------------------------------------------------


def initial(value: str, attributes: str = "") -> str:
    """A component whose state interface has an initial value."""
    parameter = f'<param name="initial_value">{value}</param>'
    return joint(f'<state_interface name="position"{attributes}>{parameter}</state_interface>')


@pytest.mark.parametrize("value", ["0", "-1.5", "+.5", "1e-3", "2.", " 0.5 ", ""])
def test_initial_values_that_are_numbers_are_accepted(robot: Robot, value: str) -> None:
    assert told(robot, initial(value)) == []


@pytest.mark.parametrize("value", ["home", "90deg", "0,5", "inf", "nan", "true", "${pi/2}", "1e999"])
def test_other_initial_values_are_rejected_since_jazzy(robot: Robot, value: str) -> None:
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
def test_an_initial_value_has_the_type_of_its_interface(
    robot: Robot, kind: str, value: str, expected: list[str]
) -> None:
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
        (limited("0", "20", "gripper_force"), ["warning UC352"]),
        (limited("0", "20", "gripper_force").replace("mock_components/GenericSystem", "my/Gripper"), []),
    ],
)
def test_limits_are_numbers_in_order_within_the_urdf_s(robot: Robot, part: str, expected: list[str]) -> None:
    assert told(robot, part) == expected


def test_limits_wider_than_in_the_urdf_are_reported_once_with_both(robot: Robot) -> None:
    found = robot.only("UC334", limited("-1.5", "1.5"), distro="jazzy")
    assert found.message == (
        "command interface 'position' of joint 'elbow' has 'min' -1.5 and 'max' 1.5, "
        "beyond the URDF's 'lower' -1 and 'upper' 1"
    )


@pytest.mark.parametrize(("name", "meant"), [("Min", "min"), ("MAX", "max"), ("maximum", "max"), ("lower", "min")])
def test_the_name_of_a_limit_is_fixed(robot: Robot, name: str, meant: str) -> None:
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
        (component(f'<hardware><plugin>my/Driver</plugin></hardware>{ELBOW}<gpio name="io"/>'), []),
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
def test_lost_interfaces_are_reported(robot: Robot, part: str, expected: list[str]) -> None:
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
def test_what_only_some_distros_read_is_reported_for_the_others(
    robot: Robot, part: str, humble: list[str], jazzy: list[str]
) -> None:
    assert told(robot, part, "humble") == humble
    assert told(robot, part, "jazzy") == jazzy


def follower(parameters: str) -> str:
    """A component with a joint `grip` that has parameters."""
    return component(f'{MOCK}{ELBOW}<joint name="grip">{parameters}{STATE}</joint>')


def test_a_mimic_parameter_is_judged_by_the_distro(robot: Robot) -> None:
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


# -- transmissions ---------------------------------------------------------------------------------------------------


def gear(inside: str, kind: str = "SimpleTransmission") -> str:
    """A component with an unknown plugin and a transmission."""
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
def test_transmissions_match_their_loaders(robot: Robot, part: str, distro: str, expected: list[str]) -> None:
    assert sorted(told(robot, part, distro)) == sorted(expected)


def test_the_note_points_to_the_first_declaration(robot: Robot) -> None:
    assert notes(robot.only("UC336", joint(STATE + STATE), distro="jazzy")) == "first declared here"
