"""What ros_control's readers of transmissions take: types with their ends and roles, and hardware interfaces."""

from __future__ import annotations

from urdfctl.record import NamedTuple

PREFIX = "hardware_interface/"
PACKAGE = "transmission_interface/"

GAZEBO_INTERFACES = ("EffortJointInterface", "PositionJointInterface", "VelocityJointInterface")
"""Those that gazebo_ros_control's DefaultRobotHWSim knows (default_robot_hw_sim.cpp)."""

HARDWARE_INTERFACES = (
    "JointStateInterface",
    "PosVelJointInterface",
    "PosVelAccJointInterface",
    "PositionVelocityTorqueGainsJointInterface",
    "JointModeInterface",
    "BiDirectionalPositionJointInterface",
    "BiDirectionalVelocityJointInterface",
    "BiDirectionalEffortJointInterface",
    "JointTrajectoryInterface",
    "CartesianTrajectoryInterface",
)
"""Further ones of the package hardware_interface, which only real hardware can have."""

ROS2_WORDS = {
    "effort": "EffortJointInterface",
    "position": "PositionJointInterface",
    "velocity": "VelocityJointInterface",
}
"""What ROS 2 calls the interfaces of a joint."""

JOINT_ROLES = ("joint1", "joint2")
ACTUATOR_ROLES = ("actuator1", "actuator2")

ROLES = {"joint": JOINT_ROLES, "actuator": ACTUATOR_ROLES}
"""By the kind of a transmission's end."""


class TransmissionType(NamedTuple):
    """How many ends of each side a type wants, and whether they have roles (its *_transmission_loader.cpp)."""

    joints: int
    actuators: int
    has_roles: bool


TYPES = {
    "transmission_interface/SimpleTransmission": TransmissionType(1, 1, has_roles=False),
    "transmission_interface/DifferentialTransmission": TransmissionType(2, 2, has_roles=True),
    "transmission_interface/FourBarLinkageTransmission": TransmissionType(2, 2, has_roles=True),
}

NO_PLUGIN_TYPES = (PACKAGE, PREFIX, "pr2_mechanism_model/")
"""Packages that bring no transmission type but those in TYPES."""
