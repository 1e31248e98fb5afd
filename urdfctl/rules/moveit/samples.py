"""The files of a small arm that rules on MoveIt's configuration show their examples with."""

from __future__ import annotations

from urdfctl.rules.launch.samples import CONTROLLERS

MOVEIT = """
    moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
    moveit_simple_controller_manager:
      controller_names: [arm_controller]
      arm_controller:
        type: FollowJointTrajectory
        action_ns: follow_joint_trajectory
        default: true
        joints: [shoulder, elbow]
"""


def configured(old: str = "", new: str = "") -> dict[str, str]:
    """The arm's controllers, and MoveIt's configuration with something written otherwise."""
    return {
        "ros2_controllers.yaml": CONTROLLERS,
        "moveit_controllers.yaml": MOVEIT.replace(old, new) if old else MOVEIT,
    }
