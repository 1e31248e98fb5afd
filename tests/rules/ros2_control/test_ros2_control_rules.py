"""Rules on <ros2_control> by distro, compared with its parser and manager; their examples test the rest."""

from __future__ import annotations

import pytest
from components import ELBOW, MIMIC, MOCK, component, joint, told
from robots import Robot, notes

SIMPLE = "<plugin>transmission_interface/SimpleTransmission</plugin>"


def gear(inside: str, attributes: str = 'name="gear"') -> str:
    """A component with a transmission."""
    return component(f"{MOCK}{ELBOW}<transmission {attributes}>{inside}</transmission>")


REFUSED = {
    "no attribute name in ros2_control tag": ("UC301", component(attributes='type="system"')),
    "no attribute type in ros2_control tag": ("UC302", component(attributes='name="arm"')),
    "invalid tag name joints": ("UC304", component(f"{MOCK}{ELBOW}<joints/>")),
    "invalid tag name group": ("UC304", component(f"{MOCK}{ELBOW}<group>arms</group>")),
    "invalid tag name plugin": ("UC304", component(f"{MOCK}{ELBOW}<plugin>mock_components/GenericSystem</plugin>")),
    "Missing <plugin> tag of <hardware>": ("UC306", component(f"<hardware/>{ELBOW}")),
    "no attribute name in joint tag": ("UC307", component(f"{MOCK}<joint><state_interface name='position'/></joint>")),
    "no attribute name in sensor tag": ("UC307", component(f"{MOCK}{ELBOW}<sensor/>")),
    "no attribute name in gpio tag": ("UC307", component(f"{MOCK}{ELBOW}<gpio/>")),
    "no attribute name in command_interface tag": (
        "UC308",
        joint("<command_interface/><state_interface name='effort'/>"),
    ),
    "no attribute name in state_interface tag": ("UC308", joint("<state_interface>position</state_interface>")),
    "no parameter name attribute set in param tag": (
        "UC309",
        joint("<state_interface name='effort'/><param>1</param>"),
    ),
    'Could not parse size tag in "state_interface".Got "-1"': (
        "UC319",
        component(f'{MOCK}{ELBOW}<gpio name="io"><state_interface name="in" size="-1"/></gpio>'),
    ),
    "Missing <plugin> tag of <transmission>": (
        "UC325",
        gear('<joint name="elbow" role="joint1"/><actuator name="motor" role="actuator1"/>'),
    ),
    "Missing <plugin> tag of <transmission> in ROS 1's form": (
        "UC324",
        gear('<type>transmission_interface/SimpleTransmission</type><joint name="elbow"/><actuator name="motor"/>'),
    ),
    "no attribute name in transmission tag": (
        "UC326",
        gear(f'{SIMPLE}<joint name="elbow" role="joint1"/><actuator name="motor" role="actuator1"/>', ""),
    ),
    "no attribute role in joint tag": (
        "UC326",
        gear(f'{SIMPLE}<joint name="elbow"/><actuator name="m" role="actuator1"/>'),
    ),
    "no attribute name in actuator tag": (
        "UC326",
        gear(f'{SIMPLE}<joint name="elbow" role="joint1"/><actuator role="actuator1"/>'),
    ),
    "no attribute role in actuator tag": (
        "UC326",
        gear(f'{SIMPLE}<joint name="elbow" role="joint1"/><actuator name="m"/>'),
    ),
    "Transmission 'gear' declared joint 'wrist' is not available in component 'arm'": (
        "UC327",
        gear(f'{SIMPLE}<joint name="wrist" role="joint1"/><actuator name="motor" role="actuator1"/>'),
    ),
    "There should be exactly one joint defined in this component but found 0": (
        "UC328",
        component(
            f"{MOCK}{ELBOW}<transmission name='gear'>{SIMPLE}<actuator name='m' role='actuator1'/></transmission>",
            'name="arm" type="actuator"',
        ),
    ),
    "no ros2_control tag": ("UC329", f"<gazebo>{component()}</gazebo>"),
}
"""What the parser of every distro rejects, by humble's error message."""


@pytest.mark.parametrize("distro", ["foxy", "humble", "jazzy", "rolling", None])
@pytest.mark.parametrize("message", REFUSED)
def test_what_every_parser_rejects_is_an_error_in_every_distro(robot: Robot, message: str, distro: str | None) -> None:
    code, part = REFUSED[message]
    assert f"error {code}" in told(robot, part, distro)


REFUSED_FROM_JAZZY = {
    "Joint 'wrist' not found in URDF": (
        "UC312",
        component(f'{MOCK}<joint name="wrist"><state_interface name="effort"/></joint>'),
    ),
    "Joint 'tip' is of type 'fixed'": (
        "UC313",
        '<link name="tip"/><joint name="tip" type="fixed"><parent link="fore"/><child link="tip"/></joint>'
        + component(f'{MOCK}<joint name="tip"><state_interface name="effort"/></joint>'),
    ),
}


@pytest.mark.parametrize("message", REFUSED_FROM_JAZZY)
def test_what_contradicts_the_urdf_is_an_error_since_jazzy_and_otherwise_a_warning(robot: Robot, message: str) -> None:
    code, part = REFUSED_FROM_JAZZY[message]
    reported = {distro: told(robot, part, distro) for distro in ("humble", "jazzy", "rolling", None)}
    assert reported == {
        "humble": [f"warning {code}"],
        "jazzy": [f"error {code}"],
        "rolling": [f"error {code}"],
        None: [f"warning {code}"],
    }


@pytest.mark.parametrize(
    ("plugin", "severity"),
    [("gazebo_ros2_control/GazeboSystem", "error"), ("mock_components/GenericSystem", "warning")],
)
def test_a_simulator_skips_a_fixed_joint_that_is_commanded(robot: Robot, plugin: str, severity: str) -> None:
    fixed = '<link name="tip"/><joint name="tip" type="fixed"><parent link="fore"/><child link="tip"/></joint>'
    hardware = f"<hardware><plugin>{plugin}</plugin></hardware>"
    part = component(f'{hardware}<joint name="tip"><command_interface name="position"/></joint>')
    assert f"{severity} UC313" in told(robot, fixed + part, "humble")


ONLY_FROM_JAZZY = {
    "Activated mimic joints cannot have command interfaces": (
        "UC314",
        MIMIC + component(f"{MOCK}{ELBOW}<joint name='grip'><command_interface name='effort'/></joint>"),
    ),
    "Mimic joint 'elbow' not found in <ros2_control> tag": (
        "UC315",
        MIMIC + component(f"{MOCK}<joint name='grip'><state_interface name='effort'/></joint>"),
    ),
    "Joint 'elbow' has no mimic information in the URDF": (
        "UC316",
        joint('<state_interface name="position"/>', ' mimic="true"'),
    ),
    "Input string : 'yes' is not a valid boolean value": (
        "UC317",
        joint('<state_interface name="position"/>', ' mimic="yes"'),
    ),
    "no attribute 'enable' in 'limits' tag": ("UC318", joint('<state_interface name="position"/><limits/>')),
    'Could not parse size tag in "state_interface". Got ""': (
        "UC319",
        joint('<state_interface name="position" size=""/>'),
    ),
    "Invalid data type: 'float' for interface": (
        "UC320",
        joint('<state_interface name="position" data_type="float"/>'),
    ),
    'Could not parse rw_rate tag in "ros2_control". Got "-1"': (
        "UC321",
        component(attributes='name="arm" type="system" rw_rate="-1"'),
    ),
    'Could not parse rw_rate tag in "ros2_control". Invalid value: ""': (
        "UC321",
        component(attributes='name="arm" type="system" rw_rate=""'),
    ),
    'Could not parse rw_rate tag in "ros2_control". Out of range value': (
        "UC321",
        component(attributes='name="arm" type="system" rw_rate="99999999999"'),
    ),
    'Could not parse thread_priority tag in "ros2_control". Got "0"': (
        "UC322",
        component(attributes='name="arm" type="system" is_async="true" thread_priority="0"'),
    ),
    "Couldn't parse remap rule: '-r __node:=2arm'": ("UC311", component(attributes='name="2arm" type="system"')),
}


@pytest.mark.parametrize("message", ONLY_FROM_JAZZY)
def test_what_only_jazzy_and_later_read_is_an_error_there(robot: Robot, message: str) -> None:
    code, part = ONLY_FROM_JAZZY[message]
    for distro in ("jazzy", "rolling"):
        assert f"error {code}" in told(robot, part, distro)
    assert not [found for found in told(robot, part, "humble") if code in found]
    assert f"warning {code}" in told(robot, part, None)


@pytest.mark.parametrize(
    ("properties", "expected"),
    [
        ('<async affinity="[0, 1]" scheduling_policy="Detached" print_warnings="TRUE"/>', []),
        ('<async affinity="[a]"/>', ["error UC323"]),
        ('<async scheduling_policy="fifo"/>', ["error UC323"]),
        ('<async thread_priority="0"/>', ["error UC323"]),
        ('<async print_warnings="yes"/>', ["error UC323"]),
    ],
)
def test_async_properties_are_read_where_the_component_is_asynchronous(
    robot: Robot, properties: str, expected: list[str]
) -> None:
    inside = f"{MOCK}{ELBOW}<properties>{properties}</properties>"
    part = component(inside, 'name="arm" type="system" is_async="true"')
    assert told(robot, part, "jazzy") == expected
    assert "error UC304" in told(robot, part, "humble")
    assert told(robot, component(inside), "jazzy") == ["warning UC323"]


@pytest.mark.parametrize("rate", ["0", "50", " 50 ", "1000"])
def test_an_integer_rate_is_accepted_with_whitespace_around_it(robot: Robot, rate: str) -> None:
    assert told(robot, component(attributes=f'name="arm" type="system" rw_rate="{rate}"'), "jazzy") == []


@pytest.mark.parametrize(("rate", "read"), [("10.5", "10"), ("1e2", "1")])
def test_text_after_a_rate_is_lost(robot: Robot, rate: str, read: str) -> None:
    found = robot.only("UC321", component(attributes=f'name="arm" type="system" rw_rate="{rate}"'), distro="jazzy")
    assert found.severity.value == "warning"
    assert f"read as {read};" in found.message


@pytest.mark.parametrize("name", ["arm", "_arm", "left/arm", "arm2", " arm "])
def test_valid_node_names_are_accepted(robot: Robot, name: str) -> None:
    assert told(robot, component(attributes=f'name="{name}" type="system"'), "rolling") == []


@pytest.mark.parametrize("name", ["", "my arm", "my-arm", "my.arm", "2arm", "ärm", "${name}", "a" * 256])
def test_invalid_node_names_are_rejected_since_jazzy(robot: Robot, name: str) -> None:
    part = component(attributes=f'name="{name}" type="system"')
    assert told(robot, part, "jazzy") == ["error UC311"]
    assert told(robot, part, "humble") == []


def test_the_fix_of_a_type_is_safe_if_only_its_case_is_wrong(robot: Robot) -> None:
    capital = robot.only("UC303", component(attributes='name="arm" type="System"'))
    assert capital.fix is not None
    assert capital.fix.safe
    assert 'type="system"' in robot.fixed(capital)
    other = robot.only("UC303", component(attributes='name="arm" type="systm"'))
    assert other.fix is not None
    assert not other.fix.safe


def test_an_interface_name_between_the_tags_is_fixed(robot: Robot) -> None:
    found = robot.only(
        "UC308", joint('<command_interface>position</command_interface><state_interface name="position"/>')
    )
    assert '<command_interface name="position"/><state' in robot.fixed(found)
    ros1 = robot.only("UC308", joint("<command_interface>hardware_interface/EffortJointInterface</command_interface>"))
    assert ros1.fix is not None
    assert ros1.fix.title == 'write <command_interface name="effort"/>'


def test_an_unknown_joint_is_fixed_and_a_link_is_noted(robot: Robot) -> None:
    found = robot.only("UC312", component(f'{MOCK}<joint name="elbwo"><state_interface name="effort"/></joint>'))
    assert 'name="elbow"' in robot.fixed(found)
    link = robot.only("UC312", component(f'{MOCK}<joint name="fore"><state_interface name="effort"/></joint>'))
    assert "'fore' is a link; the joint that moves it is 'elbow'" in notes(link)


def test_a_note_shows_what_replaces_a_transmission_of_ros1(robot: Robot) -> None:
    part = component(
        f"""{MOCK}
        <transmission name="t">
          <type>transmission_interface/SimpleTransmission</type>
          <joint name="elbow"><hardwareInterface>VelocityJointInterface</hardwareInterface></joint>
          <actuator name="motor"/>
        </transmission>"""
    )
    found = robot.only("UC324", part)
    assert notes(found) == (
        'in <ros2_control>, write <joint name="elbow"><command_interface name="velocity"/>'
        '<state_interface name="position"/><state_interface name="velocity"/></joint>'
    )


def test_transmissions_in_the_root_of_a_ros2_robot_are_reported_once(robot: Robot) -> None:
    old = """
        <transmission name="NAME">
          <type>transmission_interface/SimpleTransmission</type>
          <joint name="NAME"><hardwareInterface>EffortJointInterface</hardwareInterface></joint>
          <actuator name="NAME_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
        </transmission>
    """
    part = old.replace("NAME", "elbow") + old.replace("NAME", "shoulder") + component()
    found = robot.only("UC330", part)
    assert found.message == (
        "transmission 'elbow' and 1 more are ignored by ROS 2, which reads <ros2_control> instead; "
        "joint 'shoulder' is in none"
    )
    assert robot.says(old.replace("NAME", "elbow"), distro="noetic") == ["warning UC202"]


DRIVE = """<gazebo><plugin name="drive" filename="libgazebo_ros_diff_drive.so">
  <left_joint>shoulder</left_joint><right_joint>elbow</right_joint></plugin></gazebo>"""


ALL_CONTROLLED = """<ros2_control name="all" type="system">
  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
</ros2_control>"""


@pytest.mark.parametrize(
    ("joint", "more", "severity"),
    [
        ("shoulder", "", "warning"),
        ("sholder", "", "warning"),
        ("sholder", ALL_CONTROLLED, "info"),
        ("{name}_hip", ALL_CONTROLLED, "info"),
        ("shoulder", DRIVE, "info"),
    ],
)
def test_a_transmission_that_no_joint_needs_is_only_a_leftover(
    robot: Robot, joint: str, more: str, severity: str
) -> None:
    old = f"""<transmission name="old"><type>transmission_interface/SimpleTransmission</type>
      <joint name="{joint}"><hardwareInterface>EffortJointInterface</hardwareInterface></joint>
      <actuator name="motor"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>"""
    assert f"{severity} UC330" in robot.says(old + more, distro="humble")


def test_hardware_that_arguments_choose_is_not_an_error(robot: Robot) -> None:
    part = component(f'<xacro:if value="false">{MOCK}</xacro:if>{ELBOW}')
    assert told(robot, part, "jazzy", name="robot.xacro") == ["info UC305"]
    part = component(f'<hardware><xacro:unless value="1"><plugin>a/B</plugin></xacro:unless></hardware>{ELBOW}')
    assert told(robot, part, "jazzy", name="robot.xacro") == ["info UC306"]


LIBRARY = """
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="arm_control" params="name type plugin joint rate *more">
    <ros2_control name="${name}" type="${type}" rw_rate="${rate}" is_async="${rate}">
      <hardware>
        <xacro:if value="${plugin}"><plugin>${plugin}</plugin></xacro:if>
        <xacro:unless value="${plugin}"><plugin>mock_components/GenericSystem</plugin></xacro:unless>
      </hardware>
      <joint name="${joint}" mimic="${rate}">
        <command_interface name="${name}" data_type="${type}" size="${rate}"/><limits enable="${rate}"/>
      </joint>
      <transmission name="${name}">
        <xacro:insert_block name="more"/><joint name="${joint}2" role="joint1"/>
      </transmission>
    </ros2_control>
    <ros2_control name="${name}" type="${type}"><xacro:insert_block name="more"/></ros2_control>
    <ros2_control name="b" type="system"><xacro:of_another_file/></ros2_control>
  </xacro:macro>
</robot>
"""


def test_nothing_is_reported_about_parameters_of_a_macro(robot: Robot) -> None:
    (robot.folder / "library.xacro").write_text(LIBRARY.strip(), encoding="utf-8")
    assert robot.says(LIBRARY.strip(), distro="jazzy", name="library.xacro") == []
