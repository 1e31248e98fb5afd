"""UC3: the `<ros2_control>` tag."""

from __future__ import annotations

from urdfctl.rule import Rule
from urdfctl.rules.ros2_control.actuator_with_several_joints import actuator_with_several_joints
from urdfctl.rules.ros2_control.async_properties_malformed import async_properties_malformed
from urdfctl.rules.ros2_control.boolean_malformed import boolean_malformed
from urdfctl.rules.ros2_control.component_child_unknown import component_child_unknown
from urdfctl.rules.ros2_control.component_joint_fixed import component_joint_fixed
from urdfctl.rules.ros2_control.component_joint_unknown import component_joint_unknown
from urdfctl.rules.ros2_control.component_name_twice import component_name_twice
from urdfctl.rules.ros2_control.component_name_unusable import component_name_unusable
from urdfctl.rules.ros2_control.component_type_unknown import component_type_unknown
from urdfctl.rules.ros2_control.component_without_hardware import component_without_hardware
from urdfctl.rules.ros2_control.component_without_name import component_without_name
from urdfctl.rules.ros2_control.component_without_type import component_without_type
from urdfctl.rules.ros2_control.hardware_without_plugin import hardware_without_plugin
from urdfctl.rules.ros2_control.interface_data_type_unknown import interface_data_type_unknown
from urdfctl.rules.ros2_control.interface_size_malformed import interface_size_malformed
from urdfctl.rules.ros2_control.interface_without_name import interface_without_name
from urdfctl.rules.ros2_control.limits_without_enable import limits_without_enable
from urdfctl.rules.ros2_control.mimic_attribute_without_mimic import mimic_attribute_without_mimic
from urdfctl.rules.ros2_control.mimic_joint_commanded import mimic_joint_commanded
from urdfctl.rules.ros2_control.mimicked_joint_not_in_component import mimicked_joint_not_in_component
from urdfctl.rules.ros2_control.parameter_without_name import parameter_without_name
from urdfctl.rules.ros2_control.part_without_name import part_without_name
from urdfctl.rules.ros2_control.ros2_control_not_in_root import ros2_control_not_in_root
from urdfctl.rules.ros2_control.rw_rate_malformed import rw_rate_malformed
from urdfctl.rules.ros2_control.thread_priority_malformed import thread_priority_malformed
from urdfctl.rules.ros2_control.transmission_joint_not_in_component import transmission_joint_not_in_component
from urdfctl.rules.ros2_control.transmission_name_or_role_missing import transmission_name_or_role_missing
from urdfctl.rules.ros2_control.transmission_not_read_by_ros2 import transmission_not_read_by_ros2
from urdfctl.rules.ros2_control.transmission_of_ros1_in_component import transmission_of_ros1_in_component
from urdfctl.rules.ros2_control.transmission_without_plugin import transmission_without_plugin

RULES: tuple[Rule, ...] = (
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
)
