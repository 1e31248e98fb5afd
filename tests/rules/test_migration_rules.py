"""The findings of the migration rules, distro by distro. The rules' examples cover the rest."""

from __future__ import annotations

import pytest
from robots import Robot, notes

from urdfctl.catalog.distros import coming


def component(hardware: str) -> str:
    return f"""
    <ros2_control name="arm" type="system">
      <hardware><plugin>{hardware}</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
    """


def plugin(filename: str, name: str) -> str:
    inside = "<parameters>/opt/arm/controllers.yaml</parameters>"
    return f'<gazebo><plugin filename="{filename}" name="{name}">{inside}</plugin></gazebo>'


CLASSIC = component("gazebo_ros2_control/GazeboSystem") + plugin("libgazebo_ros2_control.so", "control")
IGNITION = component("ign_ros2_control/IgnitionSystem") + plugin(
    "ign_ros2_control-system", "ign_ros2_control::IgnitionROS2ControlPlugin"
)


def of_family(robot: Robot, part: str, **options: str) -> list[str]:
    return [told for told in robot.says(part, **options) if "UC7" in told]


@pytest.mark.parametrize(
    ("distro", "then"),
    [
        ("noetic", ()),
        ("foxy", ("galactic", "humble")),
        ("humble", ("iron", "jazzy")),
        ("jazzy", ("kilted", "lyrical")),
        ("lyrical", ("rolling",)),
        ("rolling", ()),
    ],
)
def test_the_coming_distros_end_with_the_next_that_is_supported_for_long(distro: str, then: tuple[str, ...]) -> None:
    assert coming(distro) == then


@pytest.mark.parametrize(
    ("distro", "told"),
    [
        ("foxy", []),
        ("galactic", []),
        ("humble", ["info UC705"]),
        ("iron", ["info UC705"]),
        ("jazzy", ["error UC701"]),
        ("rolling", ["error UC701"]),
    ],
)
def test_gazebo_classic_ends_with_iron(robot: Robot, distro: str, told: list[str]) -> None:
    assert of_family(robot, CLASSIC, distro=distro) == told


def test_nothing_is_said_of_what_ends_some_day_where_no_distro_is_named(robot: Robot) -> None:
    assert of_family(robot, CLASSIC) == []


def test_a_robot_for_both_simulators_is_not_blamed_for_the_older(robot: Robot) -> None:
    both = CLASSIC + plugin("gz_ros2_control-system", "gz_ros2_control::GazeboSimROS2ControlPlugin")
    assert of_family(robot, both, distro="jazzy") == ["info UC701"]


def test_many_plugins_of_one_library_are_one_finding(robot: Robot) -> None:
    camera = '<sensor name="eye"><plugin name="eye" filename="libgazebo_ros_camera.so"/></sensor>'
    part = f'<gazebo reference="upper">{camera}</gazebo><gazebo reference="fore">{camera}</gazebo>'
    found = robot.only("UC701", part, distro="jazzy")
    assert found.severity.value == "warning"
    assert "1 more in this robot" in notes(found)


@pytest.mark.parametrize(
    ("distro", "told"),
    [
        ("galactic", []),
        ("humble", ["warning UC702", "warning UC703"]),
        ("jazzy", ["warning UC702", "warning UC703"]),
        ("kilted", []),
    ],
)
def test_ignitions_names_are_old_from_humble_on_and_gone_from_kilted(
    robot: Robot, distro: str, told: list[str]
) -> None:
    assert sorted(of_family(robot, IGNITION, distro=distro)) == told
    refused = {"error UC504", "warning UC353"} <= set(robot.says(IGNITION, distro=distro))
    assert refused is (distro == "kilted")


def test_the_old_names_are_information_where_all_maintained_distros_have_the_new(robot: Robot) -> None:
    assert sorted(of_family(robot, IGNITION)) == ["info UC702", "info UC703"]
    assert of_family(robot, component("fake_components/GenericSystem")) == ["info UC703"]


def test_file_and_class_of_a_plugin_are_renamed_together(robot: Robot) -> None:
    found = robot.only("UC702", IGNITION, distro="humble")
    mended = robot.fixed(found)
    assert 'filename="gz_ros2_control-system"' in mended
    assert 'name="gz_ros2_control::GazeboSimROS2ControlPlugin"' in mended


@pytest.mark.parametrize(
    ("distro", "told"), [("humble", []), ("jazzy", ["warning UC702"]), ("rolling", ["warning UC702"])]
)
def test_the_systems_of_ignition_are_old_where_the_simulator_is(robot: Robot, distro: str, told: list[str]) -> None:
    system = """
    <gazebo>
      <plugin filename="ignition-gazebo-joint-state-publisher-system"
              name="ignition::gazebo::systems::JointStatePublisher"/>
    </gazebo>
    """
    assert robot.says(system, distro=distro) == told


def declared(robot: Robot, kind: str, distro: str) -> list[str]:
    (robot.folder / "package.xml").write_text("<package><name>arm</name></package>", encoding="utf-8")
    (robot.folder / "arm.yaml").write_text(
        f"controller_manager:\n  ros__parameters:\n    update_rate: 100\n    mine: {{type: {kind}}}\n", encoding="utf-8"
    )
    part = component("gz_ros2_control/GazeboSimSystem")
    named = plugin("gz_ros2_control-system", "gz_ros2_control::GazeboSimROS2ControlPlugin")
    named = named.replace("/opt/arm/controllers.yaml", "$(find arm)/arm.yaml")
    return of_family(robot, part + named, distro=distro, name="robot.xacro")


@pytest.mark.parametrize(
    ("kind", "distro", "told"),
    [
        ("velocity_controllers/JointGroupVelocityController", "humble", []),
        ("velocity_controllers/JointGroupVelocityController", "jazzy", ["info UC707"]),
        ("velocity_controllers/JointGroupVelocityController", "kilted", ["info UC707"]),
        ("velocity_controllers/JointGroupVelocityController", "lyrical", []),
        ("position_controllers/GripperActionController", "humble", []),
        ("position_controllers/GripperActionController", "jazzy", ["warning UC704"]),
        ("joint_state_broadcaster/JointStateBroadcaster", "jazzy", []),
    ],
)
def test_controllers_are_deprecated_or_end_by_distro(robot: Robot, kind: str, distro: str, told: list[str]) -> None:
    assert declared(robot, kind, distro) == told


def test_an_old_name_of_ignition_is_right_where_a_condition_chooses_between_both(robot: Robot) -> None:
    new = component("gz_ros2_control/GazeboSimSystem") + plugin(
        "gz_ros2_control-system", "gz_ros2_control::GazeboSimROS2ControlPlugin"
    )
    old = f'<xacro:if value="true">{IGNITION}</xacro:if>'
    chosen = f'{old}<xacro:unless value="true">{new}</xacro:unless>'
    both = ["warning UC702", "warning UC703"]
    for part, told in ((chosen, []), (old, both), (f"{old}<!--{new}-->", both)):
        found = [code for code in of_family(robot, part, name="robot.xacro", distro="humble") if "warning" in code]
        assert sorted(found) == told
