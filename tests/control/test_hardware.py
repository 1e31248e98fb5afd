"""The interfaces that hardware offers by its description: in ROS 2 by its tag, in ROS 1 by the transmissions."""

from __future__ import annotations

import pytest
from control_session import ARM, POSITION, STATES, component, joint, session, transmission

from urdfctl.control.hardware.interfaces import Absence, ClaimKind, OfferedHardware


def hardware(part: str, distro: str = "jazzy") -> OfferedHardware:
    return session(part, distro=distro).hardware


def offered(found: OfferedHardware) -> tuple[list[str], list[str]]:
    command, state = (
        [f"{offer.component}/{offer.interface}" for offers in found.offers(kind).values() for offer in offers]
        for kind in ClaimKind
    )
    return command, state


def test_each_joint_offers_the_interfaces_of_its_tag() -> None:
    command, state = offered(hardware(component(joint("elbow"))))
    assert command == ["elbow/position"]
    assert state == ["elbow/position", "elbow/velocity"]
    [offer] = hardware(component(joint("elbow"))).of(ClaimKind.COMMAND, "elbow")
    assert offer.at.span.text == POSITION
    assert offer.by == "hw"


def test_sensors_offer_states_only() -> None:
    sensor = '<sensor name="imu"><command_interface name="a"/><state_interface name="b"/></sensor>'
    assert offered(hardware(component(sensor))) == ([], ["imu/b"])
    assert offered(hardware(component(joint("elbow"), kind="sensor")))[0] == []


@pytest.mark.parametrize(
    ("parameter", "distro", "command"),
    [
        ("mock_sensor_commands", "jazzy", ["imu/yaw", "io/out"]),
        ("mock_gpio_commands", "humble", ["io/out", "io/in"]),
        ("fake_sensor_commands", "humble", ["imu/yaw", "io/out"]),
        ("fake_sensor_commands", "jazzy", ["io/out"]),
    ],
)
def test_mock_hardware_adds_commands_for_states_if_a_parameter_says_so(
    parameter: str, distro: str, command: list[str]
) -> None:
    parts = (
        '<sensor name="imu"><state_interface name="yaw"/></sensor>'
        '<gpio name="io"><command_interface name="out"/><state_interface name="in"/></gpio>'
    )
    tag = component(parts).replace("</hardware>", f'<param name="{parameter}">True</param></hardware>')
    assert offered(hardware(tag, distro))[0] == command


def test_what_is_not_offered_is_surely_absent_if_the_plugin_is_known() -> None:
    found = hardware(ARM)
    assert found.absence(ClaimKind.COMMAND, "elbow", "position") is None
    assert found.absence(ClaimKind.COMMAND, "elbow", "effort") is Absence.SURE
    assert found.absence(ClaimKind.STATE, "tcp", "twist.x") is Absence.SURE


def test_a_driver_may_offer_more_than_its_tag_says() -> None:
    found = hardware(component(joint("elbow"), plugin="acme/Driver"))
    assert found.absence(ClaimKind.COMMAND, "elbow", "effort") is Absence.LIKELY
    assert found.absence(ClaimKind.COMMAND, "shoulder", "position") is Absence.LIKELY
    assert found.absence(ClaimKind.COMMAND, "tcp", "twist.x") is None


def test_a_driver_that_exports_interfaces_of_its_own_lacks_none_that_its_tag_does_not_list() -> None:
    found = hardware(component(joint("elbow"), plugin="canopen_ros2_control/CanopenSystem"))
    assert found.absence(ClaimKind.COMMAND, "elbow", "nmt/reset") is None
    other = hardware(component(joint("elbow"), plugin="our_drivers/Arm"))
    assert other.absence(ClaimKind.COMMAND, "elbow", "nmt/reset") is Absence.LIKELY


def test_with_two_components_certainty_depends_on_each_plugin() -> None:
    found = hardware(component(joint("elbow")) + component(joint("shoulder"), plugin="acme/Driver"))
    assert found.absence(ClaimKind.COMMAND, "elbow", "effort") is Absence.SURE
    assert found.absence(ClaimKind.COMMAND, "shoulder", "effort") is Absence.LIKELY


def test_nothing_is_known_about_a_robot_without_the_tag() -> None:
    assert hardware("").absence(ClaimKind.COMMAND, "elbow", "position") is None
    nested = f"<gazebo>{ARM}</gazebo>"
    assert not hardware(nested).known


def test_a_transmission_makes_a_joint_offer_its_interface_and_its_state() -> None:
    found = hardware(transmission("elbow") + transmission("shoulder", "EffortJointInterface"), "noetic")
    assert offered(found) == (
        ["elbow/hardware_interface/PositionJointInterface", "shoulder/hardware_interface/EffortJointInterface"],
        ["elbow/hardware_interface/JointStateInterface", "shoulder/hardware_interface/JointStateInterface"],
    )
    assert found.absence(ClaimKind.COMMAND, "elbow", "hardware_interface/EffortJointInterface") is Absence.SURE


@pytest.mark.parametrize(
    "broken",
    [
        transmission("elbow").replace("<type>transmission_interface/SimpleTransmission</type>", ""),
        transmission("elbow").replace("<actuator", "<motor").replace("</actuator", "</motor"),
        transmission("elbow").replace("<hardwareInterface>", "<interface>").replace("</hardwareI", "</i"),
        transmission("elbow").replace(
            "<joint ", "<joint name='x'><hardwareInterface>a</hardwareInterface></joint><joint "
        ),
    ],
)
def test_a_transmission_that_is_dropped_offers_nothing(broken: str) -> None:
    assert offered(hardware(broken, "noetic")) == ([], [])


def test_of_several_interfaces_the_simulation_uses_the_first_and_needs_no_prefix() -> None:
    two = transmission("elbow").replace(
        "<hardwareInterface>", "<hardwareInterface>EffortJointInterface</hardwareInterface><hardwareInterface>"
    )
    assert offered(hardware(two, "noetic"))[0] == ["elbow/hardware_interface/EffortJointInterface"]


def test_names_are_read_without_whitespace_around_them() -> None:
    tag = component(joint(" elbow ", STATES.replace('"position"', '" position"')))
    assert offered(hardware(tag))[1] == ["elbow/position", "elbow/velocity"]


def test_gazebo_classic_offers_position_for_its_own_pid() -> None:
    tag = component(joint("elbow", '<command_interface name="position_pid"/>'), "gazebo_ros2_control/GazeboSystem")
    assert offered(hardware(tag, "humble"))[0] == ["elbow/position"]
