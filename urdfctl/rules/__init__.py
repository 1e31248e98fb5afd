"""The rules. The list is explicit: what is not in it does not exist."""

from __future__ import annotations

from urdfctl.rule import Rule
from urdfctl.rules.reading.argument_unknown import argument_unknown
from urdfctl.rules.reading.argument_unused import argument_unused
from urdfctl.rules.reading.braces_without_dollar import braces_without_dollar
from urdfctl.rules.reading.condition_not_boolean import condition_not_boolean
from urdfctl.rules.reading.doctype_with_declarations import doctype_with_declarations
from urdfctl.rules.reading.expression_fails import expression_fails
from urdfctl.rules.reading.file_not_found import file_not_found
from urdfctl.rules.reading.file_unreadable import file_unreadable
from urdfctl.rules.reading.forbidden_expression import forbidden_expression
from urdfctl.rules.reading.macro_call_mismatch import macro_call_mismatch
from urdfctl.rules.reading.macro_defined_twice import macro_defined_twice
from urdfctl.rules.reading.outside_workspace import outside_workspace
from urdfctl.rules.reading.over_budget import over_budget
from urdfctl.rules.reading.package_not_found import package_not_found
from urdfctl.rules.reading.package_without_manifest import package_without_manifest
from urdfctl.rules.reading.rule_crashed import rule_crashed
from urdfctl.rules.reading.suppression_unused import suppression_unused
from urdfctl.rules.reading.undefined_argument import undefined_argument
from urdfctl.rules.reading.undefined_name import undefined_name
from urdfctl.rules.reading.unknown_macro import unknown_macro
from urdfctl.rules.reading.xacro_condition_repeated import xacro_condition_repeated
from urdfctl.rules.reading.xacro_fails import xacro_fails
from urdfctl.rules.reading.xacro_warns import xacro_warns
from urdfctl.rules.reading.xacro_prefix_missing import xacro_prefix_missing
from urdfctl.rules.reading.xml_not_well_formed import xml_not_well_formed
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
from urdfctl.rules.transmissions.transmission_role_invalid import transmission_role_invalid
from urdfctl.rules.transmissions.transmission_type_unknown import transmission_type_unknown
from urdfctl.rules.transmissions.transmission_without_actuator import transmission_without_actuator
from urdfctl.rules.transmissions.transmission_without_joint import transmission_without_joint
from urdfctl.rules.transmissions.transmission_without_name import transmission_without_name
from urdfctl.rules.transmissions.transmission_without_type import transmission_without_type
from urdfctl.rules.urdf.attribute_misspelt import attribute_misspelt
from urdfctl.rules.urdf.axis_zero import axis_zero
from urdfctl.rules.urdf.colour_malformed import colour_malformed
from urdfctl.rules.urdf.duplicate_joint import duplicate_joint
from urdfctl.rules.urdf.duplicate_link import duplicate_link
from urdfctl.rules.urdf.duplicate_material import duplicate_material
from urdfctl.rules.urdf.dynamics_empty import dynamics_empty
from urdfctl.rules.urdf.dynamics_negative import dynamics_negative
from urdfctl.rules.urdf.element_given_twice import element_given_twice
from urdfctl.rules.urdf.element_misspelt import element_misspelt
from urdfctl.rules.urdf.gazebo_reference_unknown import gazebo_reference_unknown
from urdfctl.rules.urdf.geometry_incomplete import geometry_incomplete
from urdfctl.rules.urdf.geometry_missing import geometry_missing
from urdfctl.rules.urdf.geometry_not_positive import geometry_not_positive
from urdfctl.rules.urdf.geometry_unknown import geometry_unknown
from urdfctl.rules.urdf.inertia_impossible import inertia_impossible
from urdfctl.rules.urdf.inertia_out_of_proportion import inertia_out_of_proportion
from urdfctl.rules.urdf.inertial_incomplete import inertial_incomplete
from urdfctl.rules.urdf.joint_number_malformed import joint_number_malformed
from urdfctl.rules.urdf.joint_type_not_moved import joint_type_not_moved
from urdfctl.rules.urdf.joint_type_unknown import joint_type_unknown
from urdfctl.rules.urdf.joint_without_limit import joint_without_limit
from urdfctl.rules.urdf.joint_without_name import joint_without_name
from urdfctl.rules.urdf.joint_without_parent_or_child import joint_without_parent_or_child
from urdfctl.rules.urdf.joint_without_type import joint_without_type
from urdfctl.rules.urdf.limit_incomplete import limit_incomplete
from urdfctl.rules.urdf.limits_leave_no_range import limits_leave_no_range
from urdfctl.rules.urdf.limits_reversed import limits_reversed
from urdfctl.rules.urdf.link_number_malformed import link_number_malformed
from urdfctl.rules.urdf.link_with_two_parents import link_with_two_parents
from urdfctl.rules.urdf.link_without_name import link_without_name
from urdfctl.rules.urdf.links_in_a_circle import links_in_a_circle
from urdfctl.rules.urdf.mass_not_positive import mass_not_positive
from urdfctl.rules.urdf.material_defined_otherwise import material_defined_otherwise
from urdfctl.rules.urdf.material_undefined import material_undefined
from urdfctl.rules.urdf.material_without_colour import material_without_colour
from urdfctl.rules.urdf.material_without_name import material_without_name
from urdfctl.rules.urdf.mesh_not_found import mesh_not_found
from urdfctl.rules.urdf.mesh_package_not_found import mesh_package_not_found
from urdfctl.rules.urdf.mesh_path_of_one_machine import mesh_path_of_one_machine
from urdfctl.rules.urdf.mesh_path_relative import mesh_path_relative
from urdfctl.rules.urdf.mimic_without_joint import mimic_without_joint
from urdfctl.rules.urdf.mimics_in_a_circle import mimics_in_a_circle
from urdfctl.rules.urdf.moving_link_without_inertial import moving_link_without_inertial
from urdfctl.rules.urdf.name_of_link_and_joint import name_of_link_and_joint
from urdfctl.rules.urdf.reserved_name import reserved_name
from urdfctl.rules.urdf.robot_version_unsupported import robot_version_unsupported
from urdfctl.rules.urdf.robot_without_links import robot_without_links
from urdfctl.rules.urdf.robot_without_name import robot_without_name
from urdfctl.rules.urdf.root_element_not_robot import root_element_not_robot
from urdfctl.rules.urdf.root_link_with_inertial import root_link_with_inertial
from urdfctl.rules.urdf.safety_without_k_velocity import safety_without_k_velocity
from urdfctl.rules.urdf.several_root_links import several_root_links
from urdfctl.rules.urdf.unknown_link import unknown_link
from urdfctl.rules.urdf.unknown_mimic_joint import unknown_mimic_joint
from urdfctl.rules.urdf.velocity_limit_zero import velocity_limit_zero

CRASHED = rule_crashed
OVER_BUDGET = over_budget
UNUSED_SUPPRESSION = suppression_unused

RULES: tuple[Rule, ...] = (
    rule_crashed,
    xml_not_well_formed,
    file_not_found,
    package_not_found,
    file_unreadable,
    doctype_with_declarations,
    undefined_name,
    undefined_argument,
    unknown_macro,
    macro_call_mismatch,
    expression_fails,
    condition_not_boolean,
    xacro_fails,
    xacro_warns,
    over_budget,
    forbidden_expression,
    outside_workspace,
    macro_defined_twice,
    xacro_prefix_missing,
    argument_unused,
    braces_without_dollar,
    argument_unknown,
    xacro_condition_repeated,
    package_without_manifest,
    suppression_unused,
    root_element_not_robot,
    robot_without_name,
    robot_version_unsupported,
    robot_without_links,
    several_root_links,
    links_in_a_circle,
    link_with_two_parents,
    link_without_name,
    joint_without_name,
    duplicate_link,
    duplicate_joint,
    duplicate_material,
    name_of_link_and_joint,
    reserved_name,
    joint_without_parent_or_child,
    unknown_link,
    unknown_mimic_joint,
    mimics_in_a_circle,
    mimic_without_joint,
    joint_without_type,
    joint_type_unknown,
    joint_type_not_moved,
    joint_without_limit,
    limit_incomplete,
    limits_reversed,
    axis_zero,
    joint_number_malformed,
    dynamics_empty,
    dynamics_negative,
    safety_without_k_velocity,
    velocity_limit_zero,
    limits_leave_no_range,
    moving_link_without_inertial,
    inertial_incomplete,
    mass_not_positive,
    inertia_impossible,
    inertia_out_of_proportion,
    root_link_with_inertial,
    link_number_malformed,
    geometry_missing,
    geometry_unknown,
    geometry_incomplete,
    geometry_not_positive,
    material_without_name,
    material_undefined,
    material_without_colour,
    colour_malformed,
    material_defined_otherwise,
    mesh_not_found,
    mesh_package_not_found,
    mesh_path_of_one_machine,
    mesh_path_relative,
    element_given_twice,
    element_misspelt,
    attribute_misspelt,
    gazebo_reference_unknown,
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
)
