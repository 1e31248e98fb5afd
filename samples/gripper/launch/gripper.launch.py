"""Start the gripper in gz, with its controllers."""

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return what is started."""
    robot = PathJoinSubstitution([FindPackageShare("gripper"), "urdf", "gripper.urdf.xacro"])
    description = ParameterValue(Command(["xacro ", robot]), value_type=str)
    simulator = PathJoinSubstitution([FindPackageShare("ros_gz_sim"), "launch", "gz_sim.launch.py"])
    return LaunchDescription(
        [
            IncludeLaunchDescription(simulator, launch_arguments=[("gz_args", "-r empty.sdf")]),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description, "use_sim_time": True}],
            ),
            Node(
                package="ros_gz_bridge",
                executable="parameter_bridge",
                arguments=["/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"],
            ),
            Node(package="ros_gz_sim", executable="create", arguments=["-topic", "robot_description"]),
            Node(package="controller_manager", executable="spawner", arguments=["joint_state_broadcaster"]),
            Node(
                package="controller_manager",
                executable="spawner",
                arguments=["arm_controller", "gripper_controller"],
            ),
        ]
    )
