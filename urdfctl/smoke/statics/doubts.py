"""The errors of a motion that the hardware of a robot may not share: it moves joints in another way than an engine.

Gazebo Classic sets the position of a joint whatever its motor can do, and a driver knows its motors and which way they
turn.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from urdfctl.catalog.distros import generation
from urdfctl.control.hardware.gazebo_ros1 import control_plugins, is_started_without_gazebo
from urdfctl.fault import FaultWithMessage
from urdfctl.model.project import Project
from urdfctl.model.robot import Ros2Control
from urdfctl.rules.smoke.effort_too_weak_for_gravity import effort_too_weak_for_gravity
from urdfctl.rules.smoke.effort_too_weak_to_move import effort_too_weak_to_move
from urdfctl.rules.smoke.inertia_too_large import inertia_too_large
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.joint_resists_its_motor import joint_resists_its_motor
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast
from urdfctl.rules.smoke.wheel_turns_backwards import wheel_turns_backwards
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.statics.simulators import in_gazebo_of_ros1, simulator_of
from urdfctl.smoke.tasks import ControllerTask

Doubts = Mapping[str, Mapping[str, str]]
"""Why an error of a controller is only a warning: by its name, and by the code of the fault."""

_OF_MOTORS = (
    effort_too_weak_for_gravity,
    effort_too_weak_to_move,
    inertia_too_large,
    joint_does_not_follow,
    joint_leaves_limits,
    joint_oscillates,
    joint_resists_its_motor,
    joint_too_fast,
)
_SECTION, _GAINS = "gazebo_ros_control", "pid_gains"
SET = "Gazebo sets the joint's position, whatever its motor can do: it works there, but not with such a motor"
HELD = "{} holds the position with motors of its own: it works there, but not with the masses and limits given here"
DRIVEN = "{} may turn the motor the other way; a simulator does not"


def doubts_of(project: Project, distro: str, tasks: Sequence[ControllerTask]) -> Doubts:
    """Return the errors that are warnings, each with the reason."""
    found: dict[str, dict[str, str]] = {}
    set_joints = _joints_set(project, distro)
    driver = _driver_of(project, distro)
    for task in tasks:
        doubted: dict[str, str] = {}
        if task.interface == "position" and task.joints and set_joints.issuperset(task.joints):
            doubted |= _with(_OF_MOTORS, SET)
        elif task.interface == "position" and driver:
            doubted |= _with(_OF_MOTORS, HELD.format(driver))
        if task.base and driver:
            doubted |= _with((wheel_turns_backwards,), DRIVEN.format(driver))
        if doubted:
            found[task.controller] = doubted
    return found


def with_doubts(troubles: Iterable[Trouble], doubts: Doubts) -> tuple[Trouble, ...]:
    """Return findings, in which those that the hardware may not share have the reason."""
    return tuple(
        trouble._replace(doubt=doubts.get(trouble.controller or "", {}).get(trouble.code, "")) for trouble in troubles
    )


def _with(faults: Iterable[FaultWithMessage], why: str) -> dict[str, str]:
    return {fault.code: why for fault in faults}


def _joints_set(project: Project, distro: str) -> set[str]:
    """The joints whose position Gazebo Classic sets, with no motor: those of position interfaces without gains."""
    robot = project.robot
    if robot is None:
        return set()
    if generation(distro) == 1:
        return set(robot.joint_names) - _with_gains(project) if in_gazebo_of_ros1(project) else set()
    parts = [part for control in robot.ros2_controls if _sets(control, project, distro) for part in control.parts]
    return {part.name for part in parts if part.name and not any("kp" in (each.name or "") for each in part.parameters)}


def _with_gains(project: Project) -> set[str]:
    others = project.controllers.others if project.controllers else ()
    return {joint.last for section in others if section.name == _SECTION for joint in section.parameters.below(_GAINS)}


def _sets(control: Ros2Control, project: Project, distro: str) -> bool:
    return simulator_of(control, project.catalog, distro) == "gazebo-classic"


def _driver_of(project: Project, distro: str) -> str:
    """What drives a robot, if its only hardware is neither mock nor simulated; else empty."""
    if generation(distro) == 1:
        return "the driver" if control_plugins(project) and is_started_without_gazebo(project) else ""
    controls = project.robot.ros2_controls if project.robot else ()
    plugins = {(control.plugin or "").strip() for control in controls}
    if len(plugins) != 1 or not all(plugins):
        return ""
    simulated = any(simulator_of(control, project.catalog, distro) for control in controls)
    return "" if simulated else f"the driver '{plugins.pop()}'"
