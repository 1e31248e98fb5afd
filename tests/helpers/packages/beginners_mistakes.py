"""A beginner's mistakes, one at a time, in two packages that work: what is written instead of what."""

from __future__ import annotations

from typing import NamedTuple

ROBOT = "urdf/tern.urdf.xacro"
CONFIG = "config/controllers.yaml"
LAUNCH = "launch/sim.launch"
MANIFEST = "package.xml"
GZ_ROBOT = "urdf/kite.urdf.xacro"
GZ_LAUNCH = "launch/sim.launch.py"
INTERFACE = "        <hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface>\n"
CLASSIC = """\
  <gazebo>
    <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
  </gazebo>
"""
GZ = """\
  <gazebo>
    <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
      <parameters>$(find kite)/config/controllers.yaml</parameters>
    </plugin>
  </gazebo>
"""
HARDWARE = """\
    <hardware>
      <plugin>gz_ros2_control/GazeboSimSystem</plugin>
    </hardware>
"""
TYPE = """\
    arm_controller:
      type: joint_trajectory_controller/JointTrajectoryController
"""


class Mistake(NamedTuple):
    """What is written instead of a text; what must be told first; which fix repairs it: safe, unsafe or none."""

    file: str
    right: str
    wrong: str
    code: str
    told: str
    fix: str = ""


IN_BASE = [
    Mistake(ROBOT, "VelocityJointInterface", "VelocityJointInterfce", "UC203", "VelocityJointInterfce", "safe"),
    Mistake(ROBOT, INTERFACE, "", "UC201", "left_wheel_joint", "safe"),
    Mistake(ROBOT, CLASSIC, "", "UC643", "no <plugin>", "unsafe"),
    Mistake(ROBOT, "${wheel_radius}", "${whel_radius}", "UC006", "whel_radius", "safe"),
    Mistake(ROBOT, '<child link="caster"/>', '<child link="castor"/>', "UC116", "castor", "safe"),
    Mistake(CONFIG, "left_wheel: left_wheel_joint", "left_wheel: left_weel_joint", "UC440", "left_weel_joint", "safe"),
    Mistake(CONFIG, "DiffDriveController", "DiffDriveControler", "UC421", "DiffDriveControler", "safe"),
    Mistake(LAUNCH, " drive_controller", " diff_controller", "UC601", "diff_controller", "unsafe"),
    Mistake(LAUNCH, "config/controllers.yaml", "config/controler.yaml", "UC616", "controler.yaml", "unsafe"),
    Mistake(LAUNCH, "$(find tern)/urdf", "$(find terns)/urdf", "UC642", "terns", "safe"),
    Mistake(ROBOT, 'type="continuous"', 'type="continous"', "UC121", "continous", "safe"),
    Mistake(ROBOT, "SimpleTransmission", "SimpleTransmision", "UC205", "SimpleTransmision", "safe"),
]
IN_ARM = [
    Mistake(GZ_ROBOT, "GazeboSimSystem", "GazeboSystem", "UC353", "GazeboSystem", "unsafe"),
    Mistake(GZ_ROBOT, GZ, "", "UC508", "gz_ros2_control/GazeboSimSystem", "unsafe"),
    Mistake(GZ_ROBOT, HARDWARE, "", "UC305", "kite_hardware", "unsafe"),
    Mistake(GZ_ROBOT, "control-system", "control-systm", "UC503", "gz_ros2_control-systm", "safe"),
    Mistake(CONFIG, "- elbow", "- elbw", "UC440", "elbw", "safe"),
    Mistake(CONFIG, "- position\n    state", "- velocity\n    state", "UC450", "velocity"),
    Mistake(CONFIG, "ros__parameters:\n    joints", "ros_parameters:\n    joints", "UC403", "ros_parameters", "safe"),
    Mistake(CONFIG, TYPE, "", "UC420", "arm_controller"),
    Mistake(GZ_LAUNCH, '"arm_controller"]', '"arm_controler"]', "UC601", "arm_controler", "safe"),
    Mistake(GZ_ROBOT, 'child="hand"', 'chld="hand"', "UC009", "chld", "safe"),
    Mistake(GZ_ROBOT, '<joint name="elbow">', '<joint name="elbow_joint">', "UC312", "elbow_joint", "unsafe"),
    Mistake(GZ_ROBOT, "config/controllers.yaml", "config/controller.yaml", "UC520", "controller.yaml", "safe"),
    Mistake(MANIFEST, "  <exec_depend>joint_trajectory_controller</exec_depend>\n", "", "UC614", "joint_traj", "safe"),
]
