"""Rules on simulator plugins, by distro and simulator; their examples test the rest."""

from __future__ import annotations

import pytest
from robots import Robot, notes

FILE = "<parameters>/opt/arm/controllers.yaml</parameters>"
GZ = f"""
<gazebo>
  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">{FILE}</plugin>
</gazebo>
"""
IGN = f"""
<gazebo>
  <plugin filename="ign_ros2_control-system" name="ign_ros2_control::IgnitionROS2ControlPlugin">{FILE}</plugin>
</gazebo>
"""
CLASSIC = f"""
<gazebo>
  <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">{FILE}</plugin>
</gazebo>
"""
IN_GZ = "gz_ros2_control/GazeboSimSystem"
IN_IGN = "ign_ros2_control/IgnitionSystem"
IN_CLASSIC = "gazebo_ros2_control/GazeboSystem"
MOCK = "mock_components/GenericSystem"


def component(hardware: str) -> str:
    return f"""
    <ros2_control name="arm" type="system">
      <hardware><plugin>{hardware}</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
    """


def plugin(inside: str = "", filename: str = "libgazebo_ros_control.so", name: str = "control") -> str:
    return f'<gazebo><plugin name="{name}" filename="{filename}">{inside}</plugin></gazebo>'


def drive(inside: str = "", left: str = "shoulder", right: str = "elbow") -> str:
    joints = f"<leftJoint>{left}</leftJoint><rightJoint>{right}</rightJoint>"
    wheels = "<wheelSeparation>0.3</wheelSeparation><wheelDiameter>0.1</wheelDiameter>"
    return plugin(joints + wheels + inside, "libgazebo_ros_diff_drive.so")


# -- which plugin belongs to which hardware, distro and simulator ------------------------------------------------------


@pytest.mark.parametrize(
    ("hardware", "loads", "distro"),
    [
        (IN_CLASSIC, CLASSIC, "foxy"),
        (IN_CLASSIC, CLASSIC, "galactic"),
        (IN_IGN, IGN, "galactic"),
        (IN_GZ, GZ, "humble"),
        (IN_GZ, GZ, "jazzy"),
        (IN_GZ, GZ, "rolling"),
    ],
)
def test_hardware_with_the_plugin_of_its_simulator_is_accepted(
    robot: Robot, hardware: str, loads: str, distro: str
) -> None:
    assert robot.says(component(hardware) + loads, distro=distro) == []


@pytest.mark.parametrize(("hardware", "loads"), [(IN_CLASSIC, GZ), (IN_GZ, CLASSIC), (IN_CLASSIC, IGN)])
def test_hardware_of_another_simulator_than_its_plugin_is_rejected(robot: Robot, hardware: str, loads: str) -> None:
    found = robot.only("UC506", component(hardware) + loads)
    assert found.severity.value == "error"
    assert f"'{hardware}' is for" in found.message


def test_a_robot_may_load_the_plugins_of_both_simulators(robot: Robot) -> None:
    assert "error UC506" not in robot.says(component(IN_GZ) + CLASSIC + GZ)


def test_the_old_and_the_new_names_of_gz_go_together(robot: Robot) -> None:
    for hardware, loads in ((IN_IGN, GZ), (IN_GZ, IGN)):
        assert not [code for code in robot.says(component(hardware) + loads, distro="humble") if "error" in code]


def test_mock_hardware_in_gazebo_is_an_error_only_where_the_simulator_is_named(robot: Robot) -> None:
    part = component(MOCK) + GZ
    assert robot.only("UC507", part, simulator="gz").severity.value == "error"
    assert robot.only("UC507", part).severity.value == "warning"
    assert robot.only("UC507", part, name="robot.xacro").severity.value == "info"


def test_hardware_that_conditions_choose_is_not_judged_until_the_simulator_is_named(robot: Robot) -> None:
    chosen = component(f'<xacro:if value="true">{MOCK}</xacro:if>') + GZ
    chosen = chosen.replace("<plugin><xacro:if", "<xacro:if").replace("</xacro:if></plugin>", "</xacro:if>")
    chosen = chosen.replace(MOCK, f"<plugin>{MOCK}</plugin>")
    assert robot.says(chosen, name="robot.xacro") == []
    assert robot.says(chosen, name="robot.xacro", simulator="gz") == ["error UC507"]


def test_plugins_of_gazebo_are_not_judged_where_another_simulator_is_named(robot: Robot) -> None:
    broken = plugin("<jointName>x</jointName>", "libgazebo_ros_diff_drive.so")
    assert robot.says(broken, simulator="mujoco") == []
    assert robot.says(broken, simulator="none") == []


def test_a_plugin_of_ros_1_in_ros_2_is_reported_with_its_replacement(robot: Robot) -> None:
    found = robot.only("UC504", component(IN_CLASSIC) + plugin(), distro="humble")
    assert found.severity.value == "error"
    assert found.message == "'libgazebo_ros_control.so' is not available in humble, only in ROS 1"
    assert robot.fixed(found).count("libgazebo_ros2_control.so") == 1
    assert "<ros><namespace>" in notes(found)


def test_the_four_wheels_of_ros_1_are_two_pairs_in_ros_2(robot: Robot) -> None:
    found = robot.only("UC504", plugin(filename="libgazebo_ros_skid_steer_drive.so"), distro="humble")
    assert found.severity.value == "error"
    assert "<num_wheel_pairs>2</num_wheel_pairs>" in notes(found)


def test_a_sensor_of_the_other_ros_is_a_warning(robot: Robot) -> None:
    sensor = """
    <gazebo reference="fore">
      <sensor type="ray" name="scan"><plugin name="scan" filename="libgazebo_ros_laser.so"/></sensor>
    </gazebo>
    """
    found = robot.only("UC504", sensor, distro="humble")
    assert found.severity.value == "warning"
    assert "libgazebo_ros_ray_sensor.so" in robot.fixed(found)
    assert robot.says(sensor, distro="noetic") == []


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("libgazebo_ros_control", "libgazebo_ros_control.so"),
        ("gazebo_ros_diff_drive.so", "libgazebo_ros_diff_drive.so"),
        ("libgazebo_ros_contol.so", "libgazebo_ros_control.so"),
        ("gz-ros2-control-system", "gz_ros2_control-system"),
        ("gz_ros2_control-sytem", "gz_ros2_control-system"),
    ],
)
def test_a_misspelt_file_is_reported(robot: Robot, written: str, meant: str) -> None:
    assert f"did you mean '{meant}'?" in robot.only("UC503", plugin(filename=written)).message


def test_a_plugin_of_ros_1_stops_no_robot_whose_hardware_is_mocked(robot: Robot) -> None:
    assert robot.only("UC504", component(MOCK) + plugin(), distro="humble").severity.value == "warning"


def test_a_misspelt_library_of_the_other_ros_is_reported_once_with_what_to_load(robot: Robot) -> None:
    found = robot.only("UC504", component(IN_CLASSIC) + plugin(filename="gazebo_ros_control.so"), distro="humble")
    assert "libgazebo_ros2_control.so" in robot.fixed(found)


def test_a_misspelt_plugin_that_moves_the_robot_is_an_error(robot: Robot) -> None:
    assert robot.only("UC503", plugin(filename="libgazebo_ros_contol.so")).severity.value == "error"
    assert robot.only("UC503", plugin(filename="libgazebo_ros_camra.so")).severity.value == "warning"


@pytest.mark.parametrize(
    "filename",
    [
        "libgazebo_ros_camera2.so",
        "libmy_gazebo_ros_control.so",
        "libbaxter_gazebo_ros_control.so",
        "/opt/lib/libgazebo_ros_contol.so",
        "dummyfile",
    ],
)
def test_an_unknown_library_is_not_reported(robot: Robot, filename: str) -> None:
    assert robot.says(plugin("<anything>1</anything>", filename)) == []


def test_the_name_of_a_gz_plugin_is_a_class_and_that_of_a_classic_plugin_is_free(robot: Robot) -> None:
    free = GZ.replace("gz_ros2_control::GazeboSimROS2ControlPlugin", "control")
    assert "error UC505" in robot.says(component(IN_GZ) + free)
    assert robot.says(component(IN_CLASSIC) + CLASSIC.replace('name="gazebo_ros2_control"', 'name="any"')) == []


def test_a_class_of_gz_may_contain_the_version_of_its_library(robot: Robot) -> None:
    part = plugin("", "gz-sim-joint-state-publisher-system", "gz::sim::v8::systems::JointStatePublisher")
    assert robot.says(part, distro="jazzy") == []


def test_a_leftover_of_ros_1_beside_the_plugin_of_ros_2_is_a_warning(robot: Robot) -> None:
    assert robot.only("UC504", component(IN_CLASSIC) + CLASSIC + plugin(), distro="foxy").severity.value == "warning"


def test_the_libraries_of_gz_are_known_with_and_without_lib(robot: Robot) -> None:
    for filename in ("libgz_ros2_control-system", "libgz_ros2_control-system.so"):
        assert robot.says(component(IN_GZ) + GZ.replace("gz_ros2_control-system", filename), distro="jazzy") == []


def test_two_plugins_for_control_need_two_namespaces(robot: Robot) -> None:
    here = "<robotNamespace>/left</robotNamespace>"
    assert robot.says(plugin(here) + plugin(here.replace("left", "right"))) == []
    assert robot.says(plugin(here) + plugin("<robotNamespace>left/</robotNamespace>")) == ["warning UC509"]


# -- settings ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("filename", "written", "shown", "distro"),
    [
        ("libgazebo_ros2_control.so", "robot_namespace", "<ros><namespace>x</namespace></ros>", "foxy"),
        ("libgazebo_ros_diff_drive.so", "robotBaseFrame", "<robot_base_frame>", "foxy"),
        ("libgazebo_ros_diff_drive.so", "commandTopic", "<ros><remapping>cmd_vel:=x</remapping></ros>", "foxy"),
        ("libgazebo_ros_diff_drive.so", "wheel_torque", "<wheelTorque>", "noetic"),
        ("libgazebo_ros_diff_drive.so", "torque", "<wheelTorque>", "noetic"),
        ("libgazebo_ros_control.so", "robotNamspace", "<robotNamespace>", "noetic"),
    ],
)
def test_a_misspelt_setting_is_reported_with_the_right_one(
    robot: Robot, filename: str, written: str, shown: str, distro: str
) -> None:
    part = component(IN_CLASSIC) if distro == "foxy" else ""
    found = robot.only("UC511", part + plugin(f"<{written}>x</{written}>", filename), distro=distro)
    assert found.message == f"'{filename}' has no setting <{written}>; use {shown}"


def test_the_fix_of_a_setting_renames_both_tags(robot: Robot) -> None:
    found = robot.only("UC511", drive("<update_rate>50</update_rate>"), distro="noetic")
    assert "<updateRate>50</updateRate>" in robot.fixed(found)


def test_an_ignored_setting_with_the_default_value_is_an_info(robot: Robot) -> None:
    assert robot.only("UC511", drive("<update_rate>100</update_rate>"), distro="noetic").severity.value == "info"
    assert robot.only("UC511", drive("<update_rate>50</update_rate>"), distro="noetic").severity.value == "warning"


def test_a_setting_that_moved_elsewhere_is_an_info(robot: Robot) -> None:
    part = component(IN_CLASSIC) + plugin(f"{FILE}<robot_sim_type>x</robot_sim_type>", "libgazebo_ros2_control.so")
    assert robot.only("UC511", part, distro="foxy").severity.value == "info"


def test_settings_are_judged_by_the_ros_version_that_most_of_them_fit(robot: Robot) -> None:
    ros2 = """
    <left_joint>shoulder</left_joint><right_joint>elbow</right_joint>
    <wheel_separation>0.3</wheel_separation><wheel_diameter>0.1</wheel_diameter>
    """
    assert robot.says(plugin(ros2, "libgazebo_ros_diff_drive.so")) == []
    assert robot.says(drive()) == []
    mixed = ros2.replace("wheel_diameter", "wheelDiameter")
    assert robot.says(plugin(mixed, "libgazebo_ros_diff_drive.so")) == ["warning UC511"]


@pytest.mark.parametrize(
    ("name", "value", "problem"),
    [
        ("updateRate", "", "is empty; it must be a number"),
        ("updateRate", "50 Hz", "must be a number, not '50 Hz'"),
        ("publishTf", "yes", "must be true or false, not 'yes'"),
        ("odometrySource", "wheels", "must be 'encoder' or 'world', not 'wheels'"),
    ],
)
def test_a_malformed_setting_is_reported(robot: Robot, name: str, value: str, problem: str) -> None:
    found = robot.only("UC514", drive(f"<{name}>{value}</{name}>"))
    assert found.message == f"<{name}> of 'libgazebo_ros_diff_drive.so' {problem}"


def test_a_setting_that_an_argument_leaves_empty_is_not_reported(robot: Robot) -> None:
    part = (
        '<xacro:arg name="file" default=""/>'
        + component(IN_GZ)
        + GZ.replace("/opt/arm/controllers.yaml", "$(arg file)")
    )
    assert robot.says(part, name="robot.xacro") == []


def test_without_a_file_gz_exits_and_classic_goes_on(robot: Robot) -> None:
    assert robot.only("UC513", component(IN_GZ) + GZ.replace(FILE, "")).severity.value == "error"
    assert robot.only("UC513", component(IN_CLASSIC) + CLASSIC.replace(FILE, "")).severity.value == "warning"


# -- joints and links --------------------------------------------------------------------------------------------------


def test_a_drive_without_its_joint_is_an_error(robot: Robot) -> None:
    found = robot.only("UC515", drive(right="elbo"))
    assert found.severity.value == "error"
    assert "did you mean 'elbow'?" in found.message


def test_the_default_joint_of_a_drive_must_exist_too(robot: Robot) -> None:
    part = drive().replace("<leftJoint>shoulder</leftJoint>", "")
    assert "no <leftJoint>, and the robot has no joint 'left_joint' (its default)" in robot.only("UC515", part).message


def test_a_fixed_joint_is_merged_away_unless_it_is_kept(robot: Robot) -> None:
    part = plugin("<jointName>mount</jointName>", "libgazebo_ros_joint_state_publisher.so")
    assert robot.says(part, distro="noetic") == ["info UC515"]
    kept = '<gazebo reference="mount"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    assert robot.says(part + kept, distro="noetic") == []


def test_joints_outside_a_part_of_a_robot_are_not_reported(robot: Robot) -> None:
    part = f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{drive(right="wheel")}</robot>'
    assert "error UC515" not in robot.says(part, name="drive.xacro")


def test_one_setting_may_list_several_joints(robot: Robot) -> None:
    part = plugin("<jointName>shoulder, elbow, wrist</jointName>", "libgazebo_ros_joint_state_publisher.so")
    assert "names joint 'wrist'" in robot.only("UC515", part, distro="noetic").message


def test_a_drive_and_ros2_control_must_not_move_the_same_joint(robot: Robot) -> None:
    both = """
    <gazebo>
      <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
        <left_joint>shoulder</left_joint>
        <right_joint>elbow</right_joint>
        <wheel_separation>0.3</wheel_separation>
        <wheel_radius>0.05</wheel_radius>
      </plugin>
    </gazebo>
    """
    found = robot.only("UC519", component(IN_GZ) + GZ + both)
    assert "is driven by 'gz-sim-diff-drive-system' and by component 'arm'" in found.message
    assert robot.says(component(MOCK) + both) == []


# -- files and namespaces ----------------------------------------------------------------------------------------------


def test_a_url_is_not_a_path_of_a_controllers_file(robot: Robot) -> None:
    part = component(IN_GZ) + GZ.replace("/opt/arm/controllers.yaml", "package://arm/controllers.yaml")
    assert robot.only("UC522", part).severity.value == "error"


@pytest.mark.parametrize("start", ["$HOME", "${HOME}", "~", "$(env HOME)"])
def test_only_a_shell_knows_the_home_folder(robot: Robot, start: str) -> None:
    part = component(IN_GZ) + GZ.replace("/opt/arm", f"{start}/ws/src/arm")
    severity = "warning" if start in {"${HOME}", "$(env HOME)"} else "error"  # xacro may expand these
    assert robot.only("UC521", part).severity.value == severity


def test_a_file_in_a_home_folder_is_on_one_machine(robot: Robot) -> None:
    part = component(IN_GZ) + GZ.replace("/opt/arm", "/home/me/ws/src/arm")
    assert robot.only("UC531", part).severity.value == "warning"


def test_a_file_that_an_argument_names_may_be_another(robot: Robot) -> None:
    (robot.folder / "package.xml").write_text("<package><name>arm</name></package>", encoding="utf-8")
    fixed = component(IN_GZ) + GZ.replace("/opt/arm/controllers.yaml", "$(find arm)/none.yaml")
    chosen = '<xacro:arg name="file" default="none"/>' + fixed.replace("none.yaml", "$(arg file).yaml")
    assert robot.only("UC520", fixed, name="robot.xacro").severity.value == "error"
    assert robot.only("UC520", chosen, name="robot.xacro").severity.value == "warning"


@pytest.mark.parametrize(
    ("key", "namespace", "reported"),
    [
        ("controller_manager", "", False),
        ("/**/controller_manager", "left", False),
        ("left/controller_manager", "/left/", False),
        ("/**", "left", False),
        ("controller_manager", "left", True),
        ("right/controller_manager", "left", True),
        ("right/controller_manager", "", True),
    ],
)
def test_the_section_of_the_manager_is_in_the_namespace_of_the_plugin(
    robot: Robot, key: str, namespace: str, reported: bool
) -> None:
    (robot.folder / "package.xml").write_text("<package><name>arm</name></package>", encoding="utf-8")
    (robot.folder / "arm.yaml").write_text(
        f"{key}:\n  ros__parameters:\n    update_rate: 100\n"
        "    states: {type: joint_state_broadcaster/JointStateBroadcaster}\n",
        encoding="utf-8",
    )
    ros = f"<ros><namespace>{namespace}</namespace></ros>" if namespace else ""
    part = component(IN_GZ) + GZ.replace(FILE, f"<parameters>$(find arm)/arm.yaml</parameters>{ros}")
    assert ("warning UC523" in robot.says(part, name="robot.xacro", distro="jazzy")) is reported


def test_a_misspelt_simulation_is_reported_and_an_unknown_one_is_not(robot: Robot) -> None:
    for written in ("DefaultRobotHWSim", "gazebo_ros_control/DefaultRobotHwSim", "gazebo_ros_control/DefaultRobotHWSm"):
        found = robot.only("UC526", plugin(f"<robotSimType>{written}</robotSimType>"))
        assert "did you mean 'gazebo_ros_control/DefaultRobotHWSim'?" in found.message
    assert robot.says(plugin("<robotSimType>my_robot/MySimulation</robotSimType>")) == []


def test_only_kinetic_reads_the_legacy_mode(robot: Robot) -> None:
    assert robot.says(plugin(), distro="kinetic") == ["warning UC527"]
    assert robot.says(plugin(), distro="noetic") == []
    assert robot.says(plugin()) == []
    assert robot.says(plugin("<robotSimType>my_robot/Mine</robotSimType>"), distro="kinetic") == []


@pytest.mark.parametrize(("period", "reported"), [("0.002", False), ("0", True), ("-0.01", True), ("100", True)])
def test_a_period_is_positive_and_not_a_rate(robot: Robot, period: str, reported: bool) -> None:
    assert ("warning UC528" in robot.says(plugin(f"<controlPeriod>{period}</controlPeriod>"))) is reported
