"""The rules, by families. Each family lists its rules in its `family.py`; a rule that is not listed does not exist.

A family is imported when it can find something in a project: importing a hundred modules takes time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from importlib import import_module

from urdfctl.catalog.distros import ROS1, ROS2
from urdfctl.model.project import Project
from urdfctl.model.stage import Stage, StageDependsOn
from urdfctl.rule import Rule
from urdfctl.startup.records import NamedTuple

Rules = tuple[Rule, ...]


class Family(NamedTuple):
    """The rules of one folder.

    prefix: how their codes begin.
    name: the folder.
    concerns: returns whether they can find anything in a project.
    """

    prefix: str
    name: str
    concerns: Callable[[Project], bool]
    stage: Stage | None = None
    """The stage that an error of the family's rules stops, unless a rule names another one. None: it stops nothing."""
    only: Callable[[Project], Iterable[str] | None] = lambda _: None
    """Returns the names of the only rules that can find anything in a project; None if any rule can."""

    def load(self) -> Rules:
        """Import the folder and return its rules."""
        rules: Rules = import_module(f"urdfctl.rules.{self.name}.family").RULES
        return rules

    def load_for(self, project: Project) -> Rules:
        """Import and return the rules that can find anything in a project, in the order of their codes."""
        if not self.concerns(project):
            return ()
        names = self.only(project)
        if names is None:
            return self.load()
        modules = ((name, import_module(f"urdfctl.rules.{self.name}.{name}")) for name in dict.fromkeys(names))
        return tuple(sorted((getattr(module, name) for name, module in modules), key=lambda rule: rule.code))


def _has_mistakes(project: Project) -> bool:
    return bool(project.problems) or bool(project.controllers and project.controllers.faults)


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
    """Whether the robot loads a simulator plugin, or its hardware runs in a simulator."""
    robot = project.robot
    if robot is None or not project.may_be_simulated:
        return False
    if any(gazebo.plugins or any(gazebo.tag.named("sensor")) for gazebo in robot.gazebos):
        return True
    return bool(robot.ros2_controls) and _runs_in_gazebo(project)


def _runs_in_gazebo(project: Project) -> bool:
    from urdfctl.control.simulator_plugins import IN_GAZEBO, components, simulator_of

    return any(simulator_of(project, control) in IN_GAZEBO for control in components(project))


def _may_move_on(project: Project) -> bool:
    if not set(ROS2) & set(project.distros):
        return False
    controlled = project.robot is not None and bool(project.robot.ros2_controls) and project.may_be_simulated
    return controlled or project.controllers is not None or _is_simulated(project)


def _only_todos(project: Project) -> Iterable[str] | None:
    """The rule about what a migration left open, which holds for every project."""
    return None if _may_move_on(project) else ["migration_todo_left"]


def _has_controllers(project: Project) -> bool:
    return project.controllers is not None or bool(project.launch and project.launch.spawns)


def _has_moveit(project: Project) -> bool:
    return project.moveit is not None or bool(project.controllers and project.controllers.moveit_lists)


def _of_mistakes(project: Project) -> Iterable[str]:
    from urdfctl.rules.reading.kinds import rules_of

    return rules_of(project)


def _has_started_files(project: Project) -> bool:
    return project.launch is not None or bool(project.listed or project.absent)


def _without_launch(project: Project) -> Iterable[str] | None:
    """The rules of launch files that look at other files of the package, if there is no launch file."""
    if project.launch is not None:
        return None
    named = {"listed_joint_unknown": project.listed, "installed_file_missing": project.absent}
    return [name for name, found in named.items() if found]


FAMILIES = (
    Family("UC0", "reading", _has_mistakes, Stage.SPAWN, _of_mistakes),
    Family("UC1", "urdf", lambda project: project.robot is not None, Stage.SPAWN),
    Family("UC2", "transmissions", _has_transmissions, Stage.HARDWARE),
    Family("UC3", "ros2_control", _is_controlled_by_ros2, Stage.HARDWARE),
    Family("UC4", "controllers", lambda project: project.controllers is not None, Stage.LOAD),
    Family("UC4", "claims", _has_controllers, Stage.LOAD),
    Family("UC5", "simulation", _is_simulated),
    Family("UC6", "launch", _has_started_files, only=_without_launch),
    Family("UC6", "moveit", _has_moveit),
    Family("UC7", "migration", lambda project: _may_move_on(project) or bool(project.todos), only=_only_todos),
    Family("UC9", "smoke", lambda _: False),
)


def rules_for(project: Project) -> Iterator[Rule]:
    """Yield the rules of the families that concern a project, in the order of their codes."""
    for family in FAMILIES:
        yield from family.load_for(project)


def all_rules() -> Rules:
    """Return every rule, in the order of the codes."""
    return tuple(rule for family in FAMILIES for rule in family.load())


def rule_of(code: str) -> Rule:
    """Return the rule with a code that exists."""
    return next(
        rule for family in FAMILIES if code.startswith(family.prefix) for rule in family.load() if rule.code == code
    )


def stage_of(code: str) -> Stage | StageDependsOn | None:
    """Return the stage that an error of a rule stops. None: it stops neither the robot nor a controller."""
    return next(
        rule.stage or family.stage
        for family in FAMILIES
        if code.startswith(family.prefix)
        for rule in family.load()
        if rule.code == code
    )
