"""Who never moves a joint whose `<limit>` is 0 or has no range, because it applies the limit to each command."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal

from urdfctl.catalog.distros import since
from urdfctl.control.hardware.gazebo_ros1 import GAZEBO_INTERFACES, in_gazebo
from urdfctl.control.hardware.simulator_plugins import components, simulator_of
from urdfctl.diagnostic import Severity
from urdfctl.model.project import Project

LimitKind = Literal["effort", "velocity", "range", "reversed"]
_ENFORCING = since("kilted")
"""Distros whose manager has `enforce_command_limits: true` by default (controller_manager_parameters.yaml)."""
_COMMANDS = ("position", "velocity", "effort")
_OF_SIMULATORS: dict[str, dict[LimitKind, tuple[str, ...]]] = {
    "gz": {"effort": _COMMANDS, "velocity": _COMMANDS[:2], "range": _COMMANDS},
    "gazebo-classic": {"effort": _COMMANDS[2:], "velocity": (), "range": _COMMANDS},
}
"""The commands of a joint that a simulator does not carry out.

gz: gz-physics dartsim/src/SDFFeatures.cc hands the limits to DART, whose servo (ServoMotorConstraint::update(),
GenericJoint::setCommand()) has the effort limit as its strength and the velocity limit as its speed. Gazebo Classic:
gazebo_ros2_control gazebo_system.cpp write() sets positions and velocities directly, but physics/Joint.cc
CheckAndTruncateForce() limits efforts.
"""
_OF_MANAGER: dict[LimitKind, tuple[str, ...]] = {
    "effort": _COMMANDS[2:],
    "velocity": _COMMANDS[:2],
    "range": _COMMANDS[:1],
    "reversed": (),
}
"""The commands that the controller manager limits (joint_limits joint_range_limiter.cpp)."""
_OF_ROS1: dict[LimitKind, tuple[str, ...]] = {
    "effort": ("VelocityJointInterface", "EffortJointInterface"),
    "velocity": ("PositionJointInterface", "VelocityJointInterface"),
    "range": GAZEBO_INTERFACES,
    "reversed": ("PositionJointInterface",),
}
"""The interfaces that gazebo_ros_control limits (default_robot_hw_sim.cpp registerJointLimits()).

A joint that is commanded by velocity gets its effort limit as `fmax` (initSim()). Of reversed limits
joint_limits_interface makes the upper one of each position: saturate() is min(max(value, lower), upper).
"""


def held_by(project: Project, joint: str | None, limit: LimitKind) -> str | None:
    """Return who certainly never moves a joint with such a limit, as messages say it; None if nobody is known to.

    A joint that also has a command without that limit can be moved by it.
    """
    for control in components(project):
        simulator = simulator_of(project, control) or ""
        for part in control.parts:
            if part.kind != "joint" or part.name != joint:
                continue
            commands = {command.name for command in part.commands} & {*_COMMANDS}
            if commands and commands <= {*_OF_SIMULATORS.get(simulator, {}).get(limit, ())}:
                return "gz" if simulator == "gz" else "Gazebo"
            if commands and commands <= {*_OF_MANAGER[limit]} and _manager_limits(project):
                return "the controller manager"
    return "gazebo_ros_control" if _held_in_ros1(project, joint, _OF_ROS1[limit]) else None


def ignores(project: Project, joint: str, limit: LimitKind) -> bool:
    """Return whether a joint is in a simulator that carries out all commands whatever that limit is."""
    for control in components(project):
        known = _OF_SIMULATORS.get(simulator_of(project, control) or "", {}).get(limit)
        if known == () and any(part.kind == "joint" and part.name == joint for part in control.parts):
            return True
    return False


def _manager_limits(project: Project) -> bool:
    """Whether the controller manager limits commands in each of the project's distros."""
    managers = project.controllers.managers if project.controllers else ()
    settings = [manager.parameters.value("enforce_command_limits") for manager in managers]
    turned_off = any(setting is not None and setting.value is not True for setting in settings)
    return bool(project.distros) and set(project.distros) <= set(_ENFORCING) and not turned_off


def _held_in_ros1(project: Project, joint: str | None, interfaces: Collection[str]) -> bool:
    """Whether Gazebo of ROS 1 certainly runs a joint with one of some interfaces, with the limits of the URDF."""
    robot, controllers = project.robot, project.controllers
    if robot is None or project.ros != 1 or in_gazebo(project) is not Severity.ERROR:
        return False
    if controllers is None or not controllers.complete or controllers.other("joint_limits") is not None:
        return False
    ends = (end for transmission in robot.transmissions for end in transmission.joints if end.name == joint)
    return any(end.interfaces and end.interfaces[0].value.rpartition("/")[2] in interfaces for end in ends)
