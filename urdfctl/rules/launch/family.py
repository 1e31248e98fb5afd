"""UC6: launch files and the packages around them."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.launch.argument_not_declared import argument_not_declared
from urdfctl.rules.launch.clock_not_bridged import clock_not_bridged
from urdfctl.rules.launch.clock_of_other_world import clock_of_other_world
from urdfctl.rules.launch.control_plugin_not_loaded import control_plugin_not_loaded
from urdfctl.rules.launch.controller_not_spawned import controller_not_spawned
from urdfctl.rules.launch.controller_spawned_twice import controller_spawned_twice
from urdfctl.rules.launch.controllers_never_loaded import controllers_never_loaded
from urdfctl.rules.launch.controllers_never_spawned import controllers_never_spawned
from urdfctl.rules.launch.described_by_macros_only import described_by_macros_only
from urdfctl.rules.launch.description_is_a_path import description_is_a_path
from urdfctl.rules.launch.description_not_published import description_not_published
from urdfctl.rules.launch.description_of_other_namespace import description_of_other_namespace
from urdfctl.rules.launch.description_read_as_yaml import description_read_as_yaml
from urdfctl.rules.launch.file_not_installed import file_not_installed
from urdfctl.rules.launch.include_argument_unknown import include_argument_unknown
from urdfctl.rules.launch.installed_file_missing import installed_file_missing
from urdfctl.rules.launch.joint_state_publisher_beside_broadcaster import joint_state_publisher_beside_broadcaster
from urdfctl.rules.launch.joint_states_of_nobody import joint_states_of_nobody
from urdfctl.rules.launch.joint_states_of_other_namespace import joint_states_of_other_namespace
from urdfctl.rules.launch.launch_file_of_ros1 import launch_file_of_ros1
from urdfctl.rules.launch.launched_file_missing import launched_file_missing
from urdfctl.rules.launch.listed_joint_unknown import listed_joint_unknown
from urdfctl.rules.launch.manager_beside_simulator import manager_beside_simulator
from urdfctl.rules.launch.manager_section_not_read import manager_section_not_read
from urdfctl.rules.launch.manager_without_clock import manager_without_clock
from urdfctl.rules.launch.mesh_not_on_model_path import mesh_not_on_model_path
from urdfctl.rules.launch.model_description_missing import model_description_missing
from urdfctl.rules.launch.model_never_spawned import model_never_spawned
from urdfctl.rules.launch.model_spawned_twice import model_spawned_twice
from urdfctl.rules.launch.node_name_twice import node_name_twice
from urdfctl.rules.launch.package_misspelt import package_misspelt
from urdfctl.rules.launch.package_not_in_manifest import package_not_in_manifest
from urdfctl.rules.launch.package_not_registered import package_not_registered
from urdfctl.rules.launch.parameters_not_given_to_controller import parameters_not_given_to_controller
from urdfctl.rules.launch.plugin_without_description import plugin_without_description
from urdfctl.rules.launch.program_unknown import program_unknown
from urdfctl.rules.launch.publisher_of_older_distro import publisher_of_older_distro
from urdfctl.rules.launch.publisher_without_description import publisher_without_description
from urdfctl.rules.launch.simulated_time_off import simulated_time_off
from urdfctl.rules.launch.simulation_paused import simulation_paused
from urdfctl.rules.launch.simulator_never_started import simulator_never_started
from urdfctl.rules.launch.spawned_controller_unknown import spawned_controller_unknown
from urdfctl.rules.launch.spawner_after_endless_program import spawner_after_endless_program
from urdfctl.rules.launch.spawner_of_other_manager import spawner_of_other_manager
from urdfctl.rules.launch.spawner_option_unknown import spawner_option_unknown
from urdfctl.rules.launch.spawner_program_gone import spawner_program_gone
from urdfctl.rules.launch.spawner_remapped import spawner_remapped
from urdfctl.rules.launch.spawner_without_manager import spawner_without_manager
from urdfctl.rules.launch.spawner_without_name import spawner_without_name
from urdfctl.rules.launch.xacro_command_malformed import xacro_command_malformed
from urdfctl.rules.launch.xacro_program_gone import xacro_program_gone

FAULTS: tuple[Fault, ...] = (
    package_not_registered,
    spawned_controller_unknown,
    controller_spawned_twice,
    controller_not_spawned,
    joint_state_publisher_beside_broadcaster,
    spawner_without_manager,
    spawner_of_other_manager,
    manager_beside_simulator,
    spawner_program_gone,
    spawner_option_unknown,
    parameters_not_given_to_controller,
    description_not_published,
    simulation_paused,
    description_of_other_namespace,
    package_not_in_manifest,
    file_not_installed,
    launched_file_missing,
    xacro_command_malformed,
    include_argument_unknown,
    listed_joint_unknown,
    xacro_program_gone,
    controllers_never_spawned,
    simulator_never_started,
    model_never_spawned,
    model_description_missing,
    controllers_never_loaded,
    clock_not_bridged,
    spawner_without_name,
    spawner_after_endless_program,
    publisher_without_description,
    argument_not_declared,
    described_by_macros_only,
    description_read_as_yaml,
    node_name_twice,
    joint_states_of_nobody,
    program_unknown,
    mesh_not_on_model_path,
    installed_file_missing,
    plugin_without_description,
    launch_file_of_ros1,
    manager_without_clock,
    clock_of_other_world,
    package_misspelt,
    control_plugin_not_loaded,
    publisher_of_older_distro,
    description_is_a_path,
    model_spawned_twice,
    spawner_remapped,
    joint_states_of_other_namespace,
    simulated_time_off,
    manager_section_not_read,
)
