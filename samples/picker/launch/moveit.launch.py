# Start it: ros2 launch picker moveit.launch.py
"""Start the robot in gz with its controllers, MoveIt's move_group, and RViz."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder


def generate_launch_description():
    """Return what to start."""
    folder = get_package_share_directory("picker")
    moveit_config = (
        MoveItConfigsBuilder("picker", package_name="picker")
        .robot_description(file_path="urdf/robot.xacro")
        .robot_description_semantic(file_path="config/picker.srdf")
        .robot_description_kinematics(file_path="config/kinematics.yaml")
        .joint_limits(file_path="config/joint_limits.yaml")
        .trajectory_execution(file_path="config/moveit_controllers.yaml")
        .planning_pipelines(pipelines=["ompl"], default_planning_pipeline="ompl")
        .to_moveit_configs()
    )

    # the robot, its controller manager and its controllers
    control = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(os.path.join(folder, "launch", "bringup.launch.py"))
    )
    move_group = Node(
        package="moveit_ros_move_group",
        executable="move_group",
        output="screen",
        parameters=[
            moveit_config.to_dict(),
            {"use_sim_time": True, "publish_robot_description_semantic": True},
        ],
    )
    rviz = Node(
        package="rviz2",
        executable="rviz2",
        arguments=["-d", os.path.join(folder, "config", "moveit.rviz")],
        parameters=[
            moveit_config.robot_description,
            moveit_config.robot_description_semantic,
            moveit_config.robot_description_kinematics,
            moveit_config.planning_pipelines,
            moveit_config.joint_limits,
            {"use_sim_time": True},
        ],
        condition=IfCondition(LaunchConfiguration("rviz")),
    )

    return LaunchDescription(
        [
            DeclareLaunchArgument("rviz", default_value="true", description="show RViz"),
            control,
            move_group,
            rviz,
        ]
    )
