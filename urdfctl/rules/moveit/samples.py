"""The files of a small arm, used in the examples of the rules on MoveIt's configuration."""

from __future__ import annotations

from urdfctl.rules.launch_samples import CONTROLLERS, ROBOT

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
SEMANTIC = """
    <?xml version="1.0"?>
    <robot name="arm">
      <group name="arm"><chain base_link="base" tip_link="fore"/></group>
      <group name="wrist"><joint name="elbow"/></group>
      <group_state name="home" group="arm">
        <joint name="shoulder" value="0"/>
        <joint name="elbow" value="0"/>
      </group_state>
      <disable_collisions link1="base" link2="upper" reason="Adjacent"/>
    </robot>
"""
KINEMATICS = """
    arm:
      kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin
      kinematics_solver_timeout: 0.05
"""
LIMITS = """
    joint_limits:
      shoulder:
        has_velocity_limits: true
        max_velocity: 1.5
        has_acceleration_limits: true
        max_acceleration: 2.0
      elbow:
        has_velocity_limits: true
        max_velocity: 1.5
        has_acceleration_limits: true
        max_acceleration: 2.0
"""


def configured(old: str = "", new: str = "") -> dict[str, str]:
    """Return the arm's controller file, and MoveIt's configuration with `old` replaced by `new`."""
    return {
        "ros2_controllers.yaml": CONTROLLERS,
        "moveit_controllers.yaml": MOVEIT.replace(old, new) if old else MOVEIT,
    }


def planned(old: str = "", new: str = "", **more: str) -> dict[str, str]:
    """Return the arm with its SRDF, in which `old` is replaced by `new`; `more` are YAML files without their ending."""
    semantic = SEMANTIC.replace(old, new) if old else SEMANTIC
    return {"arm.urdf": "", "arm.srdf": semantic, **{f"{name}.yaml": text for name, text in more.items()}}


_LAUNCH = """
    from moveit_configs_utils import MoveItConfigsBuilder
    from moveit_configs_utils.launches import generate_move_group_launch

    def generate_launch_description():
        config = MoveItConfigsBuilder("arm", package_name="arm").to_moveit_configs()
        return generate_move_group_launch(config)
"""


def built(mark: str, more: dict[str, str]) -> dict[str, str]:
    """Return a package of MoveIt, with the call that starts move_group in the mark; `more` are further files."""
    call = "generate_move_group_launch(config)"
    return {
        "launch/move_group.launch.py": _LAUNCH.replace(call, mark.format(call)),
        "config/arm.urdf": ROBOT,
        "config/arm.srdf": SEMANTIC,
        "config/kinematics.yaml": KINEMATICS,
        "config/joint_limits.yaml": LIMITS,
        "package.xml": '<package format="3"><name>arm</name><exec_depend>moveit_configs_utils</exec_depend></package>',
        **more,
    }
