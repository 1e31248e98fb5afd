"""UC1: URDF structure and values, as read by urdfdom, KDL, sdformat and the physics engines."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.urdf.attribute_misspelt import attribute_misspelt
from urdfctl.rules.urdf.axis_zero import axis_zero
from urdfctl.rules.urdf.colour_malformed import colour_malformed
from urdfctl.rules.urdf.dollar_in_name import dollar_in_name
from urdfctl.rules.urdf.duplicate_joint import duplicate_joint
from urdfctl.rules.urdf.duplicate_link import duplicate_link
from urdfctl.rules.urdf.duplicate_material import duplicate_material
from urdfctl.rules.urdf.dynamics_empty import dynamics_empty
from urdfctl.rules.urdf.dynamics_negative import dynamics_negative
from urdfctl.rules.urdf.effort_limit_zero import effort_limit_zero
from urdfctl.rules.urdf.element_given_twice import element_given_twice
from urdfctl.rules.urdf.element_in_wrong_place import element_in_wrong_place
from urdfctl.rules.urdf.element_misspelt import element_misspelt
from urdfctl.rules.urdf.gazebo_reference_unknown import gazebo_reference_unknown
from urdfctl.rules.urdf.geometry_incomplete import geometry_incomplete
from urdfctl.rules.urdf.geometry_missing import geometry_missing
from urdfctl.rules.urdf.geometry_not_positive import geometry_not_positive
from urdfctl.rules.urdf.geometry_unknown import geometry_unknown
from urdfctl.rules.urdf.inertia_impossible import inertia_impossible
from urdfctl.rules.urdf.inertia_out_of_proportion import inertia_out_of_proportion
from urdfctl.rules.urdf.inertia_zero import inertia_zero
from urdfctl.rules.urdf.inertial_incomplete import inertial_incomplete
from urdfctl.rules.urdf.joint_number_malformed import joint_number_malformed
from urdfctl.rules.urdf.joint_type_not_moved import joint_type_not_moved
from urdfctl.rules.urdf.joint_type_unknown import joint_type_unknown
from urdfctl.rules.urdf.joint_without_limit import joint_without_limit
from urdfctl.rules.urdf.joint_without_name import joint_without_name
from urdfctl.rules.urdf.joint_without_parent_or_child import joint_without_parent_or_child
from urdfctl.rules.urdf.joint_without_type import joint_without_type
from urdfctl.rules.urdf.limit_in_degrees import limit_in_degrees
from urdfctl.rules.urdf.limit_incomplete import limit_incomplete
from urdfctl.rules.urdf.limit_negative import limit_negative
from urdfctl.rules.urdf.limits_leave_no_range import limits_leave_no_range
from urdfctl.rules.urdf.limits_reversed import limits_reversed
from urdfctl.rules.urdf.link_named_without_prefix import link_named_without_prefix
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
from urdfctl.rules.urdf.mimic_joint_stands_still import mimic_joint_stands_still
from urdfctl.rules.urdf.mimic_range_beyond_limits import mimic_range_beyond_limits
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
from urdfctl.rules.urdf.rotation_in_degrees import rotation_in_degrees
from urdfctl.rules.urdf.safety_stops_joint import safety_stops_joint
from urdfctl.rules.urdf.safety_without_k_velocity import safety_without_k_velocity
from urdfctl.rules.urdf.several_root_links import several_root_links
from urdfctl.rules.urdf.unknown_link import unknown_link
from urdfctl.rules.urdf.unknown_mimic_joint import unknown_mimic_joint
from urdfctl.rules.urdf.urdf_attribute_not_read import urdf_attribute_not_read
from urdfctl.rules.urdf.velocity_limit_zero import velocity_limit_zero

FAULTS: tuple[Fault, ...] = (
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
    link_named_without_prefix,
    inertia_zero,
    dollar_in_name,
    mimic_range_beyond_limits,
    effort_limit_zero,
    element_in_wrong_place,
    urdf_attribute_not_read,
    limit_negative,
    safety_stops_joint,
    mimic_joint_stands_still,
    limit_in_degrees,
    rotation_in_degrees,
)
