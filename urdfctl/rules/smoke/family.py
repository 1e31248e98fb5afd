"""UC9: what the smoke test finds when it runs the robot and its controllers.

The code in `urdfctl.smoke` that measures a fault calls `trouble_of` with the fault and the facts of its message.
"""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.smoke.angles_in_degrees import angles_in_degrees
from urdfctl.rules.smoke.base_leans import base_leans
from urdfctl.rules.smoke.base_too_slow import base_too_slow
from urdfctl.rules.smoke.base_without_mass import base_without_mass
from urdfctl.rules.smoke.collision_mesh_left_out import collision_mesh_left_out
from urdfctl.rules.smoke.command_range_too_small import command_range_too_small
from urdfctl.rules.smoke.continuous_with_limits import continuous_with_limits
from urdfctl.rules.smoke.controller_not_activated import controller_not_activated
from urdfctl.rules.smoke.controller_not_configured import controller_not_configured
from urdfctl.rules.smoke.controller_not_loaded import controller_not_loaded
from urdfctl.rules.smoke.controllers_share_a_joint import controllers_share_a_joint
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left
from urdfctl.rules.smoke.effort_too_weak_for_gravity import effort_too_weak_for_gravity
from urdfctl.rules.smoke.effort_too_weak_in_a_pose import effort_too_weak_in_a_pose
from urdfctl.rules.smoke.effort_too_weak_to_move import effort_too_weak_to_move
from urdfctl.rules.smoke.engine_died import engine_died
from urdfctl.rules.smoke.engine_refuses_robot import engine_refuses_robot
from urdfctl.rules.smoke.engines_disagree import engines_disagree
from urdfctl.rules.smoke.fingers_move_alike import fingers_move_alike
from urdfctl.rules.smoke.hardware_not_started import hardware_not_started
from urdfctl.rules.smoke.inertia_too_large import inertia_too_large
from urdfctl.rules.smoke.inertia_too_small import inertia_too_small
from urdfctl.rules.smoke.inertia_unusable import inertia_unusable
from urdfctl.rules.smoke.initial_position_beyond_limits import initial_position_beyond_limits
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_hangs_loose import joint_hangs_loose
from urdfctl.rules.smoke.joint_held_still import joint_held_still
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits
from urdfctl.rules.smoke.joint_moves_wrong_way import joint_moves_wrong_way
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.joint_resists_its_motor import joint_resists_its_motor
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast
from urdfctl.rules.smoke.joint_too_slow import joint_too_slow
from urdfctl.rules.smoke.joint_without_range import joint_without_range
from urdfctl.rules.smoke.joints_oscillate_together import joints_oscillate_together
from urdfctl.rules.smoke.length_in_millimetres import length_in_millimetres
from urdfctl.rules.smoke.limits_in_degrees import limits_in_degrees
from urdfctl.rules.smoke.links_overlap import links_overlap
from urdfctl.rules.smoke.loop_too_soft import loop_too_soft
from urdfctl.rules.smoke.loop_too_stiff_without_rotor import loop_too_stiff_without_rotor
from urdfctl.rules.smoke.loop_underdamped import loop_underdamped
from urdfctl.rules.smoke.loop_unstable import loop_unstable
from urdfctl.rules.smoke.loop_without_gain import loop_without_gain
from urdfctl.rules.smoke.loose_robot_tips_over import loose_robot_tips_over
from urdfctl.rules.smoke.mass_in_grams import mass_in_grams
from urdfctl.rules.smoke.mass_outside_of_link import mass_outside_of_link
from urdfctl.rules.smoke.mimic_beyond_limits import mimic_beyond_limits
from urdfctl.rules.smoke.mimic_not_kept import mimic_not_kept
from urdfctl.rules.smoke.negative_reduction_ignored import negative_reduction_ignored
from urdfctl.rules.smoke.reduction_of_zero import reduction_of_zero
from urdfctl.rules.smoke.robot_not_spawned import robot_not_spawned
from urdfctl.rules.smoke.robot_tips_over import robot_tips_over
from urdfctl.rules.smoke.simulation_explodes import simulation_explodes
from urdfctl.rules.smoke.soft_limits_without_range import soft_limits_without_range
from urdfctl.rules.smoke.steering_range_too_small import steering_range_too_small
from urdfctl.rules.smoke.steering_turns_backwards import steering_turns_backwards
from urdfctl.rules.smoke.task_not_performed import task_not_performed
from urdfctl.rules.smoke.transmission_ignored import transmission_ignored
from urdfctl.rules.smoke.travel_in_millimetres import travel_in_millimetres
from urdfctl.rules.smoke.verdict_depends_on_distro import verdict_depends_on_distro
from urdfctl.rules.smoke.wheel_cannot_roll import wheel_cannot_roll
from urdfctl.rules.smoke.wheel_eccentric import wheel_eccentric
from urdfctl.rules.smoke.wheel_in_the_wrong_place import wheel_in_the_wrong_place
from urdfctl.rules.smoke.wheel_measures_differ import wheel_measures_differ
from urdfctl.rules.smoke.wheel_off_the_ground import wheel_off_the_ground
from urdfctl.rules.smoke.wheel_reductions_differ import wheel_reductions_differ
from urdfctl.rules.smoke.wheel_sides_swapped import wheel_sides_swapped
from urdfctl.rules.smoke.wheel_slower_than_commanded import wheel_slower_than_commanded
from urdfctl.rules.smoke.wheel_turns_backwards import wheel_turns_backwards
from urdfctl.rules.smoke.wheels_mirrored import wheels_mirrored
from urdfctl.rules.smoke.wheels_slip import wheels_slip
from urdfctl.rules.smoke.wheels_too_weak import wheels_too_weak

FAULTS: tuple[Fault, ...] = (
    robot_not_spawned,
    hardware_not_started,
    controller_not_loaded,
    controller_not_configured,
    controller_not_activated,
    inertia_unusable,
    wheel_sides_swapped,
    wheel_turns_backwards,
    wheel_measures_differ,
    joint_held_still,
    effort_too_weak_for_gravity,
    loop_unstable,
    loop_underdamped,
    loop_too_stiff_without_rotor,
    engine_died,
    engine_refuses_robot,
    collision_mesh_left_out,
    simulation_explodes,
    robot_tips_over,
    joint_does_not_follow,
    joint_oscillates,
    joints_oscillate_together,
    joint_moves_wrong_way,
    joint_leaves_limits,
    joint_too_fast,
    mimic_not_kept,
    wheel_off_the_ground,
    does_not_drive_forward,
    does_not_turn_left,
    effort_too_weak_in_a_pose,
    joint_resists_its_motor,
    effort_too_weak_to_move,
    mimic_beyond_limits,
    command_range_too_small,
    wheel_cannot_roll,
    steering_range_too_small,
    inertia_too_small,
    base_without_mass,
    wheels_mirrored,
    wheel_in_the_wrong_place,
    steering_turns_backwards,
    wheels_too_weak,
    engines_disagree,
    base_too_slow,
    initial_position_beyond_limits,
    loop_too_soft,
    joint_without_range,
    links_overlap,
    verdict_depends_on_distro,
    task_not_performed,
    transmission_ignored,
    negative_reduction_ignored,
    wheel_reductions_differ,
    reduction_of_zero,
    wheels_slip,
    loose_robot_tips_over,
    limits_in_degrees,
    travel_in_millimetres,
    angles_in_degrees,
    length_in_millimetres,
    mass_outside_of_link,
    mass_in_grams,
    wheel_slower_than_commanded,
    wheel_eccentric,
    base_leans,
    loop_without_gain,
    joint_hangs_loose,
    fingers_move_alike,
    soft_limits_without_range,
    continuous_with_limits,
    inertia_too_large,
    controllers_share_a_joint,
    joint_too_slow,
)
