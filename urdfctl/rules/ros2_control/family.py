"""UC3: rules on the `<ros2_control>` tag."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.ros2_control.actuator_with_several_joints import actuator_with_several_joints
from urdfctl.rules.ros2_control.async_properties_malformed import async_properties_malformed
from urdfctl.rules.ros2_control.attribute_not_read import attribute_not_read
from urdfctl.rules.ros2_control.blanks_around_name import blanks_around_name
from urdfctl.rules.ros2_control.boolean_malformed import boolean_malformed
from urdfctl.rules.ros2_control.command_of_other_data_type import command_of_other_data_type
from urdfctl.rules.ros2_control.command_without_state import command_without_state
from urdfctl.rules.ros2_control.comment_breaks_parameter import comment_breaks_parameter
from urdfctl.rules.ros2_control.component_child_unknown import component_child_unknown
from urdfctl.rules.ros2_control.component_joint_fixed import component_joint_fixed
from urdfctl.rules.ros2_control.component_joint_unknown import component_joint_unknown
from urdfctl.rules.ros2_control.component_name_twice import component_name_twice
from urdfctl.rules.ros2_control.component_name_unusable import component_name_unusable
from urdfctl.rules.ros2_control.component_transmission_ends import component_transmission_ends
from urdfctl.rules.ros2_control.component_transmission_name_twice import component_transmission_name_twice
from urdfctl.rules.ros2_control.component_transmission_reduction import component_transmission_reduction
from urdfctl.rules.ros2_control.component_transmission_unknown import component_transmission_unknown
from urdfctl.rules.ros2_control.component_type_unknown import component_type_unknown
from urdfctl.rules.ros2_control.component_without_hardware import component_without_hardware
from urdfctl.rules.ros2_control.component_without_name import component_without_name
from urdfctl.rules.ros2_control.component_without_parts import component_without_parts
from urdfctl.rules.ros2_control.component_without_type import component_without_type
from urdfctl.rules.ros2_control.element_not_read import element_not_read
from urdfctl.rules.ros2_control.hardware_class_not_exported import hardware_class_not_exported
from urdfctl.rules.ros2_control.hardware_given_twice import hardware_given_twice
from urdfctl.rules.ros2_control.hardware_parameter_malformed import hardware_parameter_malformed
from urdfctl.rules.ros2_control.hardware_parameter_unknown import hardware_parameter_unknown
from urdfctl.rules.ros2_control.hardware_plugin_of_other_type import hardware_plugin_of_other_type
from urdfctl.rules.ros2_control.hardware_plugin_unknown import hardware_plugin_unknown
from urdfctl.rules.ros2_control.hardware_without_plugin import hardware_without_plugin
from urdfctl.rules.ros2_control.initial_value_malformed import initial_value_malformed
from urdfctl.rules.ros2_control.initial_value_of_joint import initial_value_of_joint
from urdfctl.rules.ros2_control.interface_data_type_unknown import interface_data_type_unknown
from urdfctl.rules.ros2_control.interface_limit_malformed import interface_limit_malformed
from urdfctl.rules.ros2_control.interface_limit_not_read import interface_limit_not_read
from urdfctl.rules.ros2_control.interface_limits_reversed import interface_limits_reversed
from urdfctl.rules.ros2_control.interface_limits_wider_than_urdf import interface_limits_wider_than_urdf
from urdfctl.rules.ros2_control.interface_name_misspelt import interface_name_misspelt
from urdfctl.rules.ros2_control.interface_of_two_parts import interface_of_two_parts
from urdfctl.rules.ros2_control.interface_size_malformed import interface_size_malformed
from urdfctl.rules.ros2_control.interface_twice import interface_twice
from urdfctl.rules.ros2_control.interface_unknown_to_hardware import interface_unknown_to_hardware
from urdfctl.rules.ros2_control.interface_without_name import interface_without_name
from urdfctl.rules.ros2_control.limits_without_enable import limits_without_enable
from urdfctl.rules.ros2_control.mimic_as_parameter import mimic_as_parameter
from urdfctl.rules.ros2_control.mimic_attribute_without_mimic import mimic_attribute_without_mimic
from urdfctl.rules.ros2_control.mimic_joint_commanded import mimic_joint_commanded
from urdfctl.rules.ros2_control.mimic_joint_not_in_component import mimic_joint_not_in_component
from urdfctl.rules.ros2_control.mimic_offset_not_applied import mimic_offset_not_applied
from urdfctl.rules.ros2_control.mimic_state_not_mimicked import mimic_state_not_mimicked
from urdfctl.rules.ros2_control.mimicked_joint_not_in_component import mimicked_joint_not_in_component
from urdfctl.rules.ros2_control.parameter_empty import parameter_empty
from urdfctl.rules.ros2_control.parameter_not_expanded import parameter_not_expanded
from urdfctl.rules.ros2_control.parameter_twice import parameter_twice
from urdfctl.rules.ros2_control.parameter_without_name import parameter_without_name
from urdfctl.rules.ros2_control.part_without_interfaces import part_without_interfaces
from urdfctl.rules.ros2_control.part_without_name import part_without_name
from urdfctl.rules.ros2_control.part_without_prefix import part_without_prefix
from urdfctl.rules.ros2_control.ros2_control_not_in_root import ros2_control_not_in_root
from urdfctl.rules.ros2_control.rw_rate_malformed import rw_rate_malformed
from urdfctl.rules.ros2_control.sensor_commanded import sensor_commanded
from urdfctl.rules.ros2_control.simulator_without_component import simulator_without_component
from urdfctl.rules.ros2_control.thread_priority_malformed import thread_priority_malformed
from urdfctl.rules.ros2_control.transmission_joint_not_in_component import transmission_joint_not_in_component
from urdfctl.rules.ros2_control.transmission_name_or_role_missing import transmission_name_or_role_missing
from urdfctl.rules.ros2_control.transmission_not_read_by_ros2 import transmission_not_read_by_ros2
from urdfctl.rules.ros2_control.transmission_of_ros1_in_component import transmission_of_ros1_in_component
from urdfctl.rules.ros2_control.transmission_without_plugin import transmission_without_plugin

FAULTS: tuple[Fault, ...] = (
    component_without_name,
    component_without_type,
    component_type_unknown,
    component_child_unknown,
    component_without_hardware,
    hardware_without_plugin,
    part_without_name,
    interface_without_name,
    parameter_without_name,
    component_name_twice,
    component_name_unusable,
    component_joint_unknown,
    component_joint_fixed,
    mimic_joint_commanded,
    mimicked_joint_not_in_component,
    mimic_attribute_without_mimic,
    boolean_malformed,
    limits_without_enable,
    interface_size_malformed,
    interface_data_type_unknown,
    rw_rate_malformed,
    thread_priority_malformed,
    async_properties_malformed,
    transmission_of_ros1_in_component,
    transmission_without_plugin,
    transmission_name_or_role_missing,
    transmission_joint_not_in_component,
    actuator_with_several_joints,
    ros2_control_not_in_root,
    transmission_not_read_by_ros2,
    initial_value_malformed,
    interface_limit_malformed,
    interface_limits_reversed,
    interface_limits_wider_than_urdf,
    part_without_interfaces,
    interface_twice,
    interface_of_two_parts,
    element_not_read,
    attribute_not_read,
    parameter_twice,
    mimic_as_parameter,
    initial_value_of_joint,
    sensor_commanded,
    hardware_given_twice,
    interface_name_misspelt,
    command_without_state,
    component_transmission_unknown,
    component_transmission_ends,
    component_transmission_reduction,
    component_transmission_name_twice,
    blanks_around_name,
    interface_limit_not_read,
    hardware_plugin_unknown,
    hardware_plugin_of_other_type,
    interface_unknown_to_hardware,
    hardware_parameter_unknown,
    hardware_parameter_malformed,
    command_of_other_data_type,
    comment_breaks_parameter,
    mimic_state_not_mimicked,
    simulator_without_component,
    component_without_parts,
    parameter_not_expanded,
    parameter_empty,
    part_without_prefix,
    mimic_joint_not_in_component,
    mimic_offset_not_applied,
    hardware_class_not_exported,
)
