"""UC4: errors in controller files."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.controllers.alias_in_parameters import alias_in_parameters
from urdfctl.rules.controllers.base_frame_not_a_link import base_frame_not_a_link
from urdfctl.rules.controllers.collection_empty import collection_empty
from urdfctl.rules.controllers.controller_faster_than_manager import controller_faster_than_manager
from urdfctl.rules.controllers.controller_joint_fixed import controller_joint_fixed
from urdfctl.rules.controllers.controller_joint_unknown import controller_joint_unknown
from urdfctl.rules.controllers.controller_name_unusable import controller_name_unusable
from urdfctl.rules.controllers.controller_type_missing import controller_type_missing
from urdfctl.rules.controllers.controller_type_not_catalogued import controller_type_not_catalogued
from urdfctl.rules.controllers.controller_type_not_in_distro import controller_type_not_in_distro
from urdfctl.rules.controllers.controller_type_of_other_ros import controller_type_of_other_ros
from urdfctl.rules.controllers.controller_type_unknown import controller_type_unknown
from urdfctl.rules.controllers.controllers_file_not_a_map import controllers_file_not_a_map
from urdfctl.rules.controllers.controllers_file_of_ros1 import controllers_file_of_ros1
from urdfctl.rules.controllers.controllers_file_of_ros2 import controllers_file_of_ros2
from urdfctl.rules.controllers.extra_joint_ignored import extra_joint_ignored
from urdfctl.rules.controllers.fallback_controller_unknown import fallback_controller_unknown
from urdfctl.rules.controllers.filter_chain_unusable import filter_chain_unusable
from urdfctl.rules.controllers.hardware_component_unknown import hardware_component_unknown
from urdfctl.rules.controllers.joint_for_joints import joint_for_joints
from urdfctl.rules.controllers.joint_named_twice import joint_named_twice
from urdfctl.rules.controllers.joint_unlike_its_controller import joint_unlike_its_controller
from urdfctl.rules.controllers.joint_without_number import joint_without_number
from urdfctl.rules.controllers.list_of_several_types import list_of_several_types
from urdfctl.rules.controllers.manager_name_misspelt import manager_name_misspelt
from urdfctl.rules.controllers.map_in_list import map_in_list
from urdfctl.rules.controllers.node_name_unusable import node_name_unusable
from urdfctl.rules.controllers.parameter_deprecated import parameter_deprecated
from urdfctl.rules.controllers.parameter_missing import parameter_missing
from urdfctl.rules.controllers.parameter_of_no_element import parameter_of_no_element
from urdfctl.rules.controllers.parameter_of_other_distro import parameter_of_other_distro
from urdfctl.rules.controllers.parameter_of_wrong_type import parameter_of_wrong_type
from urdfctl.rules.controllers.parameter_refused import parameter_refused
from urdfctl.rules.controllers.parameter_unknown import parameter_unknown
from urdfctl.rules.controllers.parameter_without_effect import parameter_without_effect
from urdfctl.rules.controllers.parameters_not_fitting import parameters_not_fitting
from urdfctl.rules.controllers.parameters_under_manager import parameters_under_manager
from urdfctl.rules.controllers.ros_parameters_missing import ros_parameters_missing
from urdfctl.rules.controllers.ros_parameters_nested import ros_parameters_nested
from urdfctl.rules.controllers.ros_parameters_not_a_map import ros_parameters_not_a_map
from urdfctl.rules.controllers.section_not_read import section_not_read
from urdfctl.rules.controllers.several_documents import several_documents
from urdfctl.rules.controllers.stand_in_left import stand_in_left
from urdfctl.rules.controllers.update_rate_missing import update_rate_missing
from urdfctl.rules.controllers.value_missing import value_missing
from urdfctl.rules.controllers.value_not_for_parameter_server import value_not_for_parameter_server
from urdfctl.rules.controllers.wheel_radius_not_in_robot import wheel_radius_not_in_robot
from urdfctl.rules.controllers.wheels_on_wrong_sides import wheels_on_wrong_sides
from urdfctl.rules.controllers.wildcard_wins import wildcard_wins

FAULTS: tuple[Fault, ...] = (
    controllers_file_of_ros1,
    controllers_file_of_ros2,
    ros_parameters_missing,
    ros_parameters_nested,
    alias_in_parameters,
    value_missing,
    collection_empty,
    list_of_several_types,
    map_in_list,
    ros_parameters_not_a_map,
    node_name_unusable,
    controllers_file_not_a_map,
    several_documents,
    value_not_for_parameter_server,
    parameters_under_manager,
    section_not_read,
    wildcard_wins,
    fallback_controller_unknown,
    hardware_component_unknown,
    controller_type_missing,
    controller_type_unknown,
    controller_type_not_in_distro,
    controller_type_of_other_ros,
    controller_type_not_catalogued,
    joint_without_number,
    update_rate_missing,
    controller_faster_than_manager,
    controller_name_unusable,
    manager_name_misspelt,
    parameter_unknown,
    parameter_missing,
    parameter_of_wrong_type,
    parameter_refused,
    parameters_not_fitting,
    parameter_deprecated,
    parameter_of_other_distro,
    parameter_of_no_element,
    parameter_without_effect,
    filter_chain_unusable,
    controller_joint_unknown,
    controller_joint_fixed,
    extra_joint_ignored,
    joint_named_twice,
    joint_for_joints,
    base_frame_not_a_link,
    wheels_on_wrong_sides,
    wheel_radius_not_in_robot,
    joint_unlike_its_controller,
    stand_in_left,
)
