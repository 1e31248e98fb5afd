"""What a migration makes of the plugins of Gazebo Classic for drives and sensors, in Classic for ROS 2 and in gz."""

from __future__ import annotations

import pytest
from classic_packages import base, migrated
from folder import Folder

TO_CLASSIC = ("--from", "noetic", "--to", "humble", "--simulator", "gazebo-classic")
TO_GZ = ("--from", "noetic", "--to", "jazzy")
WHEELS = {
    1: "<leftJoint>left</leftJoint>\n<rightJoint>right</rightJoint>",
    2: "<left_joint>left</left_joint>\n<right_joint>right</right_joint>",
}
"""The wheels of a drive by the version of ROS."""


def plugin(library: str, settings: str) -> str:
    """A plugin of a model, with one setting in each line."""
    inside = "".join(f"      {line}\n" for line in settings.splitlines())
    return f'  <gazebo>\n    <plugin name="it" filename="lib{library}.so">\n{inside}    </plugin>\n  </gazebo>\n'


def sensor(kind: str, library: str, settings: str) -> str:
    """A sensor with a plugin."""
    inside = "".join(f"        {line}\n" for line in settings.splitlines())
    return f"""\
  <gazebo reference="body">
    <sensor name="eye" type="{kind}">
      <plugin name="it" filename="lib{library}.so">
{inside}      </plugin>
    </sensor>
  </gazebo>
"""


def after(folder: Folder, gazebo: str, *words: str) -> str:
    """What the migration makes of a part of a robot."""
    text = migrated(folder, {"urdf/base.xacro": base(gazebo)}, *words)["urdf/base.xacro"]
    head, tail = base("").split("</robot>")
    return text.removeprefix(head).removesuffix(f"</robot>{tail}")


@pytest.mark.parametrize("told", ["true", "false", ""])
def test_a_drive_that_publishes_the_states_of_its_wheels_has_a_system_for_them(folder: Folder, told: str) -> None:
    states = f"<publishWheelJointState>{told}</publishWheelJointState>\n" if told else ""
    drive = plugin("gazebo_ros_diff_drive", f"{states}<robotNamespace>/rover</robotNamespace>\n{WHEELS[1]}")
    files = migrated(folder, {"urdf/base.xacro": base(drive)}, *TO_GZ)
    system = """\
    <plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher">
      <joint_name>left</joint_name>
      <joint_name>right</joint_name>
      <topic>rover/joint_states</topic>
    </plugin>
"""
    assert (system in files["urdf/base.xacro"]) is (told == "true")
    assert ("rover/joint_states" in files["config/bridge.yaml"]) is (told == "true")


@pytest.mark.parametrize("library", ["gazebo_ros_openni_kinect", "gazebo_ros_camera"])
def test_a_depth_camera_of_ros_1_has_the_information_of_both_images(folder: Folder, library: str) -> None:
    settings = "<cameraName>eye</cameraName>\n<cameraInfoTopicName>rgb/info</cameraInfoTopicName>"
    files = migrated(folder, {"urdf/base.xacro": base(sensor("depth", library, settings))}, *TO_GZ)
    entries = files["config/bridge.yaml"].split("\n- ")[1:]
    infos = [entry for entry in entries if "CameraInfo" in entry]
    names = [entry.split("\n")[0].partition(": ")[2] for entry in infos]
    assert names == ["eye/rgb/info", *(["eye/depth/camera_info"] if "kinect" in library else [])]
    assert len({entry.split("\n")[1] for entry in infos}) == 1


def test_a_drive_of_ros_1_gets_the_names_of_ros_2(folder: Folder) -> None:
    old = plugin(
        "gazebo_ros_diff_drive",
        "<robotNamespace>/rover</robotNamespace>\n<leftJoint>left</leftJoint>\n<rightJoint>right</rightJoint>\n"
        "<wheelSeparation>0.4</wheelSeparation>\n<wheelTorque>5</wheelTorque>\n<odometrySource>world</odometrySource>\n"
        "<publishWheelTF>false</publishWheelTF>\n<commandTopic>drive</commandTopic>\n<odometryTopic>odom</odometryTopic>",
    )
    new = plugin(
        "gazebo_ros_diff_drive",
        "<ros>\n  <namespace>/rover</namespace>\n  <remapping>cmd_vel:=drive</remapping>\n</ros>\n"
        "<publish_odom>true</publish_odom>\n<publish_odom_tf>true</publish_odom_tf>\n"
        "<left_joint>left</left_joint>\n<right_joint>right</right_joint>\n"
        "<wheel_separation>0.4</wheel_separation>\n<max_wheel_torque>5</max_wheel_torque>\n"
        "<odometry_source>1</odometry_source>\n<publish_wheel_tf>false</publish_wheel_tf>",
    )
    assert after(folder, old, *TO_CLASSIC) == new


def test_a_drive_with_four_wheels_becomes_one_with_two_pairs(folder: Folder) -> None:
    old = plugin(
        "gazebo_ros_skid_steer_drive",
        "<leftFrontJoint>left</leftFrontJoint>\n<leftRearJoint>left</leftRearJoint>\n"
        "<rightFrontJoint>right</rightFrontJoint>\n<rightRearJoint>right</rightRearJoint>\n"
        "<wheelSeparation>0.4</wheelSeparation>\n<broadcastTF>false</broadcastTF>",
    )
    new = plugin(
        "gazebo_ros_diff_drive",
        "<num_wheel_pairs>2</num_wheel_pairs>\n<publish_odom>true</publish_odom>\n<left_joint>left</left_joint>\n"
        "<left_joint>left</left_joint>\n<right_joint>right</right_joint>\n<right_joint>right</right_joint>\n"
        "<wheel_separation>0.4</wheel_separation>\n<wheel_separation>0.4</wheel_separation>\n<publish_odom_tf>false</publish_odom_tf>",
    )
    assert after(folder, old, *TO_CLASSIC) == new


def test_a_publisher_of_joint_states_names_each_joint_by_itself(folder: Folder) -> None:
    old = plugin("gazebo_ros_joint_state_publisher", "<jointName>left, right</jointName>")
    new = plugin("gazebo_ros_joint_state_publisher", "<joint_name>left</joint_name>\n<joint_name>right</joint_name>")
    assert after(folder, old, *TO_CLASSIC) == new


@pytest.mark.parametrize(
    ("library", "output"),
    [("gazebo_ros_laser", "LaserScan"), ("gazebo_ros_block_laser", "PointCloud"), ("gazebo_ros_range", "Range")],
)
def test_a_ray_sensor_of_ros_1_publishes_the_same_messages_in_ros_2(folder: Folder, library: str, output: str) -> None:
    old = sensor(
        "ray", library, "<topicName>scan</topicName>\n<frameName>body</frameName>\n<gaussianNoise>0</gaussianNoise>"
    )
    new = sensor(
        "ray",
        "gazebo_ros_ray_sensor",
        "<ros>\n  <remapping>~/out:=scan</remapping>\n</ros>\n"
        f"<output_type>sensor_msgs/{output}</output_type>\n<frame_name>body</frame_name>",
    )
    assert after(folder, old, *TO_CLASSIC) == new


@pytest.mark.parametrize(
    ("remapping", "topic"), [("~/out:=imu/data", "imu/data"), ("it/out:=imu/data", "imu/data"), ("other/out:=x", "imu")]
)
def test_a_sensor_of_ros_2_publishes_where_its_output_is_remapped(folder: Folder, remapping: str, topic: str) -> None:
    """Its topic is ~/out, below the plugin's name; <topicName> is a setting of ROS 1 alone."""
    settings = f"<ros><remapping>{remapping}</remapping></ros>\n<topicName>imu</topicName>"
    shown = after(folder, sensor("imu", "gazebo_ros_imu_sensor", settings), "--from", "humble", "--to", "jazzy")
    assert f"<topic>{topic}</topic>" in shown


def test_a_camera_keeps_its_topics_below_its_name_and_gives_its_rate_to_the_sensor(folder: Folder) -> None:
    old = sensor(
        "depth",
        "gazebo_ros_openni_kinect",
        "<cameraName>front</cameraName>\n<updateRate>30</updateRate>\n<imageTopicName>image_raw</imageTopicName>\n"
        "<pointCloudTopicName>depth/points</pointCloudTopicName>\n<distortionK1>0.0</distortionK1>",
    )
    new = sensor(
        "depth",
        "gazebo_ros_camera",
        "<ros>\n  <remapping>front/points:=front/depth/points</remapping>\n</ros>\n<camera_name>front</camera_name>",
    )
    shown = after(folder, old, *TO_CLASSIC)
    assert shown == new.replace("      <plugin", "      <update_rate>30</update_rate>\n      <plugin")


def test_a_plugin_that_is_a_sensor_becomes_a_sensor_with_a_plugin(folder: Folder) -> None:
    old = plugin("hector_gazebo_ros_imu", "<bodyName>body</bodyName>\n<topicName>imu/data</topicName>")
    shown = after(folder, old, *TO_CLASSIC)
    assert '<sensor name="it" type="imu">' in shown
    assert '<plugin name="it" filename="libgazebo_ros_imu_sensor.so">' in shown
    assert "<remapping>~/out:=imu/data</remapping>" in shown


def test_settings_that_ros_2_has_not_are_reported(folder: Folder) -> None:
    old = plugin(
        "gazebo_ros_p3d", "<bodyName>body</bodyName>\n<topicName>truth</topicName>\n<ownSetting>1</ownSetting>"
    )
    shown = migrated(folder, {"urdf/base.xacro": base(old)}, *TO_CLASSIC)
    assert "plugin 'gazebo_ros_p3d' does not read ownSetting in ROS 2: dropped" in shown["MIGRATION.md"]
    assert "<body_name>body</body_name>" in shown["urdf/base.xacro"]


@pytest.mark.parametrize(
    ("old", "published"),
    [
        (WHEELS[1], True),
        (f"{WHEELS[1]}\n<publishOdomTF>false</publishOdomTF>", False),
        (WHEELS[2], False),
        (f"{WHEELS[2]}\n<publish_odom_tf>true</publish_odom_tf>", True),
    ],
)
def test_a_drive_publishes_the_transform_of_its_odometry_as_before(folder: Folder, old: str, published: bool) -> None:
    shown = after(folder, plugin("gazebo_ros_diff_drive", old), *TO_GZ)
    assert ("<tf_topic>/tf</tf_topic>" in shown) is published


@pytest.mark.parametrize(
    ("old", "has_odometry"),
    [
        (
            "<odometryTopic>odom</odometryTopic><odometryFrame>odom</odometryFrame><odometryRate>20.0</odometryRate>",
            True,
        ),
        (
            "<publish_odom>true</publish_odom><odometry_frame>odom</odometry_frame><publish_rate>20.0</publish_rate>",
            True,
        ),
        ("<publish_odom>false</publish_odom><odometry_frame>odom</odometry_frame>", False),
        ("<odometry_frame>odom</odometry_frame>", False),
    ],
)
def test_a_planar_move_keeps_its_odometry(folder: Folder, old: str, has_odometry: bool) -> None:
    shown = after(folder, plugin("gazebo_ros_planar_move", old), *TO_GZ)
    assert "gz-sim-velocity-control-system" in shown
    assert ("<odom_topic>odom</odom_topic>" in shown) is has_odometry
    assert ("<odom_publish_frequency>20.0</odom_publish_frequency>" in shown) is has_odometry


def test_topics_are_in_the_namespace_of_their_plugin(folder: Folder) -> None:
    old = f"{WHEELS[1]}\n<robotNamespace>rover</robotNamespace>\n<commandTopic>drive</commandTopic>\n"
    old += "<odometryTopic>/odom</odometryTopic>"
    shown = after(folder, plugin("gazebo_ros_diff_drive", old), *TO_GZ)
    assert "<topic>rover/drive</topic>" in shown
    assert "<odom_topic>/odom</odom_topic>" in shown


def test_a_steered_vehicle_becomes_one_of_gz_with_its_measures(folder: Folder) -> None:
    corners = {"rear_left": (0, 0.5), "rear_right": (0, -0.5), "front_left": (2, 0.4), "front_right": (2, -0.4)}
    wheels = "".join(
        f"""\
  <link name="{name}"><collision><geometry><cylinder radius="0.3" length="0.1"/></geometry></collision></link>
  <joint name="{name}_joint" type="continuous">
    <parent link="body"/><child link="{name}"/><origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/>
  </joint>
"""
        for name, (x, y) in corners.items()
    )
    names = "rear_left_joint rear_right_joint front_left_joint front_right_joint".split()
    old = "".join(f"<{name}>{name}</{name}>\n" for name in names)
    old += "<left_steering_joint>front_left_joint</left_steering_joint>\n<max_speed>20</max_speed>\n"
    old += "<right_steering_joint>front_right_joint</right_steering_joint>"
    files = migrated(folder, {"urdf/base.xacro": base(wheels + plugin("gazebo_ros_ackermann_drive", old))})
    shown, bridged = files["urdf/base.xacro"], files["config/bridge.yaml"]
    assert "ros_topic_name: cmd_vel\n" in bridged
    assert "ros_topic_name: odom\n" in bridged
    for line in (
        '<plugin filename="gz-sim-ackermann-steering-system" name="gz::sim::systems::AckermannSteering">',
        "<left_joint>rear_left_joint</left_joint>",
        "<max_velocity>20</max_velocity>\n      <min_velocity>-20</min_velocity>",
        "<wheel_separation>1.0</wheel_separation>",
        "<kingpin_width>0.8</kingpin_width>",
        "<wheel_base>2.0</wheel_base>",
    ):
        assert line in shown
    assert "TODO(urdfctl): measure the vehicle and write <wheel_radius>, in m" in shown or "<wheel_radius>" in shown


def test_a_wheel_slip_plugin_keeps_its_wheels(folder: Folder) -> None:
    wheel = '<wheel link_name="left_wheel">\n  <wheel_normal_force>9</wheel_normal_force>\n</wheel>'
    shown = after(folder, plugin("gazebo_ros_wheel_slip", wheel))
    assert (
        shown
        == """\
  <gazebo>
    <plugin filename="gz-sim-wheel-slip-system" name="gz::sim::systems::WheelSlip">
      <wheel link_name="left_wheel">
        <wheel_normal_force>9</wheel_normal_force>
      </wheel>
    </plugin>
  </gazebo>
"""
    )


def test_a_drive_keeps_its_comments_and_its_acceleration_and_the_report_names_what_is_dropped(folder: Folder) -> None:
    settings = (
        "<!-- the wheels -->\n<left_joint>left</left_joint>\n<right_joint>right</right_joint>\n"
        "<wheel_diameter>0.2</wheel_diameter>\n<max_wheel_acceleration>5</max_wheel_acceleration>\n"
        "<!-- of no use -->\n<max_wheel_torque>9</max_wheel_torque>"
    )
    shown = migrated(folder, {"urdf/base.xacro": base(plugin("gazebo_ros_diff_drive", settings))})
    text = shown["urdf/base.xacro"]
    assert "      <!-- the wheels -->\n      <left_joint>left</left_joint>\n" in text
    assert "<max_linear_acceleration>5</max_linear_acceleration>" in text
    assert "of no use" not in text
    assert "does not have max_wheel_torque of 'gazebo_ros_diff_drive': dropped" in shown["MIGRATION.md"]


def test_a_plugin_of_the_users_own_is_left_to_a_person(folder: Folder) -> None:
    shown = after(folder, plugin("my_gripper", "<force>9</force>"))
    assert (
        "<!-- TODO(urdfctl): plugin 'my_gripper' is built for Gazebo Classic: port it to gz, or remove it -->" in shown
    )
    assert '<plugin name="it" filename="libmy_gripper.so">' in shown


def test_a_plugin_for_gz_is_not_taken_for_one_of_gazebo_classic(folder: Folder) -> None:
    mine = plugin("my_system", "<force>9</force>").replace('name="it"', 'name="mine::System"')
    assert "TODO" not in after(folder, plugin("gazebo_ros_diff_drive", WHEELS[2]) + mine)


def test_a_plugin_that_ros_1_left_in_a_package_for_ros_2_is_removed(folder: Folder) -> None:
    drive = plugin("gazebo_ros_diff_drive", WHEELS[2])
    left = plugin("gazebo_ros_control", "<robotNamespace>/</robotNamespace>")
    assert after(folder, drive + left) == after(folder, drive)


@pytest.mark.parametrize(("near", "far"), [("min_depth", "max_depth"), ("pointCloudCutoff", "pointCloudCutoffMax")])
def test_the_range_of_a_camera_with_depth_stands_in_the_camera_for_gz(folder: Folder, near: str, far: str) -> None:
    settings = f"<{near}>0.3</{near}>\n<{far}>${{reach}}</{far}>\n<hackBaseline>0.07</hackBaseline>"
    old = sensor("depth", "gazebo_ros_openni_kinect", settings)
    camera = "      <camera>\n        <horizontal_fov>1</horizontal_fov>\n      </camera>\n"
    old = '<xacro:property name="reach" value="4"/>' + old.replace("      <plugin", f"{camera}      <plugin")
    shown = migrated(folder, {"urdf/base.xacro": base(old)}, *TO_GZ)
    clip = """\
      <camera>
        <horizontal_fov>1</horizontal_fov>
        <depth_camera>
          <clip>
            <near>0.3</near>
            <far>${reach}</far>
          </clip>
        </depth_camera>
      </camera>
"""
    assert clip in shown["urdf/base.xacro"]
    assert "gz does not read hackBaseline of 'gazebo_ros_openni_kinect': dropped" in shown["MIGRATION.md"]


def test_a_range_that_can_stand_nowhere_is_reported(folder: Folder) -> None:
    old = sensor("depth", "gazebo_ros_camera", "<min_depth>0.3</min_depth>\n<hack_baseline>0</hack_baseline>")
    shown = migrated(folder, {"urdf/base.xacro": base(old)}, *TO_GZ)
    assert "gz does not read min_depth of 'gazebo_ros_camera': dropped" in shown["MIGRATION.md"]


def test_a_todo_does_not_break_a_description_that_launch_reads_as_yaml(folder: Folder) -> None:
    launch = """\
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    text = Command(["xacro ", FindPackageShare("base"), "/urdf/base.xacro"])
    publisher = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[{"robot_description": text}],
    )
    return LaunchDescription([publisher])
"""
    robot = base(plugin("my_gripper", ""))
    found = migrated(folder, {"urdf/base.xacro": robot, "launch/base.launch.py": launch}, "--to", "jazzy")
    assert "<!-- TODO(urdfctl) - plugin 'my_gripper' is built for Gazebo Classic - port it" in found["urdf/base.xacro"]
    assert "UC632" not in found["MIGRATION.md"]


@pytest.mark.parametrize(("body", "is_told"), [("left_wheel", True), ("body", False)])
def test_the_pose_of_a_link_that_moves_is_not_that_of_the_model(folder: Folder, body: str, is_told: bool) -> None:
    old = plugin("gazebo_ros_p3d", f"<bodyName>{body}</bodyName>\n<topicName>truth</topicName>")
    report = migrated(folder, {"urdf/base.xacro": base(old)}, *TO_GZ)["MIGRATION.md"]
    assert (f"not that of link '{body}': read that from /tf" in report) is is_told


@pytest.mark.parametrize(
    ("rate", "expected"), [("20.0", "20.0"), ("200", "100"), ("0", "100"), ("${rate}", "100"), ("", "100")]
)
def test_a_sensor_publishes_no_more_often_than_its_plugin_did(folder: Folder, rate: str, expected: str) -> None:
    imu = f"""\
  <xacro:property name="rate" value="20"/>
  <gazebo reference="body">
    <sensor name="imu" type="imu">
      <update_rate>100</update_rate>
      <plugin name="imu" filename="libgazebo_ros_imu_sensor.so">
        <updateRateHZ>{rate}</updateRateHZ>
      </plugin>
    </sensor>
  </gazebo>
"""
    after = migrated(folder, {"urdf/base.xacro": base(imu)})["urdf/base.xacro"]
    assert f"<update_rate>{expected}</update_rate>" in after
    assert after.count("update_rate>") == 2
