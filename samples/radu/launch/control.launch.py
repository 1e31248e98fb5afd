# made by urdfctl gen-launch urdf/radu.urdf.xacro --type velocity --distro humble --simulator gazebo-classic
# Start it: ros2 launch radu control.launch.py
# A second one beside it: ros2 launch radu control.launch.py namespace:=two simulator:=false x:=1.0
"""Start the robot in gazebo-classic and its controllers."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, RegisterEventHandler
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return the nodes to start, in order."""
    namespace = LaunchConfiguration("namespace")
    # the frames of two robots differ: they begin with the namespace
    prefix = PythonExpression(["'", namespace, "/' if '", namespace, "' else ''"])
    frame_prefix = ParameterValue(prefix, value_type=str)
    robot_file = PathJoinSubstitution([FindPackageShare("radu"), "urdf/radu.urdf.xacro"])
    xacro = Command(
        [
            "xacro ",
            robot_file,
            " namespace:='",
            LaunchConfiguration("namespace"),
            "'",
        ],
        on_stderr="warn",  # a warning of xacro does not end the launch
    )
    robot_description = {"robot_description": ParameterValue(xacro, value_type=str)}

    # publishes the robot description and the transforms of its links
    state_publisher = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        namespace=namespace,
        parameters=[robot_description, {"use_sim_time": True, "frame_prefix": frame_prefix}],
    )

    world = PathJoinSubstitution([FindPackageShare("gazebo_ros"), "launch", "gazebo.launch.py"])
    settings = {"gui": LaunchConfiguration("gui"), "world": LaunchConfiguration("world")}
    simulator = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(world),
        launch_arguments=settings.items(),
        condition=IfCondition(LaunchConfiguration("simulator")),
    )
    robot = Node(
        package="gazebo_ros",
        executable="spawn_entity.py",
        namespace=namespace,
        arguments=[
            "-topic",
            "robot_description",
            "-entity",
            PythonExpression(["'", namespace, "' or 'radu'"]),
            "-x",
            LaunchConfiguration("x"),
            "-y",
            LaunchConfiguration("y"),
            "-z",
            LaunchConfiguration("z"),
            "-Y",
            LaunchConfiguration("yaw"),
        ],
    )

    # the joint state broadcaster first, then the controllers that move joints
    spawner_1 = Node(
        package="controller_manager",
        executable="spawner",
        namespace=namespace,
        arguments=[
            "joint_state_broadcaster",
            "--controller-manager",
            "controller_manager",
        ],
    )
    spawner_2 = Node(
        package="controller_manager",
        executable="spawner",
        namespace=namespace,
        arguments=[
            "velocity_controller",
            "--controller-manager",
            "controller_manager",
        ],
    )

    return LaunchDescription(
        [
            DeclareLaunchArgument("namespace", default_value="", description="namespace of the robot; empty for none"),
            DeclareLaunchArgument("simulator", default_value="true", description="false: it runs already"),
            DeclareLaunchArgument("world", default_value="worlds/empty.world", description="world of the simulator"),
            DeclareLaunchArgument("gui", default_value="true", description="false: without a window"),
            DeclareLaunchArgument("x", default_value="0.0", description="x of the robot in the world, in m"),
            DeclareLaunchArgument("y", default_value="0.0", description="y of the robot in the world, in m"),
            DeclareLaunchArgument("z", default_value="0.01", description="z of the robot in the world, in m"),
            DeclareLaunchArgument("yaw", default_value="0.0", description="yaw of the robot in the world, in rad"),
            simulator,
            state_publisher,
            robot,
            # each spawner waits for the one before it
            RegisterEventHandler(OnProcessExit(target_action=robot, on_exit=[spawner_1])),
            RegisterEventHandler(OnProcessExit(target_action=spawner_1, on_exit=[spawner_2])),
        ]
    )
