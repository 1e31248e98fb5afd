"""The rules, by families. Each family lists its own in its `family.py`: what is not in a list does not exist.

A family is loaded when it has something to say of a robot, for the import of a hundred modules shows in the start-up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from urdfctl.catalog.distros import ROS1, ROS2
from urdfctl.model.project import Project
from urdfctl.record import NamedTuple
from urdfctl.rule import Rule

Rules = tuple[Rule, ...]


class Family(NamedTuple):
    """The rules whose codes share a beginning, and which projects they can say anything of."""

    prefix: str
    load: Callable[[], Rules]
    concerns: Callable[[Project], bool]


def _reading() -> Rules:
    from urdfctl.rules.reading.family import RULES

    return RULES


def _urdf() -> Rules:
    from urdfctl.rules.urdf.family import RULES

    return RULES


def _transmissions() -> Rules:
    from urdfctl.rules.transmissions.family import RULES

    return RULES


def _ros2_control() -> Rules:
    from urdfctl.rules.ros2_control.family import RULES

    return RULES


def _controllers() -> Rules:
    from urdfctl.rules.controllers.family import RULES

    return RULES


def _claims() -> Rules:
    from urdfctl.rules.claims.family import RULES

    return RULES


def _simulation() -> Rules:
    from urdfctl.rules.simulation.family import RULES

    return RULES


def _launch() -> Rules:
    from urdfctl.rules.launch.family import RULES

    return RULES


def _moveit() -> Rules:
    from urdfctl.rules.moveit.family import RULES

    return RULES


def _migration() -> Rules:
    from urdfctl.rules.migration.family import RULES

    return RULES


def _smoke() -> Rules:
    from urdfctl.rules.smoke.family import RULES

    return RULES


def _has_transmissions(project: Project) -> bool:
    robot = project.robot
    if robot is None or not set(ROS1) & set(project.distros):
        return False
    nested = any(control.transmissions for control in robot.ros2_controls)
    return bool(robot.transmissions or robot.nested_transmissions or nested)


def _is_controlled_by_ros2(project: Project) -> bool:
    robot = project.robot
    if robot is None or not set(ROS2) & set(project.distros):
        return False
    return bool(robot.ros2_controls or (project.ros == 2 and (robot.transmissions or robot.plugins)))  # noqa: PLR2004 (the generation)


def _is_simulated(project: Project) -> bool:
    """Whether the robot loads any plugin of a simulator, or its hardware runs in one."""
    robot = project.robot
    if robot is None or not project.may_be_simulated:
        return False
    if any(gazebo.plugins or any(gazebo.tag.named("sensor")) for gazebo in robot.gazebos):
        return True
    return bool(robot.ros2_controls) and _runs_in_gazebo(project)


def _runs_in_gazebo(project: Project) -> bool:
    from urdfctl.rules.simulation.common import IN_GAZEBO, components, simulator_of

    return any(simulator_of(project, control) in IN_GAZEBO for control in components(project))


def _may_move_on(project: Project) -> bool:
    if not set(ROS2) & set(project.distros):
        return False
    controlled = project.robot is not None and bool(project.robot.ros2_controls) and project.may_be_simulated
    return controlled or project.controllers is not None or _is_simulated(project)


def _has_moveit(project: Project) -> bool:
    found = project.controllers
    return found is not None and bool(found.moveit or found.moveit_lists)


FAMILIES = (
    Family("UC0", _reading, lambda project: bool(project.problems)),
    Family("UC1", _urdf, lambda project: project.robot is not None),
    Family("UC2", _transmissions, _has_transmissions),
    Family("UC3", _ros2_control, _is_controlled_by_ros2),
    Family("UC4", _controllers, lambda project: project.controllers is not None),
    Family("UC4", _claims, lambda project: project.controllers is not None),
    Family("UC5", _simulation, _is_simulated),
    Family("UC6", _launch, lambda project: project.launch is not None or bool(project.listed)),
    Family("UC6", _moveit, _has_moveit),
    Family("UC7", _migration, _may_move_on),
    Family("UC9", _smoke, lambda _: False),
)


def rules_for(project: Project) -> Iterator[Rule]:
    """The rules of the families that concern a project, in the order of their codes."""
    for family in FAMILIES:
        if family.concerns(project):
            yield from family.load()


def all_rules() -> Rules:
    """Every rule, in the order of the codes."""
    return tuple(rule for family in FAMILIES for rule in family.load())


def rule_of(code: str) -> Rule:
    """The rule of a code that is known to exist."""
    return next(
        rule for family in FAMILIES if code.startswith(family.prefix) for rule in family.load() if rule.code == code
    )
