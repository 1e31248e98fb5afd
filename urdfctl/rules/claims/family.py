"""UC4: errors in the interplay of a robot's controllers: claims, chains and conflicts."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.claims.chained_controller_exports_nothing import chained_controller_exports_nothing
from urdfctl.rules.claims.chained_controller_not_started import chained_controller_not_started
from urdfctl.rules.claims.chained_interface_not_exported import chained_interface_not_exported
from urdfctl.rules.claims.claimed_name_empty import claimed_name_empty
from urdfctl.rules.claims.command_interface_not_exported import command_interface_not_exported
from urdfctl.rules.claims.command_overridden_in_simulator import command_overridden_in_simulator
from urdfctl.rules.claims.controllers_chained_in_a_circle import controllers_chained_in_a_circle
from urdfctl.rules.claims.controllers_in_conflict import controllers_in_conflict
from urdfctl.rules.claims.controllers_without_hardware import controllers_without_hardware
from urdfctl.rules.claims.gains_missing import gains_missing
from urdfctl.rules.claims.gazebo_gains_given import gazebo_gains_given
from urdfctl.rules.claims.hardware_interface_not_in_gazebo import hardware_interface_not_in_gazebo
from urdfctl.rules.claims.hardware_not_active import hardware_not_active
from urdfctl.rules.claims.integral_without_clamp import integral_without_clamp
from urdfctl.rules.claims.interface_claimed_twice import interface_claimed_twice
from urdfctl.rules.claims.joint_in_another_interface import joint_in_another_interface
from urdfctl.rules.claims.joint_limits_incomplete import joint_limits_incomplete
from urdfctl.rules.claims.joint_not_commanded import joint_not_commanded
from urdfctl.rules.claims.joint_states_not_published import joint_states_not_published
from urdfctl.rules.claims.joint_states_published_twice import joint_states_published_twice
from urdfctl.rules.claims.joint_without_transmission import joint_without_transmission
from urdfctl.rules.claims.loop_without_error_gain import loop_without_error_gain
from urdfctl.rules.claims.mapped_interface_not_exported import mapped_interface_not_exported
from urdfctl.rules.claims.nothing_to_claim import nothing_to_claim
from urdfctl.rules.claims.number_not_finite import number_not_finite
from urdfctl.rules.claims.parameters_file_missing import parameters_file_missing
from urdfctl.rules.claims.sensor_frame_not_a_link import sensor_frame_not_a_link
from urdfctl.rules.claims.state_interface_not_exported import state_interface_not_exported
from urdfctl.rules.claims.state_of_other_data_type import state_of_other_data_type
from urdfctl.rules.claims.wheel_speed_beyond_limit import wheel_speed_beyond_limit

FAULTS: tuple[Fault, ...] = (
    command_interface_not_exported,
    state_interface_not_exported,
    chained_interface_not_exported,
    chained_controller_exports_nothing,
    chained_controller_not_started,
    controllers_chained_in_a_circle,
    controllers_in_conflict,
    interface_claimed_twice,
    hardware_not_active,
    joint_in_another_interface,
    joint_without_transmission,
    hardware_interface_not_in_gazebo,
    gains_missing,
    joint_states_not_published,
    joint_states_published_twice,
    joint_not_commanded,
    joint_limits_incomplete,
    gazebo_gains_given,
    mapped_interface_not_exported,
    controllers_without_hardware,
    nothing_to_claim,
    sensor_frame_not_a_link,
    wheel_speed_beyond_limit,
    state_of_other_data_type,
    command_overridden_in_simulator,
    claimed_name_empty,
    integral_without_clamp,
    loop_without_error_gain,
    number_not_finite,
    parameters_file_missing,
)
