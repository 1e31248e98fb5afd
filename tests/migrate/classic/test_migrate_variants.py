"""What a migration makes of a robot that gz simulates with some arguments, and Gazebo Classic with others."""

from __future__ import annotations

import pytest
from classic_packages import CONTROL, CONTROLLERS, base, migrated
from folder import Folder

SENSOR = """\
  <gazebo reference="body">
    <sensor name="motion" type="imu">{inside}</sensor>
  </gazebo>
"""
PLUGIN = (
    '<plugin name="m" filename="libgazebo_ros_imu_sensor.so"><ros><remapping>~/out:=tilt</remapping></ros></plugin>'
)
SYSTEM = '  <gazebo><plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/></gazebo>\n'
OF_GZ = SENSOR.format(inside="<topic>tilt</topic>") + SYSTEM
CONTROL_IN_GZ = (
    CONTROL.replace("libgazebo_ros2_control.so", "gz_ros2_control-system")
    .replace("gazebo_ros2_control/GazeboSystem", "gz_ros2_control/GazeboSimSystem")
    .replace('name="gazebo_ros2_control"', 'name="gz_ros2_control::GazeboSimROS2ControlPlugin"')
)
VARIANTS = f"""\
  <xacro:arg name="old" default="false"/>
  <xacro:if value="$(arg old)">
{CONTROL}{SENSOR.format(inside=PLUGIN)}  </xacro:if>
  <xacro:unless value="$(arg old)">
{CONTROL_IN_GZ}{OF_GZ}  </xacro:unless>
"""
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    text = Command(["xacro ", FindPackageShare("base"), "/urdf/base.xacro old:={old}"])
    file = PathJoinSubstitution([FindPackageShare("{package}"), "launch", "{file}"])
    return LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource(file)),
        Node(
            package="robot_state_publisher",
            executable="robot_state_publisher",
            parameters=[{{"robot_description": text}}],
        ),
        Node(package="{package}", executable="{spawner}", arguments=["-topic", "robot_description"]),
{more}    ])
"""
CLASSIC = LAUNCH.format(old="true", package="gazebo_ros", file="gazebo.launch.py", spawner="spawn_entity.py", more="")
BRIDGE = (
    '        Node(package="ros_gz_bridge", executable="parameter_bridge", arguments=["/clock@a/msg/B[gz.msgs.C"]),\n'
)
GZ = LAUNCH.format(old="false", package="ros_gz_sim", file="gz_sim.launch.py", spawner="create", more=BRIDGE)


@pytest.mark.parametrize("bridged", [False, True])
def test_what_the_variant_for_classic_lacks_in_gz_is_told(folder: Folder, bridged: bool) -> None:
    """Its file cannot load systems for it alone, and its launch file starts no bridge."""
    classic = CLASSIC.replace("    ])\n", f"{BRIDGE}    ])\n") if bridged else CLASSIC
    launches = {"launch/old.launch.py": classic, "launch/new.launch.py": GZ}
    files = {"urdf/base.xacro": base(VARIANTS), "config/controllers.yaml": CONTROLLERS, **launches}
    after = migrated(folder, files)
    report = (folder.path / "new" / "MIGRATION.md").read_text()
    assert "gz-sim-imu-system: load it for the sensors of the robot with old:=true" in report
    assert after["urdf/base.xacro"].count('filename="gz-sim-imu-system"') == 1
    assert ("start a bridge of 'tilt' here, too: only other launch files do" in report) != bridged


def test_a_bridge_that_the_migration_itself_writes_is_not_missed_elsewhere(folder: Folder) -> None:
    """A second launch file includes the one that gets it."""
    more = CLASSIC.replace('"gazebo_ros"', '"trolley"').replace("gazebo.launch.py", "old.launch.py")
    robot = base(CONTROL + SENSOR.format(inside=PLUGIN))
    launches = {"launch/old.launch.py": CLASSIC, "launch/all.launch.py": more.split("        Node(")[0] + "    ])\n"}
    after = migrated(folder, {"urdf/base.xacro": robot, "config/controllers.yaml": CONTROLLERS, **launches})
    assert "parameter_bridge" in after["launch/old.launch.py"]
    assert "here, too" not in (folder.path / "new" / "MIGRATION.md").read_text()


@pytest.mark.parametrize("started", [True, False])
def test_the_plugin_of_a_variant_for_classic_becomes_that_of_gz_if_a_launch_file_starts_it(
    folder: Folder, started: bool
) -> None:
    launches = {"launch/new.launch.py": GZ} | ({"launch/old.launch.py": CLASSIC} if started else {})
    files = {"urdf/base.xacro": base(VARIANTS), "config/controllers.yaml": CONTROLLERS, **launches}
    text = migrated(folder, files)["urdf/base.xacro"]
    assert text.count('filename="gz_ros2_control-system"') == 1 + started
    assert text.count('filename="libgazebo_ros2_control.so"') == 1 - started
