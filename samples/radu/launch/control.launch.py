# made by urdfctl gen-launch urdf/radu.urdf.xacro --type velocity --distro humble --simulator gazebo-classic
# Start it: ros2 launch radu control.launch.py
"""Start the robot in gazebo-classic and its controllers."""

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return the nodes to start, in order."""
    robot_file = PathJoinSubstitution([FindPackageShare("radu"), "urdf/radu.urdf.xacro"])
    robot_description = {"robot_description": ParameterValue(Command(["xacro ", robot_file]), value_type=str)}

    # publishes the robot description and the transforms of its links
    state_publisher = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[robot_description, {"use_sim_time": True}],
    )

    world = PathJoinSubstitution([FindPackageShare("gazebo_ros"), "launch", "gazebo.launch.py"])
    simulator = IncludeLaunchDescription(PythonLaunchDescriptionSource(world))
    robot = Node(
        package="gazebo_ros",
        executable="spawn_entity.py",
        arguments=["-topic", "robot_description", "-entity", "radu"],
    )

    # the joint state broadcaster first, then the controllers that move joints
    spawner_1 = Node(
        package="controller_manager",
        executable="spawner",
        arguments=[
            "joint_state_broadcaster",
            "--controller-manager",
            "/controller_manager",
        ],
    )
    spawner_2 = Node(
        package="controller_manager",
        executable="spawner",
        arguments=[
            "velocity_controller",
            "--controller-manager",
            "/controller_manager",
        ],
    )

    return LaunchDescription(
        [
            simulator,
            state_publisher,
            robot,
            # each spawner waits for the one before it
            RegisterEventHandler(OnProcessExit(target_action=robot, on_exit=[spawner_1])),
            RegisterEventHandler(OnProcessExit(target_action=spawner_1, on_exit=[spawner_2])),
        ]
    )
