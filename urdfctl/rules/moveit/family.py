"""UC65: MoveIt's configuration of the controllers."""

from __future__ import annotations

from urdfctl.rule import Rule
from urdfctl.rules.moveit.moveit_controller_incomplete import moveit_controller_incomplete
from urdfctl.rules.moveit.moveit_controller_unknown import moveit_controller_unknown
from urdfctl.rules.moveit.moveit_joint_unknown import moveit_joint_unknown
from urdfctl.rules.moveit.moveit_joints_differ import moveit_joints_differ

RULES: tuple[Rule, ...] = (
    moveit_controller_incomplete,
    moveit_controller_unknown,
    moveit_joints_differ,
    moveit_joint_unknown,
)
