"""UC5: rules on the plugins that bring a robot into a simulator."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.simulation.bridge_types_unknown import bridge_types_unknown
from urdfctl.rules.simulation.control_period_not_positive import control_period_not_positive
from urdfctl.rules.simulation.control_plugin_in_reference import control_plugin_in_reference
from urdfctl.rules.simulation.control_plugin_missing import control_plugin_missing
from urdfctl.rules.simulation.control_plugin_twice import control_plugin_twice
from urdfctl.rules.simulation.controllers_file_missing import controllers_file_missing
from urdfctl.rules.simulation.controllers_of_other_namespace import controllers_of_other_namespace
from urdfctl.rules.simulation.controllers_path_not_expanded import controllers_path_not_expanded
from urdfctl.rules.simulation.controllers_path_of_one_machine import controllers_path_of_one_machine
from urdfctl.rules.simulation.controllers_path_relative import controllers_path_relative
from urdfctl.rules.simulation.drive_wheels_impossible import drive_wheels_impossible
from urdfctl.rules.simulation.drive_wheels_unmeasured import drive_wheels_unmeasured
from urdfctl.rules.simulation.hardware_not_simulated import hardware_not_simulated
from urdfctl.rules.simulation.hardware_of_other_simulator import hardware_of_other_simulator
from urdfctl.rules.simulation.joint_driven_twice import joint_driven_twice
from urdfctl.rules.simulation.legacy_mode_not_given import legacy_mode_not_given
from urdfctl.rules.simulation.manager_without_parameters import manager_without_parameters
from urdfctl.rules.simulation.plugin_class_unknown import plugin_class_unknown
from urdfctl.rules.simulation.plugin_filename_misspelt import plugin_filename_misspelt
from urdfctl.rules.simulation.plugin_joint_unknown import plugin_joint_unknown
from urdfctl.rules.simulation.plugin_link_unknown import plugin_link_unknown
from urdfctl.rules.simulation.plugin_of_other_ros import plugin_of_other_ros
from urdfctl.rules.simulation.plugin_of_other_simulator import plugin_of_other_simulator
from urdfctl.rules.simulation.plugin_setting_malformed import plugin_setting_malformed
from urdfctl.rules.simulation.plugin_setting_missing import plugin_setting_missing
from urdfctl.rules.simulation.plugin_setting_misspelt import plugin_setting_misspelt
from urdfctl.rules.simulation.plugin_setting_unknown import plugin_setting_unknown
from urdfctl.rules.simulation.plugin_without_filename import plugin_without_filename
from urdfctl.rules.simulation.plugin_without_name import plugin_without_name
from urdfctl.rules.simulation.robot_sim_type_unknown import robot_sim_type_unknown
from urdfctl.rules.simulation.sensor_plugin_outside_sensor import sensor_plugin_outside_sensor
from urdfctl.rules.simulation.sensor_type_not_simulated import sensor_type_not_simulated
from urdfctl.rules.simulation.spawner_of_other_namespace import spawner_of_other_namespace
from urdfctl.rules.simulation.wheel_pairs_miscounted import wheel_pairs_miscounted

FAULTS: tuple[Fault, ...] = (
    plugin_without_filename,
    plugin_without_name,
    plugin_filename_misspelt,
    plugin_of_other_ros,
    plugin_class_unknown,
    hardware_of_other_simulator,
    hardware_not_simulated,
    control_plugin_missing,
    control_plugin_twice,
    control_plugin_in_reference,
    plugin_setting_misspelt,
    plugin_setting_unknown,
    plugin_setting_missing,
    plugin_setting_malformed,
    plugin_joint_unknown,
    plugin_link_unknown,
    drive_wheels_unmeasured,
    drive_wheels_impossible,
    joint_driven_twice,
    controllers_file_missing,
    controllers_path_not_expanded,
    controllers_path_relative,
    manager_without_parameters,
    controllers_of_other_namespace,
    spawner_of_other_namespace,
    robot_sim_type_unknown,
    legacy_mode_not_given,
    control_period_not_positive,
    wheel_pairs_miscounted,
    sensor_plugin_outside_sensor,
    controllers_path_of_one_machine,
    sensor_type_not_simulated,
    bridge_types_unknown,
    plugin_of_other_simulator,
)
