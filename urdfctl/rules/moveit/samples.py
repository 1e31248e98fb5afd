"""The files of a small arm, used in the examples of the rules on MoveIt's configuration."""

from __future__ import annotations

from urdfctl.rules.launch_samples import CONTROLLERS

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
    """Return the arm's controller file, and MoveIt's configuration with `old` replaced by `new`."""
    return {
        "ros2_controllers.yaml": CONTROLLERS,
        "moveit_controllers.yaml": MOVEIT.replace(old, new) if old else MOVEIT,
    }
