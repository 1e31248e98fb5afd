"""What nothing starts is less severe: a file that no robot uses, a folder of tests, an idle controller."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MASS = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
CRANE = f"""<robot name="crane" xmlns:xacro="http://www.ros.org/wiki/xacro">{{}}
  <link name="mast"/>
  <joint name="slew" type="continuous"><parent link="mast"/><child link="jib"/><axis xyz="0 0 1"{{}}/></joint>
  <link name="jib">{MASS}</link>
  {{}}
</robot>"""
HOOK = f"""<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <joint name="reel" type="continuous"><parent link="jib"/><child link="hook"/>
    <dynamics damping="1" stiffness="3"/></joint>
  <link name="hook">{MASS}</link>
</robot>"""
OPTIONAL = """<xacro:arg name="hook" default="false"/>
  <xacro:if value="$(arg hook)"><xacro:include filename="hook.xacro"/></xacro:if>"""


def severities(folder: Folder, code: str) -> list[tuple[str, str]]:
    """Return the file and severity of each finding of a rule."""
    report = folder.run("lint", ".", "--no-cache", "--distro=jazzy", "--select", code, "--format", "json").stdout
    return [(finding["file"], finding["severity"]) for finding in json.loads(report)["findings"]]


def test_a_warning_in_a_file_that_no_robot_uses_is_info(folder: Folder) -> None:
    folder.write({"crane.urdf.xacro": CRANE.format("", "", ""), "hook.xacro": HOOK})
    assert severities(folder, "UC163") == [("hook.xacro", "info")]


def test_a_file_that_a_robot_includes_under_a_condition_is_in_use(folder: Folder) -> None:
    folder.write({"crane.urdf.xacro": CRANE.format(OPTIONAL, "", ""), "hook.xacro": HOOK})
    assert severities(folder, "UC163") == [("hook.xacro", "warning")]


def test_a_file_that_is_included_by_one_under_a_condition_is_in_use_too(folder: Folder) -> None:
    outer = HOOK.replace("<joint", '<xacro:include filename="inner.xacro"/><joint').replace(' stiffness="3"', "")
    folder.write({"crane.urdf.xacro": CRANE.format(OPTIONAL, "", ""), "hook.xacro": outer, "inner.xacro": HOOK})
    assert severities(folder, "UC163") == [("inner.xacro", "warning")]


BOX = """<robot name="box">
  <link name="cabinet"/>
  <joint name="bolts" type="fixed"><parent link="{}"/><child link="cabinet"/></joint>
</robot>"""


def test_a_plain_urdf_of_which_all_links_hang_on_others_is_a_part_beside_a_robot(folder: Folder) -> None:
    folder.write({"crane.urdf.xacro": CRANE.format("", "", ""), "box.urdf": BOX.format("mast")})
    assert severities(folder, "UC116") == []
    assert "1 file not used by any robot: box.urdf" in folder.run("lint", ".").stdout


def test_a_robot_with_a_root_link_and_a_wrong_parent_is_no_part(folder: Folder) -> None:
    broken = CRANE.format("", "", "").replace('<parent link="mast"/>', '<parent link="must"/>')
    folder.write({"crane.urdf.xacro": CRANE.format("", "", ""), "other.urdf": broken})
    assert severities(folder, "UC116") == [("other.urdf", "error")]


def test_a_part_alone_is_checked_as_the_robot_that_it_should_be(folder: Folder) -> None:
    folder.write({"box.urdf": BOX.format("mast")})
    assert severities(folder, "UC116") == [("box.urdf", "error")]


def test_where_there_is_no_robot_parts_keep_their_severity(folder: Folder) -> None:
    folder.write({"hook.xacro": HOOK.replace("<robot", '<robot name="hook"')})
    assert severities(folder, "UC163") == [("hook.xacro", "warning")]


@pytest.mark.parametrize(
    ("place", "severity"),
    [
        ("urdf/crane.urdf", "warning"),
        ("test/crane.urdf", "info"),
        ("urdf_backup/crane.urdf", "info"),
        ("crane-templates/crane.urdf", "info"),
        ("crane_template/crane.urdf", "warning"),
        ("backup_crane/crane.urdf", "warning"),
    ],
)
def test_a_warning_in_a_folder_of_tests_backups_or_templates_is_info(folder: Folder, place: str, severity: str) -> None:
    folder.write({place: CRANE.format("", ' wobble="3"', "")})
    assert severities(folder, "UC163") == [(place, severity)]


def test_an_error_in_a_file_that_no_robot_uses_is_a_warning(folder: Folder) -> None:
    folder.write({"crane.urdf.xacro": CRANE.format("", "", ""), "hook.xacro": HOOK.replace("continuous", "turning")})
    assert severities(folder, "UC121") == [("hook.xacro", "warning")]


CONTROL = """<ros2_control name="crane" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="slew"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>"""
CONTROLLERS = """
controller_manager:
  ros__parameters:
    update_rate: 100
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
    tip: {type: range_sensor_broadcaster/RangeSensorBroadcaster}
tip:
  ros__parameters:
    {sensor_name: tip, frame_id: boom, radiation_type: 1, field_of_view: 0.1, min_range: 0.1, max_range: 2.0}
"""
BRINGUP = """<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share crane)/crane.urdf')" type="str"/></node>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(find-pkg-share crane)/controllers.yaml"/></node>
  <node pkg="controller_manager" exec="spawner" args="{}"/>
</launch>"""
MANIFEST = "<package format='3'><name>crane</name><export><build_type>ament_cmake</build_type></export></package>"


@pytest.mark.parametrize(("spawned", "severity"), [("states tip", "warning"), ("states", "info")])
def test_a_warning_on_a_controller_that_is_not_spawned_is_info(folder: Folder, spawned: str, severity: str) -> None:
    folder.write({"crane.urdf": CRANE.format("", "", CONTROL), "controllers.yaml": CONTROLLERS})
    folder.write({"package.xml": MANIFEST, "launch/crane.launch.xml": BRINGUP.format(spawned)})
    assert severities(folder, "UC473") == [("controllers.yaml", severity)]


OF_PID = CONTROL.replace('name="position"/>', 'name="position_pid"/>', 1).replace(
    "mock_components/GenericSystem", "gazebo_ros2_control/GazeboSystem"
)
POSITION = """
controller_manager:
  ros__parameters:
    update_rate: 100
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
    turn: {type: position_controllers/JointGroupPositionController}
turn:
  ros__parameters: {joints: [slew]}
"""


def test_an_interface_that_only_older_distros_lack_is_info(folder: Folder) -> None:
    plugin = '<gazebo><plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control"/></gazebo>'
    folder.write({"crane.urdf": CRANE.format("", "", OF_PID + plugin), "controllers.yaml": POSITION})
    given = folder.run("lint", "crane.urdf", "controllers.yaml", "--select", "UC450", "--format", "json").stdout
    [finding] = json.loads(given)["findings"]
    assert finding["severity"] == "info"
    assert "applies to foxy, galactic" in [note["message"] for note in finding["notes"]]
    older = folder.run("lint", "crane.urdf", "controllers.yaml", "--select", "UC450", "--distro=galactic").stdout
    assert "error UC450" in older


OLD_PLUGIN = """<transmission name="slew_trans"><type>transmission_interface/SimpleTransmission</type>
    <joint name="slew"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
    <actuator name="motor"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>
  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>"""
OLD_START = """<launch>
  <param name="robot_description" textfile="$(find crane)/crane.urdf"/>
  {}
  <rosparam file="$(find crane)/turn.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="turn"/>
</launch>"""
DRIVER = '<node name="crane" pkg="crane_driver" type="crane_node"/>'
GAZEBO = """<include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <node name="model" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model crane"/>"""


@pytest.mark.parametrize(("started", "severity"), [(DRIVER, "warning"), (GAZEBO, "error")])
def test_joints_that_a_driver_of_ros1_names_itself_are_not_certainly_wrong(
    folder: Folder, started: str, severity: str
) -> None:
    turn = "turn: {type: effort_controllers/JointGroupEffortController, joints: [axis_0, axis_1]}"
    folder.write({"crane.urdf": CRANE.format("", "", OLD_PLUGIN), "turn.yaml": turn})
    folder.write({"package.xml": "<package><name>crane</name></package>"})
    folder.write({"launch/crane.launch": OLD_START.format(started)})
    given = folder.run("lint", ".", "--no-cache", "--distro=noetic", "--select=UC440", "--format=json").stdout
    assert [finding["severity"] for finding in json.loads(given)["findings"]] == [severity]


@pytest.mark.parametrize(
    ("kind", "severity"),
    [
        ("effort_controllers/JointTrajectoryController", "error"),
        ("effort_controllers/JointGroupPositionController", "error"),
        ("effort_controllers/JointGroupEffortController", "warning"),
    ],
)
def test_a_controller_that_looks_its_joints_up_in_the_description_fails_whatever_the_driver_has(
    kind: str, severity: str, folder: Folder
) -> None:
    folder.write(
        {"crane.urdf": CRANE.format("", "", OLD_PLUGIN), "package.xml": "<package><name>crane</name></package>"}
    )
    folder.write({"turn.yaml": f"turn: {{type: {kind}, joints: [slew, axis_1]}}"})
    folder.write({"launch/crane.launch": OLD_START.format(DRIVER)})
    given = folder.run("lint", ".", "--no-cache", "--distro=noetic", "--select=UC440", "--format=json").stdout
    assert [finding["severity"] for finding in json.loads(given)["findings"]] == [severity]


def test_the_namespace_of_a_plugin_does_not_matter_where_a_driver_runs_the_controllers(folder: Folder) -> None:
    plugin = OLD_PLUGIN.replace('.so"/>', '.so"><robotNamespace>/crane</robotNamespace></plugin>')
    folder.write({"crane.urdf": CRANE.format("", "", plugin), "package.xml": "<package><name>crane</name></package>"})
    folder.write({"turn.yaml": "turn: {type: effort_controllers/JointEffortController, joint: slew}"})
    for started, expected in ((DRIVER, ""), (GAZEBO, "UC525")):
        folder.write({"launch/crane.launch": OLD_START.format(started)})
        told = folder.run("lint", ".", "--no-cache", "--distro=noetic", "--select=UC525", "--format=concise").stdout
        assert expected in told if expected else "UC525" not in told
