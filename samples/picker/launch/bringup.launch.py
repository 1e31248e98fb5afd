# made by urdfctl gen-launch urdf/robot.xacro --controller base_controller=diff_drive:left_wheel,right_wheel --controller arm_controller=trajectory:turn,shoulder,elbow,wrist --controller gripper_controller=gripper:finger --distro jazzy --simulator gz
# Start it: ros2 launch picker bringup.launch.py
# A second one beside it: ros2 launch picker bringup.launch.py namespace:=two simulator:=false x:=1.0
"""Start the robot in gz and its controllers."""

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
    robot_file = PathJoinSubstitution([FindPackageShare("picker"), "urdf/robot.xacro"])
    xacro = Command(
        [
            "xacro ",
            robot_file,
            " reach:='",
            LaunchConfiguration("reach"),
            "'",
            " namespace:='",
            LaunchConfiguration("namespace"),
            "'",
        ],
        on_stderr="warn",  # a warning of xacro does not end the launch
    )
    robot_description = {"robot_description": ParameterValue(xacro, value_type=str)}
    controllers_file = PathJoinSubstitution([FindPackageShare("picker"), "config/controllers.yaml"])

    # publishes the robot description and the transforms of its links
    state_publisher = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        namespace=namespace,
        parameters=[robot_description, {"use_sim_time": True, "frame_prefix": frame_prefix}],
    )

    world = PathJoinSubstitution([FindPackageShare("ros_gz_sim"), "launch", "gz_sim.launch.py"])
    server_only = PythonExpression(["'-s ' if '", LaunchConfiguration("headless"), "' == 'true' else ''"])
    gz_arguments = ["-r ", server_only, LaunchConfiguration("world")]
    simulator = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(world),
        launch_arguments={"gz_args": gz_arguments}.items(),
        condition=IfCondition(LaunchConfiguration("simulator")),
    )
    # publishes the simulator's clock in ROS
    clock = Node(
        package="ros_gz_bridge",
        executable="parameter_bridge",
        arguments=["/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"],
        condition=IfCondition(LaunchConfiguration("simulator")),
    )
    robot = Node(
        package="ros_gz_sim",
        executable="create",
        namespace=namespace,
        arguments=[
            "-topic",
            "robot_description",
            "-name",
            PythonExpression(["'", namespace, "' or 'picker'"]),
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
            "--param-file",
            controllers_file,
        ],
    )
    spawner_2 = Node(
        package="controller_manager",
        executable="spawner",
        namespace=namespace,
        arguments=[
            "base_controller",
            "arm_controller",
            "gripper_controller",
            "--controller-manager",
            "controller_manager",
            "--param-file",
            controllers_file,
        ],
    )

    return LaunchDescription(
        [
            DeclareLaunchArgument("reach", default_value="0.5"),
            DeclareLaunchArgument("namespace", default_value="", description="namespace of the robot; empty for none"),
            DeclareLaunchArgument("simulator", default_value="true", description="false: it runs already"),
            DeclareLaunchArgument("world", default_value="empty.sdf", description="world of the simulator"),
            DeclareLaunchArgument("headless", default_value="false", description="true: without a window"),
            DeclareLaunchArgument("x", default_value="0.0", description="x of the robot in the world, in m"),
            DeclareLaunchArgument("y", default_value="0.0", description="y of the robot in the world, in m"),
            DeclareLaunchArgument("z", default_value="0.01", description="z of the robot in the world, in m"),
            DeclareLaunchArgument("yaw", default_value="0.0", description="yaw of the robot in the world, in rad"),
            simulator,
            clock,
            state_publisher,
            robot,
            # each spawner waits for the one before it
            RegisterEventHandler(OnProcessExit(target_action=robot, on_exit=[spawner_1])),
            RegisterEventHandler(OnProcessExit(target_action=spawner_1, on_exit=[spawner_2])),
        ]
    )
