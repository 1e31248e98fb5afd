"""What a migration from Gazebo Classic to gz makes of plugins, sensors, materials, launch files and dependencies."""

from __future__ import annotations

import pytest
import yaml
from classic_packages import CONTROL, CONTROLLERS, DRIVE, MANIFEST, base, migrated
from folder import Folder

LIDAR = """\
  <gazebo reference="body">
    <sensor name="lidar" type="ray">
      <ray>
        <range><min>0.1</min><max>10</max></range>
      </ray>
      <plugin name="scan" filename="libgazebo_ros_ray_sensor.so">
        <output_type>sensor_msgs/LaserScan</output_type>
        <ros>
          <namespace>/front</namespace>
          <remapping>~/out:=scan</remapping>
        </ros>
        <frame_name>body</frame_name>
      </plugin>
    </sensor>
    <material>Gazebo/Orange</material>
  </gazebo>
"""
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    # the simulator
    gazebo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource([FindPackageShare("gazebo_ros"), "/launch/gazebo.launch.py"]),
        launch_arguments={"world": "my.world", "verbose": "true"}.items(),
    )
    topic = ["-topic", "robot_description"]
    spawn = Node(package="gazebo_ros", executable="spawn_entity.py", arguments=[*topic, "-entity", "base"])
    return LaunchDescription([gazebo, spawn])
"""


def test_a_drive_becomes_a_system_with_radius_and_topics(folder: Folder) -> None:
    after = migrated(folder, {"urdf/base.xacro": base(DRIVE)})["urdf/base.xacro"]
    assert (
        """\
    <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
      <left_joint>left</left_joint>
      <right_joint>right</right_joint>
      <wheel_separation>0.4</wheel_separation>
      <wheel_radius>0.1</wheel_radius>
      <child_frame_id>body</child_frame_id>
      <topic>cmd_vel</topic>
      <odom_topic>wheels/odom</odom_topic>
    </plugin>
"""
        in after
    )


def test_a_lidar_gets_its_type_topic_and_frame_and_loses_its_plugin(folder: Folder) -> None:
    after = migrated(folder, {"urdf/base.xacro": base(LIDAR)})["urdf/base.xacro"]
    for part in (
        '<sensor name="lidar" type="gpu_lidar">',
        "<lidar>\n        <range><min>0.1</min><max>10</max></range>\n      </lidar>",
        "<topic>front/scan</topic>",
        "<gz_frame_id>body</gz_frame_id>",
        "<diffuse>1 0.5088 0.0468 1</diffuse>",
    ):
        assert part in after
    assert "libgazebo" not in after
    assert "Gazebo/Orange" not in after


def test_a_plugin_that_is_a_sensor_itself_becomes_one_on_its_link(folder: Folder) -> None:
    imu = """\
  <gazebo>
    <plugin name="imu" filename="libhector_gazebo_ros_imu.so">
      <updateRate>100</updateRate>
      <bodyName>body</bodyName>
      <topicName>imu/data</topicName>
    </plugin>
  </gazebo>
"""
    after = migrated(folder, {"urdf/base.xacro": base(imu)})["urdf/base.xacro"]
    assert (
        """\
  <gazebo reference="body">
    <sensor name="imu" type="imu">
      <update_rate>100</update_rate>
      <always_on>true</always_on>
      <topic>imu/data</topic>
      <gz_frame_id>body</gz_frame_id>
    </sensor>
  </gazebo>
"""
        in after
    )


def test_a_robot_loads_the_systems_of_its_sensors_unless_a_world_does(folder: Folder) -> None:
    system = '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors"/>'
    alone = migrated(folder, {"urdf/base.xacro": base(LIDAR)})["urdf/base.xacro"]
    assert alone.endswith(f"  <gazebo>\n    {system}\n  </gazebo>\n</robot>\n")
    world = f'<sdf version="1.8"><world name="w">{system}</world></sdf>'
    assert system not in migrated(folder, {"urdf/base.xacro": base(LIDAR), "worlds/w.sdf": world})["urdf/base.xacro"]


def test_a_robot_loads_the_system_of_a_sensor_that_only_other_arguments_switch_on(folder: Folder) -> None:
    optional = f'  <xacro:arg name="lidar" default="false"/>\n<xacro:if value="$(arg lidar)">\n{LIDAR}</xacro:if>\n'
    macro = f'<xacro:macro name="seen" params="">\n{LIDAR}</xacro:macro>\n'
    system = 'filename="gz-sim-sensors-system"'
    assert system in migrated(folder, {"urdf/base.xacro": base(optional)})["urdf/base.xacro"]
    assert system not in migrated(folder, {"urdf/base.xacro": base(macro)})["urdf/base.xacro"]


def test_a_robot_that_a_launch_file_gives_its_arguments_loads_the_systems_itself(folder: Folder) -> None:
    name = '<link name="$(arg place)"/>\n'
    launch = """\
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share base)/urdf/base.xacro place:=top')"/>
  </node>
</launch>
"""
    files = {"urdf/base.xacro": base(LIDAR + name)}
    told = "load it in the world for the sensors of this robot"
    assert told in migrated(folder, files)["urdf/base.xacro"]
    after = migrated(folder, {**files, "launch/base.launch.xml": launch})["urdf/base.xacro"]
    assert 'filename="gz-sim-sensors-system"' in after
    assert told not in after


def test_a_part_of_a_robot_needs_no_systems_of_its_own(folder: Folder) -> None:
    part = f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">\n<link name="$(arg side)"/>\n{LIDAR}</robot>\n'
    include = '<xacro:arg name="side" default="a"/>\n<xacro:include filename="$(find base)/urdf/eye.xacro"/>\n'
    after = migrated(folder, {"urdf/eye.xacro": part, "urdf/base.xacro": base(include)})
    assert "load it in the world" not in after["urdf/eye.xacro"]
    assert 'filename="gz-sim-sensors-system"' in after["urdf/base.xacro"]


def test_what_systems_and_sensors_publish_is_bridged(folder: Folder) -> None:
    after = migrated(folder, {"urdf/base.xacro": base(DRIVE + LIDAR), "launch/sim.launch.py": LAUNCH})
    entries = yaml.safe_load(after["config/bridge.yaml"])
    directions = {entry["ros_topic_name"]: (entry["gz_type_name"], entry["direction"]) for entry in entries}
    assert directions == {
        "/clock": ("gz.msgs.Clock", "GZ_TO_ROS"),
        "cmd_vel": ("gz.msgs.Twist", "ROS_TO_GZ"),
        "wheels/odom": ("gz.msgs.Odometry", "GZ_TO_ROS"),
        "front/scan": ("gz.msgs.LaserScan", "GZ_TO_ROS"),
    }
    assert (
        '"config_file": PathJoinSubstitution([FindPackageShare("base"), "config/bridge.yaml"])'
        in after["launch/sim.launch.py"]
    )


def test_topics_below_an_argument_are_bridged_with_its_default(folder: Folder) -> None:
    argument = '  <xacro:arg name="lidar" default="false"/>\n  <xacro:arg name="space" default="/"/>\n'
    lidar = LIDAR.replace("<namespace>/front</namespace>", "<namespace>$(arg space)</namespace>")
    robot = base(f'{argument}  <xacro:if value="$(arg lidar)">\n{lidar}  </xacro:if>\n')
    entries = yaml.safe_load(migrated(folder, {"urdf/base.xacro": robot})["config/bridge.yaml"])
    assert [entry["ros_topic_name"] for entry in entries] == ["/clock", "/scan"]


def test_the_folder_of_the_new_file_for_the_bridge_is_installed(folder: Folder) -> None:
    build = "project(base)\ninstall(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\n\nament_package()\n"
    after = migrated(folder, {"urdf/base.xacro": base(LIDAR), "CMakeLists.txt": build})["CMakeLists.txt"]
    rule = "install(DIRECTORY config\n  DESTINATION share/${PROJECT_NAME}\n)\n\n"
    assert after == build.replace("ament_package()", f"{rule}ament_package()")


def test_the_plugin_that_runs_controllers_and_its_hardware_become_those_of_gz(folder: Folder) -> None:
    files = {"urdf/base.xacro": base(CONTROL), "config/controllers.yaml": CONTROLLERS}
    after = migrated(folder, files)["urdf/base.xacro"]
    assert "<plugin>gz_ros2_control/GazeboSimSystem</plugin>" in after
    assert (
        """\
    <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
      <parameters>$(find base)/config/controllers.yaml</parameters>
    </plugin>
"""
        in after
    )


def test_both_simulators_stay_behind_an_argument_if_asked(folder: Folder) -> None:
    files = {"urdf/base.xacro": base(CONTROL), "config/controllers.yaml": CONTROLLERS}
    after = migrated(folder, files, "--keep-classic")
    for given, plugin in (("false", "gz_ros2_control-system"), ("true", "libgazebo_ros2_control.so")):
        ran = folder.run("expand", "new/urdf/base.xacro", f"use_gazebo_classic:={given}")
        assert f'filename="{plugin}"' in ran.stdout
    assert after["urdf/base.xacro"].count('<xacro:arg name="use_gazebo_classic" default="false"/>') == 1
    again = folder.run("migrate", "new", "--from", "humble", "--to", "jazzy", "--keep-classic")
    assert (again.returncode, again.stdout) == (0, "")


def test_a_launch_file_starts_gz_and_keeps_its_other_lines(folder: Folder) -> None:
    text = migrated(folder, {"urdf/base.xacro": base(""), "launch/sim.launch.py": LAUNCH})["launch/sim.launch.py"]
    compile(text, "sim.launch.py", "exec")
    for part in (
        "    # the simulator\n    gazebo = IncludeLaunchDescription(",
        '[FindPackageShare("ros_gz_sim"), "/launch/gz_sim.launch.py"]',
        'launch_arguments={"gz_args": ["-r -v4 ", "my.world"]}.items()',
        'package="ros_gz_sim", executable="create"',
        '"-name", "base"',
        '"/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"',
    ):
        assert part in text
    assert "gazebo_ros" not in text


def test_dependencies_are_those_of_gz(folder: Folder) -> None:
    files = {"urdf/base.xacro": base(CONTROL), "config/controllers.yaml": CONTROLLERS}
    manifest = migrated(folder, files)["package.xml"]
    for name in ("ros_gz_sim", "ros_gz_bridge", "gz_ros2_control"):
        assert manifest.count(f"<exec_depend>{name}</exec_depend>") == 1
    assert "gazebo_ros" not in manifest
    assert "gazebo_plugins" not in manifest


def test_a_robot_in_gazebo_classic_stays_there_up_to_iron(folder: Folder) -> None:
    folder.write({"base/package.xml": MANIFEST, "base/urdf/base.xacro": base(DRIVE + LIDAR)})
    ran = folder.run("migrate", "base", "--from", "foxy", "--to", "humble", "--only", "urdf,manifest")
    assert (ran.returncode, ran.stdout) == (0, "")


TRICYCLE = """\
  <gazebo>
    <plugin name="drive" filename="libgazebo_ros_tricycle_drive.so">
      <steering_joint>left</steering_joint>
      <actuated_wheel_joint>right</actuated_wheel_joint>
    </plugin>
  </gazebo>
"""


def test_a_tricycle_drive_is_left_to_a_person_with_its_joints_and_the_controller_for_them(folder: Folder) -> None:
    text = migrated(folder, {"urdf/base.xacro": base(TRICYCLE)})["urdf/base.xacro"]
    joints = "velocity of 'right' and position of 'left'"
    assert f"TODO(urdfctl): gz has no tricycle drive: give <ros2_control> {joints}, start tricycle_controller" in text


def bridged(folder: Folder, gazebo: str) -> dict[str, tuple[str, str]]:
    """The topics of the bridge: the name in gz and the type in ROS, by the name in ROS."""
    after = migrated(folder, {"urdf/base.xacro": base(gazebo), "launch/sim.launch.py": LAUNCH})
    entries = yaml.safe_load(after["config/bridge.yaml"])
    return {entry["ros_topic_name"]: (entry["gz_topic_name"], entry["ros_type_name"]) for entry in entries}


SETUP = """\
from setuptools import setup

setup(
    name="base",
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/base"]),
        ("share/base/launch", ["launch/sim.launch.py"]),
CONFIG    ],
)
"""


@pytest.mark.parametrize(
    ("written", "count"), [("", 1), ('        ("share/base/config", glob("config/*.yaml")),\n', 0)]
)
def test_the_file_for_the_bridge_is_installed_by_a_setup_py(folder: Folder, written: str, count: int) -> None:
    build = {
        "package.xml": MANIFEST.replace("ament_cmake", "ament_python"),
        "setup.py": SETUP.replace("CONFIG", written),
    }
    after = migrated(folder, {"urdf/base.xacro": base(DRIVE), "launch/sim.launch.py": LAUNCH, **build})
    assert after["setup.py"].count('("share/base/config", ["config/bridge.yaml"]),\n') == count
    assert "ros_gz_bridge" in after["launch/sim.launch.py"]


def test_a_sensor_keeps_its_topics_in_ros(folder: Folder) -> None:
    camera = """\
  <gazebo reference="body">
    <sensor name="eye" type="depth">
      <plugin name="eye" filename="libgazebo_ros_camera.so">
        <ros><remapping>eye/points:=/cloud</remapping></ros>
      </plugin>
    </sensor>
    <sensor name="front" type="camera">
      <plugin name="front" filename="libgazebo_ros_camera.so">
        <ros><remapping>image_raw:=unused</remapping></ros>
      </plugin>
    </sensor>
  </gazebo>
"""
    cloud = LIDAR.replace("LaserScan", "PointCloud2").replace('name="lidar"', 'name="cloud"')
    found = bridged(folder, camera + cloud)
    assert found["/cloud"] == ("eye/points", "sensor_msgs/msg/PointCloud2")
    assert found["eye/image_raw"] == ("eye/image", "sensor_msgs/msg/Image")
    assert found["eye/depth/image_raw"] == ("eye/depth_image", "sensor_msgs/msg/Image")
    assert found["front/image_raw"] == ("front/image_raw", "sensor_msgs/msg/Image")
    assert found["front/camera_info"] == ("front/camera_info", "sensor_msgs/msg/CameraInfo")
    assert found["front/scan"] == ("front/scan/points", "sensor_msgs/msg/PointCloud2")


def test_the_topics_of_a_sensor_in_a_macro_are_those_of_the_robot_before(folder: Folder) -> None:
    sensor = """\
  <xacro:macro name="eye" params="topic is_framed">
    <gazebo reference="body">
      <sensor name="eye" type="ray">
        <plugin name="eye" filename="libgazebo_ros_block_laser.so">
          <topicName>${topic}</topicName>
          <xacro:if value="${is_framed}"><frameName>body</frameName></xacro:if>
        </plugin>
      </sensor>
    </gazebo>
  </xacro:macro>
  <xacro:eye topic="front/cloud" is_framed="true"/>
"""
    after = migrated(folder, {"urdf/base.xacro": base(sensor), "launch/sim.launch.py": LAUNCH})
    assert "- ros_topic_name: front/cloud\n  gz_topic_name: front/cloud/points\n" in after["config/bridge.yaml"]
    text = " ".join(after["urdf/base.xacro"].split())
    assert '<xacro:if value="${is_framed}"> <gz_frame_id>body</gz_frame_id> </xacro:if>' in text


def test_the_topic_of_a_contact_sensor_is_where_gz_reads_it(folder: Folder) -> None:
    bumper = """\
  <gazebo reference="body">
    <sensor name="bumper" type="contact">
      <contact>
        <collision>body_collision</collision>
      </contact>
      <plugin name="bumper" filename="libgazebo_ros_bumper.so">
        <ros><remapping>bumper_states:=touched</remapping></ros>
      </plugin>
    </sensor>
  </gazebo>
"""
    after = migrated(folder, {"urdf/base.xacro": base(bumper), "launch/sim.launch.py": LAUNCH})
    assert "</collision> <topic>touched</topic> </contact>" in " ".join(after["urdf/base.xacro"].split())
    assert "- ros_topic_name: touched\n  gz_topic_name: touched\n" in after["config/bridge.yaml"]
    assert "publishes ros_gz_interfaces/msg/Contacts, not gazebo_msgs/msg/ContactsState" in after["MIGRATION.md"]


def test_the_topics_of_a_macro_that_nothing_calls_are_not_bridged(folder: Folder) -> None:
    macro = f'  <xacro:macro name="{{name}}" params="">\n{LIDAR}  </xacro:macro>\n'
    called = macro.format(name="used") + "  <xacro:used/>\n" + macro.format(name="spare").replace("/front", "/spare")
    found = bridged(folder, called)
    assert "front/scan" in found
    assert "spare/scan" not in found


def test_the_sensors_of_a_link_that_is_written_as_sdf_are_bridged(folder: Folder) -> None:
    sensor = LIDAR.replace("<namespace>/front</namespace>", "<namespace>${'front'}</namespace>")
    sensor = sensor.replace('<gazebo reference="body">', '<gazebo>\n    <link name="mast">')
    assert "front/scan" in bridged(folder, sensor.replace("</gazebo>", "</link></gazebo>"))


def test_a_topic_that_only_an_argument_names_is_left_to_a_person(folder: Folder) -> None:
    lidar = LIDAR.replace("<namespace>/front</namespace>", "<namespace>$(arg space)</namespace>")
    after = migrated(folder, {"urdf/base.xacro": base(lidar)})
    assert "topic '$(arg space)/scan' is not bridged: add it to config/bridge.yaml" in after["MIGRATION.md"]
    argument = '  <xacro:arg name="space" default="rear"/>\n'
    assert "is not bridged" not in migrated(folder, {"urdf/base.xacro": base(argument + lidar)})["MIGRATION.md"]


def test_frames_have_no_slash_before_them(folder: Folder) -> None:
    robot = base((DRIVE + LIDAR).replace(">body</robot_base_frame>", ">/body</robot_base_frame>"))
    text = migrated(folder, {"urdf/base.xacro": robot.replace("<frame_name>body", "<frame_name>/body")})
    assert "<gz_frame_id>body</gz_frame_id>" in text["urdf/base.xacro"]
    assert "<child_frame_id>body</child_frame_id>" in text["urdf/base.xacro"]


def test_the_noise_of_a_plugin_that_is_a_sensor_is_named(folder: Folder) -> None:
    noise = "<accelGaussianNoise>0.1 0.1 0.1</accelGaussianNoise><accelDrift>0.0 0.0 0.0</accelDrift>"
    imu = f'<plugin name="imu" filename="libhector_gazebo_ros_imu.so"><bodyName>body</bodyName>{noise}</plugin>'
    report = migrated(folder, {"urdf/base.xacro": base(f"  <gazebo>{imu}</gazebo>\n")})["MIGRATION.md"]
    assert "the sensor has no accelGaussianNoise of 'hector_gazebo_ros_imu': dropped" in report
