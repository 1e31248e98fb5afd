"""Rules on hardware plugins, their parameters and names, and on comments, by distro."""

from __future__ import annotations

import pytest
from components import ELBOW, GZ, MIMIC, MOCK, STATE, component, joint, told
from robots import Robot


def hardware(inside: str) -> str:
    """A component on mock hardware with parameters."""
    return component(f"<hardware><plugin>mock_components/GenericSystem</plugin>{inside}</hardware>{ELBOW}")


def plugin(name: str, attributes: str = 'name="arm" type="system"') -> str:
    """A component with a plugin."""
    return component(f"<hardware><plugin>{name}</plugin></hardware>{ELBOW}", attributes)


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
        ("GenericSystem", "jazzy", ["error UC353"]),
        ("my_components/GenericSystem", "jazzy", []),
        ("${plugin}", "jazzy", ["error UC353"]),
        ("gazebo_ros2_control/GazeboSystem", "jazzy", ["warning UC353"]),
        ("gazebo_ros2_control/GazeboSystem", "humble", []),
        ("gz_ros2_control/GzSimSystem", "jazzy", ["error UC353"]),
        ("gz_ros2_control/GazeboSimSystem", "galactic", ["warning UC353"]),
        ("my_robot/MyHardware", None, []),
    ],
)
def test_plugins_are_reported_if_the_distro_has_none_of_that_name(
    robot: Robot, name: str, distro: str | None, expected: list[str]
) -> None:
    assert told(robot, plugin(name), distro) == expected


def test_the_name_of_a_plugin_is_fixed(robot: Robot) -> None:
    found = robot.only("UC353", plugin("mock_components::GenericSystem"), distro="jazzy")
    assert "<plugin>mock_components/GenericSystem</plugin>" in robot.fixed(found)


def test_a_plugin_of_another_type_is_an_error_unless_a_condition_chose_it(robot: Robot) -> None:
    sensor = 'name="arm" type="sensor"'
    assert "error UC354" in told(robot, plugin("mock_components/GenericSystem", sensor))
    chosen = '<xacro:if value="true"><plugin>mock_components/GenericSystem</plugin></xacro:if>'
    part = component(f'<hardware>{chosen}</hardware><sensor name="s">{STATE}</sensor>', sensor)
    assert told(robot, part, name="robot.xacro") == ["warning UC354"]


@pytest.mark.parametrize(
    ("inside", "hardware", "distro", "expected"),
    [
        (f'<command_interface name="acceleration"/>{STATE}', MOCK, "jazzy", []),
        (f'<command_interface name="acceleration"/>{STATE}', GZ, "jazzy", ["warning UC355"]),
        ('<state_interface name="torque"/>', GZ, "jazzy", ["warning UC355"]),
        (f'<command_interface name="position_pid"/>{STATE}', GZ.replace("gz_", "gazebo_"), "humble", ["error UC353"]),
        (f'<command_interface name="acceleration"/>{STATE}', GZ, None, ["warning UC355"]),  # since humble
    ],
)
def test_interfaces_that_the_simulator_lacks_are_reported(
    robot: Robot, inside: str, hardware: str, distro: str | None, expected: list[str]
) -> None:
    assert told(robot, joint(inside, hardware=hardware), distro) == expected


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
def test_parameters_of_mock_hardware_are_known_and_have_the_right_type(
    robot: Robot, parameter: str, humble: list[str], jazzy: list[str]
) -> None:
    assert told(robot, hardware(parameter), "humble") == humble
    assert told(robot, hardware(parameter), "jazzy") == jazzy


def test_parameters_of_the_hardware_that_mock_hardware_replaces_are_accepted(robot: Robot) -> None:
    choice = '<xacro:if value="true"><plugin>mock_components/GenericSystem</plugin></xacro:if>'
    part = component(f'<hardware>{choice}<param name="serial_port">/dev/tty</param></hardware>{ELBOW}')
    assert told(robot, part, name="robot.xacro") == []


def test_of_two_parameters_of_a_name_the_last_is_used(robot: Robot) -> None:
    twice = '<param name="calculate_dynamics">true</param><param name="calculate_dynamics">{}</param>'
    assert told(robot, hardware(twice.format("false"))) == ["warning UC340"]
    assert told(robot, hardware(twice.format("true"))) == ["info UC340"]


def test_a_mimic_joint_of_mock_hardware_has_only_states_of_the_mimicked_joint(robot: Robot) -> None:
    both = component(f'{MOCK}{ELBOW}<joint name="grip">{STATE}<state_interface name="velocity"/></joint>')
    assert told(robot, MIMIC + both) == ["error UC360"]
    assert told(robot, MIMIC + both, "humble") == []
    assert told(robot, MIMIC + both.replace("mock_components/GenericSystem", "my/Gripper")) == []


def test_an_expression_in_a_plain_urdf_is_not_expanded(robot: Robot) -> None:
    part = component(
        f'<hardware><plugin>my/Arm</plugin><param name="file">$(find arm)/a.yaml</param></hardware>{ELBOW}'
    )
    assert told(robot, part) == ["warning UC363"]
    assert told(robot, part.replace("$(find arm)", "${1 + 1}"), name="robot.xacro") == []


def test_an_empty_parameter_is_rejected_up_to_galactic(robot: Robot) -> None:
    part = component(f'<hardware><plugin>my/Arm</plugin><param name="file"/></hardware>{ELBOW}')
    assert [told(robot, part, distro) for distro in ("foxy", "galactic", "humble", None)] == [
        ["error UC364"],
        ["error UC364"],
        [],
        [],
    ]


# -- missing components ----------------------------------------------------------------------------------------------

GZ_PLUGIN = '<gazebo><plugin filename="gz_ros2_control-system" name="x"/></gazebo>'


def test_a_simulator_plugin_requires_a_component(robot: Robot) -> None:
    assert told(robot, GZ_PLUGIN) == ["error UC361"]
    assert told(robot, GZ_PLUGIN, None) == ["error UC361"]
    assert told(robot, GZ_PLUGIN + component(GZ + ELBOW)) == []


def test_a_component_without_joints_has_no_interfaces(robot: Robot) -> None:
    assert told(robot, component(MOCK)) == ["warning UC362"]
    chosen = f'{MOCK}<xacro:if value="false">{ELBOW}</xacro:if>'
    assert told(robot, component(chosen), name="robot.xacro") == ["info UC362"]


LIBRARY = """
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="arm" params="name sim">
    <ros2_control name="${name}" type="system">
      <hardware>
        <xacro:if value="${sim}"><plugin>gz_ros2_control/GazeboSimSystem</plugin></xacro:if>
        <xacro:unless value="${sim}"><plugin>my/Arm</plugin>MORE</xacro:unless>
      </hardware>
      <joint name="${name}"><state_interface name="position"/></joint>
    </ros2_control>
  </xacro:macro>
</robot>
"""


def test_in_a_macro_alternatives_are_not_duplicates_but_neighbours_are(robot: Robot) -> None:
    alternatives = LIBRARY.strip().replace("MORE", "")
    assert told(robot, alternatives, None, name="library.xacro") == []
    neighbours = LIBRARY.strip().replace("MORE", "<plugin>my/Other</plugin>")
    assert told(robot, neighbours, None, name="library.xacro") == ["warning UC344"]


# -- names with whitespace --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("distro", "expected"),
    [("humble", ["error UC351"]), ("jazzy", ["warning UC351"]), ("rolling", []), (None, ["warning UC351"])],
)
def test_whitespace_is_part_of_a_plugin_name_in_old_releases(
    robot: Robot, distro: str | None, expected: list[str]
) -> None:
    assert told(robot, plugin("\n  mock_components/GenericSystem\n"), distro) == expected


def test_whitespace_is_removed_from_names(robot: Robot) -> None:
    found = robot.only("UC351", joint('<state_interface name="position "/>'), distro="humble")
    assert '<state_interface name="position"/>' in robot.fixed(found)
    broken = robot.only("UC351", plugin("  mock_components/GenericSystem "), distro="humble")
    assert "<plugin>mock_components/GenericSystem</plugin>" in robot.fixed(broken)


# -- comments --------------------------------------------------------------------------------------------------------

CLASSIC = """
    <gazebo><plugin filename="libgazebo_ros2_control.so" name="c"><parameters>a.yaml</parameters></plugin></gazebo>
    <ros2_control name="arm" type="system">
      <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin><!-- {} --></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""


@pytest.mark.parametrize("comment", ["see http://example.org", "a:b", "issue#1"])
def test_comments_that_yaml_accepts_are_not_reported(robot: Robot, comment: str) -> None:
    assert told(robot, CLASSIC.format(comment), "humble") == []


@pytest.mark.parametrize("comment", ["a: b", "a:\n b", "issue #1"])
def test_comments_that_break_yaml_are_reported_for_gazebo_classic_in_humble(robot: Robot, comment: str) -> None:
    assert told(robot, CLASSIC.format(comment), "humble") == ["warning UC359"]
    assert told(robot, CLASSIC.format(comment), "iron") == []
    assert robot.only("UC359", CLASSIC.format(comment), distro="humble").excerpt.count("<!--") == 1


def test_a_misspelt_component_is_missing(robot: Robot) -> None:
    part = component(MOCK + ELBOW).replace("ros2_control", "Ros2_control")
    assert robot.says(part, distro="jazzy") == ["error UC154"]
    assert robot.says(part) == ["warning UC154"]
