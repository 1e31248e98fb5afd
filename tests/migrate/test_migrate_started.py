"""What a migrated launch file of ROS 1 starts: the robot at its place, its publisher, and the bridge."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import EFFORT, PLUGIN, arm, migrated, transmission

from urdfctl.migrate.ros1.pausing import DECIDED

CONTROLLERS = """\
joint_state_controller:
  type: joint_state_controller/JointStateController
  publish_rate: 50
ctl:
  type: effort_controllers/JointEffortController
  joint: shoulder
"""
SPAWNED = """\
<launch>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/urdf/arm.xacro"/>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm
    -robot_namespace $(arg space) -x 1 -J shoulder 0.5 -J $(arg joint) 1"/>
  <node name="rsp" pkg="robot_state_publisher" type="robot_state_publisher">
    <param name="publish_frequency" value="50"/>
    <param name="tf_prefix" value="left"/>
    <param name="use_tf_static" value="false"/>
  </node>
</launch>
"""
STATES_AND_EFFORT = """\
states:
  type: joint_state_controller/JointStateController
ctl:
  type: effort_controllers/JointEffortController
  joint: shoulder
"""


def test_a_robot_starts_where_the_spawner_put_it(folder: Folder) -> None:
    robot = arm(transmission("EffortJointInterface"), PLUGIN)
    after = migrated(folder, {"urdf/arm.xacro": robot, "launch/arm.launch": SPAWNED})
    state = """\
      <state_interface name="position">
        <param name="initial_value">0.5</param>
      </state_interface>
"""
    assert state in after["urdf/arm.xacro"]
    text = " ".join(after["launch/arm.launch.py"].split())
    assert '"-topic", "robot_description", "-name", "arm", "-x", "1"' in text
    assert "space" not in text
    assert "TODO(urdfctl): joint positions at the start" in text


def test_robot_state_publisher_gets_the_parameters_of_ros_2(folder: Folder) -> None:
    robot = arm(transmission("EffortJointInterface"), PLUGIN)
    text = migrated(folder, {"urdf/arm.xacro": robot, "launch/arm.launch": SPAWNED})["launch/arm.launch.py"]
    assert '"publish_frequency": 50' in text
    assert '"frame_prefix": "left/"' in text
    empty = SPAWNED.replace('value="left"', 'value=""')
    files = {"urdf/arm.xacro": robot, "launch/arm.launch": empty}
    assert "frame_prefix" not in migrated(folder, files)["launch/arm.launch.py"]
    assert "use_tf_static" not in text


def test_a_file_that_the_spawner_reads_is_given_to_it_with_the_names_of_its_controllers(
    folder: Folder,
) -> None:
    spawner = '<node name="s" pkg="controller_manager" type="spawner" ns="arm" args="$(find arm)/config/all.yaml"/>'
    robot = arm(transmission("EffortJointInterface"), PLUGIN)
    launch = SPAWNED.replace("</launch>", f"  {spawner}\n</launch>")
    files = {"urdf/arm.xacro": robot, "launch/arm.launch": launch, "config/all.yaml": STATES_AND_EFFORT}
    text = " ".join(migrated(folder, files)["launch/arm.launch.py"].split())
    file = '[FindPackageShare("arm"), "/config/all.yaml"]'
    assert f'arguments=[ "states", "ctl", "-c", "arm/controller_manager", "--param-file", {file}, ]' in text


def test_the_bridge_of_the_robots_topics_is_started(folder: Folder) -> None:
    plugin = '<plugin name="imu" filename="libgazebo_ros_imu_sensor.so"><topicName>imu</topicName></plugin>'
    imu = f'<gazebo reference="upper"><sensor name="imu" type="imu">{plugin}</sensor></gazebo>\n'
    robot = arm(transmission("EffortJointInterface"), PLUGIN + imu)
    after = migrated(folder, {"urdf/arm.xacro": robot, "launch/arm.launch": SPAWNED})
    assert "- ros_topic_name: imu\n" in after["config/bridge.yaml"]
    assert '"config_file": [FindPackageShare("arm"), "/config/bridge.yaml"]' in after["launch/arm.launch.py"]


WORLD_OF_ANOTHER = """\
<launch>
  <include file="$(find room)/launch/room.launch"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/urdf/arm.xacro"/>
  <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
</launch>
"""
ROOM = '<launch><include file="$(find gazebo_ros)/launch/empty_world.launch"/></launch>\n'


def in_a_room(folder: Folder, launch: str) -> dict[str, str]:
    """A robot with a sensor, another robot, and the package with their world, after their migration."""
    manifest = "<package format='2'><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
    plugin = '<plugin name="imu" filename="libgazebo_ros_imu_sensor.so"><topicName>imu</topicName></plugin>'
    imu = f'<gazebo reference="upper"><sensor name="imu" type="imu">{plugin}</sensor></gazebo>\n'
    robot = arm(transmission("EffortJointInterface"), PLUGIN + imu)
    others = {"room/launch/room.launch": ROOM, "leg/urdf/leg.xacro": robot.replace('name="arm"', 'name="leg"')}
    manifests = {f"{name}/package.xml": manifest.format(name) for name in ("arm", "room", "leg")}
    folder.write({**others, **manifests, "arm/urdf/arm.xacro": robot, "arm/launch/arm.launch": launch})
    ran = folder.run("migrate", ".", "--from", "noetic", "--to", "jazzy", "--in-place", "--force")
    assert ran.returncode == 0, ran.stderr
    return {name: (folder.path / name).read_text() for name in ("room/launch/room.launch.py", "MIGRATION.md")}


def test_a_world_bridges_the_topics_of_the_robot_whose_launch_file_includes_it(folder: Folder) -> None:
    after = in_a_room(folder, WORLD_OF_ANOTHER)
    assert '[FindPackageShare("arm"), "/config/bridge.yaml"]' in after["room/launch/room.launch.py"]
    told = after["MIGRATION.md"].partition("no launch file starts a bridge with this file")[0].splitlines()[-1]
    assert told.startswith("- `leg/config/bridge.yaml`")


def test_a_robot_whose_topics_no_launch_file_bridges_is_told(folder: Folder) -> None:
    after = in_a_room(folder, WORLD_OF_ANOTHER.replace('<include file="$(find room)/launch/room.launch"/>', ""))
    assert "/clock@rosgraph_msgs" in after["room/launch/room.launch.py"]
    told = after["MIGRATION.md"].partition("no launch file starts a bridge with this file")[2]
    assert "  - `arm/config/bridge.yaml`\n  - `leg/config/bridge.yaml`\n" in told


@pytest.mark.parametrize("form", ["py", "xml"])
def test_a_shell_splits_the_names_that_an_argument_has_for_a_spawner(folder: Folder, form: str) -> None:
    spawner = """\
  <arg name="names" default="joint_state_controller ctl"/>
  <rosparam file="$(find arm)/config/c.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="$(arg names)"/>
</launch>
"""
    launch = SPAWNED.replace("</launch>\n", spawner)
    robot = arm(transmission("EffortJointInterface"), PLUGIN.replace("/arm", "/"))
    files = {"urdf/arm.xacro": robot, "config/c.yaml": CONTROLLERS}
    after = migrated(folder, {**files, "launch/arm.launch": launch}, "--launch", form)
    text = after[f"launch/arm.launch.{form}"]
    assert ("shell=True" if form == "py" else 'shell="true"') in text
    assert "word of its own" not in text
    folder.write({f"new/{name}": content for name, content in after.items()})
    shown = folder.run("show", "new", "--distro", "jazzy").stdout
    assert "joint_state_controller, ctl" in shown


def test_a_controller_file_that_an_argument_chooses_is_passed_to_its_spawner(folder: Folder) -> None:
    launch = """\
<launch>
  <arg name="file" default="$(find arm)/config/controllers.yaml"/>
  <group ns="arm">
    <rosparam file="$(arg file)"/>
    <node pkg="controller_manager" type="spawner" name="spawner" args="ctl"/>
  </group>
</launch>
"""
    files = {"urdf/arm.xacro": arm(transmission("EffortJointInterface"), PLUGIN), "config/controllers.yaml": EFFORT}
    after = migrated(folder, {**files, "launch/arm.launch": launch})
    assert '"ctl", "--param-file", LaunchConfiguration("file")' in " ".join(after["launch/arm.launch.py"].split())
    assert "$(arg file)" not in after["MIGRATION.md"]


def test_the_default_of_an_argument_that_is_a_launch_file_is_the_migrated_one(folder: Folder) -> None:
    launch = """\
<launch>
  <arg name="robot" default="$(dirname)/inc/load.launch.xml"/>
  <include file="$(arg robot)"/>
</launch>
"""
    files = {"launch/arm.launch": launch, "launch/inc/load.launch.xml": '<launch>\n  <arg name="a"/>\n</launch>\n'}
    after = migrated(folder, files)
    assert "launch/inc/load.launch.py" in after
    assert '[ThisLaunchFileDir(), "/inc/load.launch.py"]' in " ".join(after["launch/arm.launch.py"].split())


@pytest.mark.parametrize(("given", "more"), [("$(arg p)", "-unpause"), ("true", "-unpause"), ("$(arg p)", "")])
def test_a_simulation_that_the_spawner_lets_run_is_not_paused(folder: Folder, given: str, more: str) -> None:
    robot = arm(transmission("EffortJointInterface"), PLUGIN)
    include = '<include file="$(find gazebo_ros)/launch/empty_world.launch">'
    launch = SPAWNED.replace(f"{include[:-1]}/>", f'{include}<arg name="paused" value="{given}"/></include>')
    launch = launch.replace("<launch>", '<launch>\n  <arg name="p" default="true"/>').replace("-x 1", f"{more} -x 1")
    after = migrated(folder, {"urdf/arm.xacro": robot, "launch/arm.launch": launch})
    is_kept = not more
    assert (DECIDED in after["MIGRATION.md"]) is not is_kept
    text = after["launch/arm.launch.py"]
    assert ('DeclareLaunchArgument("p", default_value="true")' in text) is (is_kept or given == "true")
    assert is_kept or '"gz_args": "-r empty.sdf"' in text or 'default_value="false"' in text


def test_a_file_that_only_names_an_action_of_a_controller_is_none_of_its_spawner(folder: Folder) -> None:
    launch = """\
<launch>
  <rosparam file="$(find arm)/config/controllers.yaml" ns="arm"/>
  <rosparam file="$(find arm)/config/script.yaml" ns="script_server"/>
  <node pkg="controller_manager" type="spawner" name="spawner" ns="arm" args="ctl"/>
</launch>
"""
    script = "action_name: /arm_controller/follow_joint_trajectory\n"
    files = {"config/controllers.yaml": EFFORT, "config/script.yaml": script, "launch/arm.launch": launch}
    after = migrated(folder, {"urdf/arm.xacro": arm(transmission("EffortJointInterface"), PLUGIN), **files})
    assert "controllers.yaml" in after["launch/arm.launch.py"]
    assert "script.yaml" not in after["launch/arm.launch.py"].partition("def ")[2]


DRIVEN = """\
<robot name="base">
  <link name="b"/>
  <link name="l"/>
  <link name="r"/>
  <joint name="lj" type="continuous"><parent link="b"/><child link="l"/></joint>
  <joint name="rj" type="continuous"><parent link="b"/><child link="r"/></joint>
  <gazebo>
    <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
      <leftJoint>lj</leftJoint>
      <rightJoint>rj</rightJoint>
    </plugin>
  </gazebo>
</robot>
"""


@pytest.mark.parametrize(
    ("words", "started"),
    [
        ([], ("gz_sim.launch.py", "parameter_bridge", "create")),
        (["--simulator", "gazebo-classic", "--to", "humble"], ("gazebo.launch.py", "spawn_entity.py")),
        (["--simulator", "none"], ()),
    ],
)
def test_a_robot_without_controllers_starts_in_the_simulator_as_before(
    folder: Folder, words: list[str], started: tuple[str, ...]
) -> None:
    text = migrated(folder, {"urdf/arm.xacro": DRIVEN, "launch/arm.launch": SPAWNED}, *words)["launch/arm.launch.py"]
    programs = ("gz_sim.launch.py", "gazebo.launch.py", "parameter_bridge", "create", "spawn_entity.py")
    assert tuple(name for name in programs if f'{name}"' in text) == started
    assert "robot_state_publisher" in text


ELSEWHERE = """\
<launch>
  <arg name="side" default="left"/>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find vendor_description)/arm.urdf.xacro"/>
  <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
  <rosparam file="$(find arm)/config/c.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="$(arg side)/ctl"/>
</launch>
"""


def test_a_description_that_xacro_wrote_is_one_for_xacro_again(folder: Folder) -> None:
    written = "<!-- |    This document was autogenerated by xacro from arm.xacro            | -->\n"
    robot = written + arm(transmission("EffortJointInterface"), PLUGIN.replace("/arm", "/"))
    spawner = ELSEWHERE.replace("vendor_description)", "arm)/urdf").replace("arm.urdf.xacro", "arm.urdf")
    after = migrated(folder, {"urdf/arm.urdf": robot, "config/c.yaml": CONTROLLERS, "launch/arm.launch": spawner})
    assert after["urdf/arm.urdf"].count("xmlns:xacro") == 1
    assert "<parameters>$(find arm)/config/c.yaml</parameters>" in after["urdf/arm.urdf"]


def test_a_plugin_that_switches_interfaces_is_that_of_ros2_control(folder: Folder) -> None:
    plugin = PLUGIN.replace("libgazebo", "libhwi_switch_gazebo").replace("/arm", "/")
    robot = arm(
        transmission("EffortJointInterface"),
        plugin.replace("<robotSim", "<filterJointsParam>a</filterJointsParam><robotSim"),
    )
    spawner = ELSEWHERE.replace("vendor_description)", "arm)/urdf").replace("arm.urdf.xacro", "arm.xacro")
    after = migrated(folder, {"urdf/arm.xacro": robot, "config/c.yaml": CONTROLLERS, "launch/arm.launch": spawner})
    assert 'filename="gz_ros2_control-system"' in after["urdf/arm.xacro"]
    assert "<parameters>$(find arm)/config/c.yaml</parameters>" in after["urdf/arm.xacro"]
    assert "filterJointsParam" not in after["urdf/arm.xacro"]
    assert "built for Gazebo Classic" not in after["MIGRATION.md"]


def test_a_robot_of_another_package_in_gazebo_has_its_manager_there(folder: Folder) -> None:
    files = {"launch/arm.launch": ELSEWHERE, "config/c.yaml": CONTROLLERS}
    text = " ".join(migrated(folder, files, "--simulator", "gz")["launch/arm.launch.py"].split())
    assert "ros2_control_node" not in text
    assert "let the plugin of gz in it load '$(find arm)/config/c.yaml' by <parameters>" in text
    assert 'executable="spawner", arguments=["ctl", "--param-file",' in text
    robot = {"urdf/arm.xacro": arm(transmission("EffortJointInterface"))}  # it is for real hardware
    text = migrated(folder, files | robot, "--simulator", "gz")["launch/arm.launch.py"]
    assert 'executable="ros2_control_node"' in text
