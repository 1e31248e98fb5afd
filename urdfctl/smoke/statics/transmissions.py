"""The transmissions between motors and joints: which hardware uses them, and what is wrong with them.

A transmission turns what a joint is commanded into what its motor is commanded, and back (transmission_interface's
simple_transmission.hpp): motor = (joint - offset) * reduction. So a joint moves the same way with any reduction but 0,
and only the hardware knows how its motor is mounted. Simulated hardware moves the joint itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.catalog.distros import generation
from urdfctl.model.project import Project
from urdfctl.model.robot import ControlTransmission, ElementText, Ros2Control, Transmission, leading_number
from urdfctl.rules.smoke.negative_reduction_ignored import negative_reduction_ignored
from urdfctl.rules.smoke.reduction_of_zero import reduction_of_zero
from urdfctl.rules.smoke.transmission_ignored import transmission_ignored
from urdfctl.rules.smoke.wheel_reductions_differ import wheel_reductions_differ
from urdfctl.smoke.results import ROBOT, Trouble, trouble_of
from urdfctl.smoke.statics.simulators import GAZEBO_ROS1, in_gazebo_of_ros1, simulator_of
from urdfctl.smoke.tasks import ControllerTask
from urdfctl.startup.records import NamedTuple

_COUPLING = ("DifferentialTransmission", "FourBarLinkageTransmission")
"""The types that couple two motors and two joints."""
_IGNORING = ("mock", "gz", "gazebo-classic")
"""The simulators whose hardware in the catalogue moves joints without transmissions: neither gz_ros2_control's
gz_system.cpp, nor gazebo_ros2_control's gazebo_system.cpp, nor mock_components' generic_system.cpp reads them."""
_DIFFER = 0.01
"""The reductions of wheels differ from this fraction on: the same gears give the same number."""


class JointTransmission(NamedTuple):
    """The transmission of a joint.

    reduction: the number of turns of the motor for one of the joint.
    offset: the position of the joint at the motor's zero, in rad or m.
    is_coupled: whether two motors move two joints together.
    ignored_by: the hardware that ignores it, or empty.
    """

    joint: str
    reduction: float
    offset: float
    is_coupled: bool = False
    ignored_by: str = ""

    @property
    def acts(self) -> bool:
        """Whether motor and joint differ."""
        return self.is_coupled or self.reduction != 1 or self.offset != 0

    @property
    def label(self) -> str:
        """The number that makes motor and joint differ, in words."""
        if self.is_coupled:
            return "the coupling"
        return f"the reduction of {self.reduction:g}" if self.reduction != 1 else f"the offset of {self.offset:g}"


def transmissions_of(project: Project, distro: str) -> tuple[JointTransmission, ...]:
    """Return the transmissions that differ from a direct drive, in the form that a distro's ros_control reads."""
    if project.robot is None:
        return ()
    transmissions = (
        _of_ros1(project) if generation(distro) == 1 else _of_ros2(project.robot.ros2_controls, project, distro)
    )
    return tuple(each for each in transmissions if each.acts)


def _of_ros1(project: Project) -> Iterator[JointTransmission]:
    by = GAZEBO_ROS1 if in_gazebo_of_ros1(project) else ""
    for transmission in project.robot.transmissions if project.robot else ():
        kind = transmission.type.value if transmission.type else ""
        if not transmission.is_pr2:
            reductions = (text for end in transmission.actuators for text in end.reductions[:1])
            yield from _joint_transmissions(transmission, reductions, kind, by)


def _of_ros2(controls: Sequence[Ros2Control], project: Project, distro: str) -> Iterator[JointTransmission]:
    for control in controls:
        ignored = simulator_of(control, project.catalog, distro) in _IGNORING
        by = (control.plugin or "").strip().partition("/")[0] if ignored else ""
        for transmission in control.transmissions:
            kind = transmission.plugins[0].past_comments if transmission.plugins else ""
            reductions = (text for end in transmission.joints for text in end.reductions[:1])
            if not transmission.is_ros1:
                yield from _joint_transmissions(transmission, reductions, kind, by)


def _joint_transmissions(
    transmission: Transmission | ControlTransmission, reductions: Iterable[ElementText], kind: str, by: str
) -> Iterator[JointTransmission]:
    reduction = next((_number(text, 1.0) for text in reductions), 1.0)
    for joint in transmission.joints:
        offset = next((_number(text, 0.0) for text in joint.offsets), 0.0)
        if joint.name:
            yield JointTransmission(joint.name, reduction, offset, is_coupled=kind.endswith(_COUPLING), ignored_by=by)


def _number(text: ElementText, default: float) -> float:
    number = leading_number(text.past_comments)
    return default if number is None or not math.isfinite(number) else number


# -- what is wrong with them, and what is not tested -----------------------------------------------------------------


def transmission_troubles(
    transmissions: Sequence[JointTransmission], tasks: Sequence[ControllerTask]
) -> Iterator[Trouble]:
    """Yield the transmissions that the hardware cannot load, or ignores, and those of wheels that differ."""
    owners = {joint: task.controller for task in reversed(tasks) for joint in task.joints}
    ignored = [each for each in transmissions if each.ignored_by]
    for each in transmissions:
        subject, controller = f"joint:{each.joint}", owners.get(each.joint)
        if not each.is_coupled and each.reduction == 0 and not each.ignored_by:
            yield trouble_of(reduction_of_zero, subject, controller, joint=each.joint)
        elif not each.is_coupled and each.reduction < 0 and each.ignored_by:
            fields = {"joint": each.joint, "reduction": f"{each.reduction:g}", "hardware": each.ignored_by}
            yield trouble_of(negative_reduction_ignored, subject, None, (), **fields)
    if ignored:
        first, others = ignored[0], len({each.joint for each in ignored}) - 1
        more = f", and of {others} more joint{'s' if others > 1 else ''}" if others else ""
        fields = {"hardware": first.ignored_by, "what": first.label, "joint": first.joint, "more": more}
        yield trouble_of(transmission_ignored, ROBOT, None, (), **fields)
    for task in tasks:
        yield from _of_wheels(task, {each.joint: abs(each.reduction) for each in transmissions if not each.is_coupled})


def _of_wheels(task: ControllerTask, reductions: dict[str, float]) -> Iterator[Trouble]:
    """The driven wheels of a base have the same reduction."""
    given = {name: reductions.get(name, 1.0) for name in task.driven_joints}
    least, most = (choose(given, key=given.__getitem__, default="") for choose in (min, max))
    if given and given[most] - given[least] > _DIFFER * given[most] > 0:
        fields = {"least": f"{given[least]:g}", "joint": least, "most": f"{given[most]:g}", "other": most}
        yield trouble_of(wheel_reductions_differ, f"joint:{most}", task.controller, (), **fields)


def with_transmissions(
    transmissions: Sequence[JointTransmission], tasks: Sequence[ControllerTask]
) -> tuple[ControllerTask, ...]:
    """Return the tasks, in which transmissions that hardware uses count as not simulated."""
    used = {each.joint: each for each in transmissions if not each.ignored_by}

    def added(task: ControllerTask) -> ControllerTask:
        own = next((used[joint] for joint in task.joints if joint in used), None)
        turns = ": its motor turns the other way" if own and not own.is_coupled and own.reduction < 0 else ""
        what = (("transmission", f"{own.label} of joint '{own.joint}' acts in the hardware{turns}"),) if own else ()
        return task._replace(left_out=(*task.left_out, *what))

    return tuple(map(added, tasks))
