"""The model of MoveIt's configuration of a robot: its files, its SRDF and its settings."""

from __future__ import annotations

from urdfctl.model.moveit.moveit import Chain, Group, JointLimits, MoveIt, MoveItFiles, Pipeline, Semantic, VirtualJoint

__all__ = [
    "Chain",
    "Group",
    "JointLimits",
    "MoveIt",
    "MoveItFiles",
    "Pipeline",
    "Semantic",
    "VirtualJoint",
]
