from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = FindPackageShare("twin_arms")
    robot = Command(
        [
            FindExecutable(name="xacro"),
            " ",
            PathJoinSubstitution([share, "urdf", "twin_arms.urdf.xacro"]),
            " mock:=",
            LaunchConfiguration("mock"),
        ]
    )
    controllers = PathJoinSubstitution([share, "config", "controllers.yaml"])
    names = ["joint_state_broadcaster", "left_arm_controller", "right_arm_controller"]
    return LaunchDescription(
        [
            DeclareLaunchArgument("mock", default_value="true"),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": ParameterValue(robot, value_type=str)}],
            ),
            Node(package="controller_manager", executable="ros2_control_node", parameters=[controllers]),
            *(Node(package="controller_manager", executable="spawner", arguments=[name]) for name in names),
        ]
    )
