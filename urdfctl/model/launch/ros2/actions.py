"""The actions of launch files by their names: what each is to a robot and its controllers, and whether it runs."""

from __future__ import annotations

from urdfctl.startup.records import NamedTuple

WITHOUT_CONTROLLERS = frozenset(
    "nav2_bringup slam_toolbox ros_gz_bridge foxglove_bridge rosbridge_server realsense2_camera rplidar_ros joy "
    "teleop_twist_joy robot_localization turtlebot3_navigation2 velodyne usb_cam moveit_servo rviz2 depthai_ros_driver "
    "sick_scan_xd ldlidar_stl_ros2 urg_node micro_ros_agent urdf_launch launch_testing_ament_cmake".split()
)
"""Packages whose launch files start no controllers, in addition to the simulators."""
HARMLESS = frozenset(
    (
        "LogInfo Shutdown EmitEvent SetEnvironmentVariable AppendEnvironmentVariable UnsetEnvironmentVariable "
        "PrependEnvironmentVariable SetROSLogDir "
        "UnregisterEventHandler ResetEnvironment PushEnvironment PopEnvironment LifecycleTransition "
        "UnsetLaunchConfiguration ReadyToTest AppendEnvironment"
    ).split()
)
"""Actions that have no effect on a robot and its controllers."""
ALTERING = frozenset({"SetParameter", "SetParametersFromFile", "SetRemap", "SetUseSimTime"})
"""Actions that change the parameters or remappings of all following nodes."""
NODES = frozenset({"Node", "LifecycleNode"})
PROCESSES = frozenset({"ExecuteProcess", "ExecuteLocal"})
HANDLERS = {"OnProcessExit": "on_exit", "OnProcessStart": "on_start", "OnExecutionComplete": "on_completion"}
"""Event handlers, and the argument with their actions."""
LATER = frozenset({"RegisterEventHandler", "RosTimer", "ROSTimer", "TimerAction"})
"""Actions whose own actions run when all the rest has run."""
SPAWNING = frozenset(
    (
        "generate_load_controller_launch_description generate_controllers_spawner_launch_description "
        "generate_controllers_spawner_launch_description_from_dict"
    ).split()
)
"""Functions of controller_manager.launch_utils that make a spawner."""


class State(NamedTuple):
    """The state for an action.

    sure: False if an unknown condition decides whether it runs.
    held: False if it runs only with other launch arguments.
    after: controllers whose spawner exits before it runs.
    depth: depth of nested actions and includes.
    """

    sure: bool = True
    held: bool = True
    after: tuple[str, ...] = ()
    depth: int = 0
