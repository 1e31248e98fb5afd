"""The public repositories of packages that robots are most often made of, for each generation of ROS."""

from __future__ import annotations

_URL = "https://github.com/"
_BOTH = {
    "realsense2_description": "IntelRealSense/realsense-ros",
    "turtlebot3_description": "ROBOTIS-GIT/turtlebot3",
    "ur_client_library": "UniversalRobots/Universal_Robots_Client_Library",
}
_PACKAGES: dict[int, dict[str, str]] = {
    1: {
        "franka_description": "frankaemika/franka_ros",
        "husky_description": "husky/husky",
        "kortex_description": "Kinovarobotics/ros_kortex",
        "pr2_description": "PR2/pr2_common",
        "ur_description": "ros-industrial/universal_robot",
    },
    2: {
        "franka_description": "frankaemika/franka_description",
        "irobot_create_description": "iRobotEducation/create3_sim",
        "kortex_description": "Kinovarobotics/ros2_kortex",
        "kortex_driver": "Kinovarobotics/ros2_kortex",
        "lbr_description": "lbr-stack/lbr_fri_ros2_stack",
        "robotiq_controllers": "PickNikRobotics/ros2_robotiq_gripper",
        "robotiq_description": "PickNikRobotics/ros2_robotiq_gripper",
        "robotiq_driver": "PickNikRobotics/ros2_robotiq_gripper",
        "turtlebot4_description": "turtlebot/turtlebot4",
        "ur_controllers": "UniversalRobots/Universal_Robots_ROS2_Driver",
        "ur_description": "UniversalRobots/Universal_Robots_ROS2_Description",
        "ur_moveit_config": "UniversalRobots/Universal_Robots_ROS2_Driver",
        "ur_robot_driver": "UniversalRobots/Universal_Robots_ROS2_Driver",
        "ur_simulation_gz": "UniversalRobots/Universal_Robots_ROS2_GZ_Simulation",
        "xarm_description": "xArm-Developer/xarm_ros2",
    },
}


def repository_of(package: str, ros: int | None) -> str | None:
    """Return the address of the repository that has a package for a generation of ROS; None if it is not known."""
    named = _BOTH.get(package) or _PACKAGES.get(ros or 0, {}).get(package)
    return f"{_URL}{named}" if named else None
