"""UC672."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1, ROS2, until
from urdfctl.model.controllers import MoveItController
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known, replaced
from urdfctl.rules.moveit.common import real_controllers
from urdfctl.rules.moveit.samples import configured

_INTERFACES = ("position_controllers", "velocity_controllers", "effort_controllers", "pos_vel_controllers")
_OFFERED = {
    **{
        f"{package}/JointTrajectoryController": ("FollowJointTrajectory", "follow_joint_trajectory")
        for package in ("joint_trajectory_controller", *_INTERFACES)
    },
    **{f"{package}/GripperActionController": ("GripperCommand", "gripper_cmd") for package in _INTERFACES},
    "parallel_gripper_action_controller/GripperActionController": ("ParallelGripperCommand", "gripper_cmd"),
}
"""The action that a type of controller offers, as MoveIt names it, and its name."""
_TYPES = ("FollowJointTrajectory", "GripperCommand")
_PARALLEL = "ParallelGripperCommand"
_WITHOUT_PARALLEL = tuple(distro for distro in until("iron") if distro in ROS2)


@rule(
    "UC672",
    severity=Severity.ERROR,
    runtime="refuses",
    options=("--distro=jazzy",),
    authority="moveit_simple_controller_manager.cpp: 'Action client not connected to action server: arm_controller/gripper_cmd', "
    "'Unknown controller type: GripperCmd'; ros2_controllers: joint_trajectory_controller offers ~/follow_joint_trajectory, "
    "the gripper controllers ~/gripper_cmd; ParallelGripperCommand exists since jazzy",
    bad=[
        configured("type: FollowJointTrajectory", "type: «GripperCommand»"),
        {
            "ros2_controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    a: {type: position_controllers/JointTrajectoryController}
                    b: {type: velocity_controllers/JointTrajectoryController}
                    c: {type: effort_controllers/JointTrajectoryController}
                    d: {type: pos_vel_controllers/JointTrajectoryController}
                    e: {type: position_controllers/GripperActionController}
                    f: {type: velocity_controllers/GripperActionController}
                    g: {type: effort_controllers/GripperActionController}
                    h: {type: pos_vel_controllers/GripperActionController}
                    i: {type: parallel_gripper_action_controller/GripperActionController}
            """,
            "moveit_controllers.yaml": """
                moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
                moveit_simple_controller_manager:
                  controller_names: [a, b, c, d, e, f, g, h, i]
                  a: {type: «GripperCommand», action_ns: follow_joint_trajectory, joints: [elbow]}
                  b: {type: «GripperCommand», action_ns: follow_joint_trajectory, joints: [elbow]}
                  c: {type: «GripperCommand», action_ns: follow_joint_trajectory, joints: [elbow]}
                  d: {type: «GripperCommand», action_ns: follow_joint_trajectory, joints: [elbow]}
                  e: {type: «FollowJointTrajectory», action_ns: gripper_cmd, joints: [elbow]}
                  f: {type: «FollowJointTrajectory», action_ns: gripper_cmd, joints: [elbow]}
                  g: {type: «FollowJointTrajectory», action_ns: gripper_cmd, joints: [elbow]}
                  h: {type: «FollowJointTrajectory», action_ns: gripper_cmd, joints: [elbow]}
                  i: {type: «FollowJointTrajectory», action_ns: gripper_cmd, joints: [elbow]}
            """,
        },
        {
            "ros2_controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    a: {type: position_controllers/JointTrajectoryController}
                    b: {type: velocity_controllers/JointTrajectoryController}
                    c: {type: effort_controllers/JointTrajectoryController}
                    d: {type: pos_vel_controllers/JointTrajectoryController}
                    e: {type: position_controllers/GripperActionController}
                    f: {type: velocity_controllers/GripperActionController}
                    g: {type: effort_controllers/GripperActionController}
                    h: {type: pos_vel_controllers/GripperActionController}
                    i: {type: parallel_gripper_action_controller/GripperActionController}
            """,
            "moveit_controllers.yaml": """
                moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
                moveit_simple_controller_manager:
                  controller_names: [a, e, i, b]
                  a: {type: FollowJointTrajectory, action_ns: «trajectory», joints: [elbow]}
                  e: {type: GripperCommand, action_ns: «gripper», joints: [elbow]}
                  i: {type: ParallelGripperCommand, action_ns: «gripper», joints: [elbow]}
                  b: {type: «Follow», action_ns: x, joints: [elbow]}
            """,
        },
        {
            "options": "--distro=humble",
            "ros2_controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    a: {type: position_controllers/JointTrajectoryController}
                    b: {type: velocity_controllers/JointTrajectoryController}
                    c: {type: effort_controllers/JointTrajectoryController}
                    d: {type: pos_vel_controllers/JointTrajectoryController}
                    e: {type: position_controllers/GripperActionController}
                    f: {type: velocity_controllers/GripperActionController}
                    g: {type: effort_controllers/GripperActionController}
                    h: {type: pos_vel_controllers/GripperActionController}
                    i: {type: parallel_gripper_action_controller/GripperActionController}
            """,
            "moveit_controllers.yaml": """
                moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
                moveit_simple_controller_manager:
                  controller_names: [i]
                  i: {type: «ParallelGripperCommand», action_ns: gripper_cmd, joints: [elbow]}
            """,
        },
    ],
    good=[configured()],
)
def moveit_action_differs(project: Project) -> Iterator[Finding]:
    """MoveIt expects another action than the controller offers.

    MoveIt waits for an action server of the given type and name. The controller offers another one, so MoveIt never
    connects to it, and does not execute plans for its joints.
    """
    for controller in real_controllers(project):
        if controller.type is None or controller.type_at is None or not is_known(controller.type):
            continue
        yield from _of_type(project, controller)
        found = project.controllers.controller(controller.name.text) if project.controllers else None
        kind = found.type.text if found and found.type else ""
        if kind in _OFFERED and controller.type in (*_TYPES, _PARALLEL):
            yield from _compared(controller, kind)


def _of_type(project: Project, controller: MoveItController) -> Iterator[Finding]:
    if controller.type_at is None:
        return
    if controller.type not in (*_TYPES, _PARALLEL):
        message = f"MoveIt does not know type '{controller.type}' of controller '{controller.name.text}'"
        yield Finding(controller.type_at, f"{message}; it knows {in_words(_TYPES)}")
    elif controller.type == _PARALLEL and set(project.distros) <= {*ROS1, *_WITHOUT_PARALLEL}:
        yield Finding(controller.type_at, f"MoveIt knows type '{_PARALLEL}' only since jazzy; use 'GripperCommand'")


def _compared(controller: MoveItController, kind: str) -> Iterator[Finding]:
    wanted, action = _OFFERED[kind]
    name = controller.name.text
    if controller.type != wanted and controller.type_at is not None:
        message = f"controller '{name}' offers the action of type '{wanted}', not '{controller.type}'"
        yield Finding(controller.type_at, message, (), replaced(controller.type_at, controller.type or "", wanted))
    elif controller.action is not None and is_known(controller.action.text):
        given = controller.action
        if given.text.strip("/") != action:
            message = f"controller '{name}' offers its action as '{action}', not '{given.text}'"
            yield Finding(given.at, message, (), replaced(given.at, given.text, action))
