"""Transmission types, their roles, and the hardware interfaces that ros_control and Gazebo accept."""

from __future__ import annotations

from urdfctl.startup.records import NamedTuple

PREFIX = "hardware_interface/"
PACKAGE = "transmission_interface/"


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
"""Other interfaces of package hardware_interface, available only on real hardware."""

ROS2_WORDS = {
    "effort": "EffortJointInterface",
    "position": "PositionJointInterface",
    "velocity": "VelocityJointInterface",
}
"""ROS 1 interfaces by the name that ROS 2 uses."""

JOINT_ROLES = ("joint1", "joint2")
ACTUATOR_ROLES = ("actuator1", "actuator2")

ROLES = {"joint": JOINT_ROLES, "actuator": ACTUATOR_ROLES}
"""Roles by the kind of a transmission's end."""


class TransmissionNeeds(NamedTuple):
    """What a transmission type requires (its *_transmission_loader.cpp)."""

    joints: int
    """How many joints it has."""
    actuators: int
    """How many actuators it has."""
    has_roles: bool
    """Whether each end needs a `<role>`."""


TYPES = {
    "transmission_interface/SimpleTransmission": TransmissionNeeds(1, 1, has_roles=False),
    "transmission_interface/DifferentialTransmission": TransmissionNeeds(2, 2, has_roles=True),
    "transmission_interface/FourBarLinkageTransmission": TransmissionNeeds(2, 2, has_roles=True),
}

NO_PLUGIN_TYPES = (PACKAGE, PREFIX, "pr2_mechanism_model/")
"""Packages that have no transmission types other than those in TYPES."""
