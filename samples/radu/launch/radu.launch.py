"""Brings radu into Gazebo Classic and starts its controllers (ROS 2 foxy)."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command
from launch_ros.actions import Node


def generate_launch_description():
    """The simulator, the robot in it, and when the robot is there, its controllers one by one."""
    radu = get_package_share_directory("radu")
    gazebo = get_package_share_directory("gazebo_ros")

    simulator = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(os.path.join(gazebo, "launch", "gazebo.launch.py"))
    )

    state_publisher = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[
            {
                "use_sim_time": True,
                "robot_description": Command(["xacro ", os.path.join(radu, "urdf", "radu.urdf.xacro")]),
            }
        ],
    )

    robot = Node(
        package="gazebo_ros", executable="spawn_entity.py", arguments=["-topic", "robot_description", "-entity", "radu"]
    )

    joint_states = ExecuteProcess(
        cmd=["ros2", "control", "load_controller", "--set-state", "start", "joint_state_broadcaster"]
    )

    wheels = ExecuteProcess(cmd=["ros2", "control", "load_controller", "--set-state", "start", "velocity_controller"])

    return LaunchDescription(
        [
            simulator,
            state_publisher,
            robot,
            RegisterEventHandler(OnProcessExit(target_action=robot, on_exit=[joint_states])),
            RegisterEventHandler(OnProcessExit(target_action=joint_states, on_exit=[wheels])),
        ]
    )
