"""Public robots without any control."""

from __future__ import annotations

ROBOTS = {
    "ANYbotics__anymal_b_simple_description/urdf/anymal.urdf": "effort noetic gazebo-classic",
    "Abraheem-1__my_robot_description/urdf/my_robot.xacro": "diff_drive jazzy none",
    "Kinovarobotics__ros2_kortex/kortex_description/grippers/gen3_lite_2f/urdf/"
    "GEN3-LITE-GRIPPER_URDF_SIMPLIFIED_V2.urdf": "gripper jazzy none",
    "LeoRover__leo_common/leo_description/urdf/leo.urdf.xacro": "velocity jazzy gz",
    "PR2__pr2_common/pr2_description/robots/pr2.urdf.xacro": "trajectory kilted none",
    "ROBOTIS-GIT__turtlebot3/turtlebot3_description/urdf/turtlebot3_burger.urdf": "diff_drive rolling gz",
    "UW-RoboSoccer__my_robot_description/urdf/robot.urdf": "velocity humble none",
    "caesar753__braccio_moveit_gazebo_noetic/braccio_description/urdf/xacros/braccio_arm.xacro": (
        "trajectory noetic gazebo-classic"
    ),
    "cambel__ur3/ur_pykdl/urdf/ur3.urdf": "trajectory jazzy mujoco",
    "chenzixin-zn__my_robot_description/urdf/robots/nero/nero_description.urdf": "trajectory humble gazebo-classic",
    "clearpathrobotics__spot_ros/spot_description/urdf/spot.urdf.xacro": "position jazzy gz",
    "davetcoleman__clam/clam_description/urdf/clam.urdf": "position kinetic gazebo-classic",
    "doosan-robotics__doosan-robot2/dsr_description2/urdf/m1013.white.urdf": "trajectory jazzy gz",
    "frankaemika__franka_description/robots/fp3/fp3.urdf.xacro": "trajectory lyrical gz",
    "frankaemika__franka_description/robots/fer/fer.urdf.xacro": "effort melodic gazebo-classic",
    "linorobot__linorobot2/linorobot2_description/urdf/robots/2wd.urdf.xacro": "diff_drive jazzy none",
    "linorobot__linorobot2/linorobot2_description/urdf/robots/4wd.urdf.xacro": "velocity iron none",
    "linorobot__linorobot2/linorobot2_description/urdf/robots/mecanum.urdf.xacro": "mecanum jazzy none",
    "moveit__moveit_resources/panda_description/urdf/panda.urdf": "admittance jazzy none",
    "noshluk2__ROS2-Ultimate-learners-Repository/bazu/urdf/bazu.urdf": "position foxy gazebo-classic",
    "open-dynamic-robot-initiative__robot_properties_solo/src/robot_properties_solo/resources/xacro/"
    "solo12.urdf.xacro": "effort jazzy gz",
    "ros-industrial__abb/abb_irb2400_support/urdf/irb2400.xacro": "trajectory noetic gazebo-classic",
    "ros-industrial__motoman/motoman_gp7_support/urdf/gp7.xacro": "velocity noetic gazebo-classic",
    "ros-industrial__robotiq/robotiq_2f_c2_gripper_visualization/urdf/robotiq_c2_model.xacro": "gripper noetic none",
    "unitreerobotics__unitree_ros/robots/go2_description/urdf/go2_description.urdf": "pid jazzy mujoco",
    "yujinrobot__kobuki/kobuki_description/urdf/kobuki_standalone.urdf.xacro": "diff_drive noetic none",
}
