"""UC2: ROS 1 transmissions."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.transmissions.actuator_interface_differs import actuator_interface_differs
from urdfctl.rules.transmissions.actuator_name_twice import actuator_name_twice
from urdfctl.rules.transmissions.actuator_without_mechanical_reduction import actuator_without_mechanical_reduction
from urdfctl.rules.transmissions.empty_hardware_interface import empty_hardware_interface
from urdfctl.rules.transmissions.hardware_interface_prefix_too_early import hardware_interface_prefix_too_early
from urdfctl.rules.transmissions.hardware_interface_unknown import hardware_interface_unknown
from urdfctl.rules.transmissions.hardware_interface_without_prefix import hardware_interface_without_prefix
from urdfctl.rules.transmissions.joint_in_two_transmissions import joint_in_two_transmissions
from urdfctl.rules.transmissions.joint_with_two_interfaces_in_gazebo import joint_with_two_interfaces_in_gazebo
from urdfctl.rules.transmissions.mechanical_reduction_unusable import mechanical_reduction_unusable
from urdfctl.rules.transmissions.mimic_joint_in_transmission import mimic_joint_in_transmission
from urdfctl.rules.transmissions.transmission_ends_miscounted import transmission_ends_miscounted
from urdfctl.rules.transmissions.transmission_joint_cannot_be_driven import transmission_joint_cannot_be_driven
from urdfctl.rules.transmissions.transmission_joint_unknown import transmission_joint_unknown
from urdfctl.rules.transmissions.transmission_joint_without_interface import transmission_joint_without_interface
from urdfctl.rules.transmissions.transmission_joints_with_different_interfaces import (
    transmission_joints_with_different_interfaces,
)
from urdfctl.rules.transmissions.transmission_name_twice import transmission_name_twice
from urdfctl.rules.transmissions.transmission_not_in_root import transmission_not_in_root
from urdfctl.rules.transmissions.transmission_of_two_joints_in_gazebo import transmission_of_two_joints_in_gazebo
from urdfctl.rules.transmissions.transmission_offset_unusable import transmission_offset_unusable
from urdfctl.rules.transmissions.transmission_part_not_read import transmission_part_not_read
from urdfctl.rules.transmissions.transmission_role_invalid import transmission_role_invalid
from urdfctl.rules.transmissions.transmission_type_unknown import transmission_type_unknown
from urdfctl.rules.transmissions.transmission_without_actuator import transmission_without_actuator
from urdfctl.rules.transmissions.transmission_without_joint import transmission_without_joint
from urdfctl.rules.transmissions.transmission_without_name import transmission_without_name
from urdfctl.rules.transmissions.transmission_without_type import transmission_without_type

FAULTS: tuple[Fault, ...] = (
    transmission_joint_without_interface,
    hardware_interface_without_prefix,
    hardware_interface_unknown,
    transmission_without_type,
    transmission_type_unknown,
    transmission_joint_unknown,
    transmission_joint_cannot_be_driven,
    joint_in_two_transmissions,
    transmission_name_twice,
    actuator_name_twice,
    transmission_without_actuator,
    actuator_without_mechanical_reduction,
    transmission_offset_unusable,
    transmission_role_invalid,
    transmission_ends_miscounted,
    transmission_of_two_joints_in_gazebo,
    joint_with_two_interfaces_in_gazebo,
    transmission_joints_with_different_interfaces,
    transmission_without_joint,
    transmission_without_name,
    transmission_not_in_root,
    actuator_interface_differs,
    empty_hardware_interface,
    mimic_joint_in_transmission,
    mechanical_reduction_unusable,
    hardware_interface_prefix_too_early,
    transmission_part_not_read,
)
