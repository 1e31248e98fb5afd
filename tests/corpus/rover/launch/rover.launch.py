import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    robot = Command(["xacro ", os.path.join(get_package_share_directory("rover"), "urdf", "rover.urdf.xacro")])
    world = os.path.join(get_package_share_directory("ros_gz_sim"), "launch", "gz_sim.launch.py")
    names = ["joint_state_broadcaster", "imu_broadcaster", "base_controller"]
    return LaunchDescription(
        [
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(world), launch_arguments={"gz_args": "-r empty.sdf"}.items()
            ),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": ParameterValue(robot, value_type=str), "use_sim_time": True}],
            ),
            Node(package="ros_gz_sim", executable="create", arguments=["-topic", "robot_description", "-z", "0.1"]),
            Node(package="controller_manager", executable="spawner", arguments=names),
        ]
    )
