"""UC65 to UC69: MoveIt's configuration."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.moveit.acceleration_limit_missing import acceleration_limit_missing
from urdfctl.rules.moveit.collision_pair_unknown import collision_pair_unknown
from urdfctl.rules.moveit.controller_list_empty import controller_list_empty
from urdfctl.rules.moveit.group_without_controller import group_without_controller
from urdfctl.rules.moveit.kinematics_without_prefix import kinematics_without_prefix
from urdfctl.rules.moveit.launched_value_empty import launched_value_empty
from urdfctl.rules.moveit.limit_looser_than_urdf import limit_looser_than_urdf
from urdfctl.rules.moveit.limit_not_double import limit_not_double
from urdfctl.rules.moveit.limits_joint_unknown import limits_joint_unknown
from urdfctl.rules.moveit.moveit_action_differs import moveit_action_differs
from urdfctl.rules.moveit.moveit_controller_incomplete import moveit_controller_incomplete
from urdfctl.rules.moveit.moveit_controller_unknown import moveit_controller_unknown
from urdfctl.rules.moveit.moveit_controller_unlisted import moveit_controller_unlisted
from urdfctl.rules.moveit.moveit_file_missing import moveit_file_missing
from urdfctl.rules.moveit.moveit_joint_unknown import moveit_joint_unknown
from urdfctl.rules.moveit.moveit_joints_differ import moveit_joints_differ
from urdfctl.rules.moveit.moveit_plugin_unknown import moveit_plugin_unknown
from urdfctl.rules.moveit.pipeline_of_other_distro import pipeline_of_other_distro
from urdfctl.rules.moveit.semantic_chain_broken import semantic_chain_broken
from urdfctl.rules.moveit.semantic_group_unknown import semantic_group_unknown
from urdfctl.rules.moveit.semantic_group_unusable import semantic_group_unusable
from urdfctl.rules.moveit.semantic_of_other_robot import semantic_of_other_robot
from urdfctl.rules.moveit.semantic_out_of_reach import semantic_out_of_reach
from urdfctl.rules.moveit.semantic_part_unknown import semantic_part_unknown
from urdfctl.rules.moveit.solver_group_unknown import solver_group_unknown
from urdfctl.rules.moveit.solver_needs_chain import solver_needs_chain
from urdfctl.rules.moveit.virtual_joint_not_at_root import virtual_joint_not_at_root

FAULTS: tuple[Fault, ...] = (
    moveit_controller_incomplete,
    moveit_controller_unknown,
    moveit_joints_differ,
    moveit_joint_unknown,
    controller_list_empty,
    launched_value_empty,
    semantic_of_other_robot,
    semantic_part_unknown,
    semantic_chain_broken,
    semantic_group_unknown,
    semantic_group_unusable,
    collision_pair_unknown,
    solver_group_unknown,
    solver_needs_chain,
    group_without_controller,
    limits_joint_unknown,
    limit_not_double,
    acceleration_limit_missing,
    limit_looser_than_urdf,
    pipeline_of_other_distro,
    semantic_out_of_reach,
    moveit_action_differs,
    virtual_joint_not_at_root,
    kinematics_without_prefix,
    moveit_controller_unlisted,
    moveit_file_missing,
    moveit_plugin_unknown,
)
