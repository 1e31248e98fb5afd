"""The faults, by families. Each family lists its faults in its `family.py`; one that is not listed does not exist.

A family of rules is imported when it can find something in a project: importing a hundred modules takes time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from importlib import import_module

from urdfctl.catalog.distros import ROS1, ROS2
from urdfctl.fault import Fault
from urdfctl.model.project import Project
from urdfctl.model.stage import Stage, StageDependsOn
from urdfctl.rule import Rule
from urdfctl.rules.installed import installed_rules
from urdfctl.startup.records import NamedTuple

Faults = tuple[Fault, ...]


class Family(NamedTuple):
    """The faults of one folder."""

    prefix: str
    """How their codes begin."""
    name: str
    """The folder."""
    stage: Stage | None = None
    """The stage that an error of the family stops, unless a fault names another one. None: it stops nothing."""
    found_by: str = "lint"
    """The command that finds them."""

    def load(self) -> Faults:
        """Import the folder and return its faults."""
        faults: Faults = import_module(f"urdfctl.rules.{self.name}.family").FAULTS
        return faults


class _Linted(NamedTuple):
    """A family of rules, and when they run."""

    family: Family
    concerns: Callable[[Project], bool]
    """Returns whether they can find anything in a project."""
    only: Callable[[Project], Iterable[str] | None] = lambda _: None
    """Returns the names of the only rules that can find anything in a project; None if any rule can."""

    def load_for(self, project: Project) -> Iterable[Rule]:
        """Import and return the rules that can find anything in a project, in the order of their codes."""
        if not self.concerns(project):
            return ()
        names = self.only(project)
        if names is None:
            return (fault for fault in self.family.load() if isinstance(fault, Rule))
        modules = ((name, import_module(f"urdfctl.rules.{self.family.name}.{name}")) for name in dict.fromkeys(names))
        return sorted((getattr(module, name) for name, module in modules), key=lambda rule: rule.code)


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
    from urdfctl.control.hardware.simulator_plugins import IN_GAZEBO, components, simulator_of

    return any(simulator_of(project, control) in IN_GAZEBO for control in components(project))


def _has_bridge(project: Project) -> bool:
    launch = project.launch
    return launch is not None and any(node.package.text == "ros_gz_bridge" for node in launch.nodes)


def _only_bridges(project: Project) -> Iterable[str] | None:
    """The rule about what a launch file bridges, for a robot that loads no plugin itself."""
    return None if _is_simulated(project) else ["bridge_types_unknown"]


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
    return project.launch is not None or bool(project.listed or any(project.build))


def _without_launch(project: Project) -> Iterable[str] | None:
    """The rules of launch files that look at other files of the package, if there is no launch file."""
    if project.launch is not None:
        return None
    named = {
        "listed_joint_unknown": project.listed,
        "installed_file_missing": project.build.absent,
        "package_not_registered": project.build.unregistered,
    }
    return [name for name, found in named.items() if found]


_LINTED = (
    _Linted(Family("UC0", "reading", Stage.SPAWN), _has_mistakes, _of_mistakes),
    _Linted(Family("UC1", "urdf", Stage.SPAWN), lambda project: project.robot is not None),
    _Linted(Family("UC2", "transmissions", Stage.HARDWARE), _has_transmissions),
    _Linted(Family("UC3", "ros2_control", Stage.HARDWARE), _is_controlled_by_ros2),
    _Linted(Family("UC4", "controllers", Stage.LOAD), lambda project: project.controllers is not None),
    _Linted(Family("UC4", "claims", Stage.LOAD), _has_controllers),
    _Linted(Family("UC5", "simulation"), lambda project: _is_simulated(project) or _has_bridge(project), _only_bridges),
    _Linted(Family("UC6", "launch"), _has_started_files, _without_launch),
    _Linted(Family("UC6", "moveit"), _has_moveit),
    _Linted(Family("UC7", "migration"), lambda project: _may_move_on(project) or bool(project.todos), _only_todos),
)
FAMILIES = (
    *(linted.family for linted in _LINTED),
    Family("UC8", "running", found_by="doctor"),
    Family("UC9", "smoke", Stage.MOVE, found_by="smoke"),
)


def rules_for(project: Project) -> Iterator[Rule]:
    """Yield the rules of the families that concern a project, in the order of their codes."""
    for linted in _LINTED:
        yield from linted.load_for(project)
    for installed in installed_rules():
        yield from installed.rules


def all_faults() -> Faults:
    """Return every fault, in the order of the codes; those of other packages last."""
    own = (fault for family in FAMILIES for fault in family.load())
    return (*own, *(rule for installed in installed_rules() for rule in installed.rules))


def faults_found_by(command: str) -> Faults:
    """Return the faults that a command finds, in the order of the codes; those of other packages last."""
    own = (fault for family in FAMILIES if family.found_by == command for fault in family.load())
    others = installed_rules() if command == "lint" else ()
    return (*own, *(rule for installed in others for rule in installed.rules))


def fault_of(code: str) -> Fault:
    """Return the fault with a code that exists."""
    return _placed(code)[1]


def stage_of(code: str) -> Stage | StageDependsOn | None:
    """Return the stage that an error stops, by its code. None: it stops neither the robot nor a controller."""
    family, fault = _placed(code)
    return fault.stage or (family.stage if family else None)


def command_of(code: str) -> str:
    """Return the name of the command that finds a fault."""
    family, _ = _placed(code)
    return family.found_by if family else "lint"


def origin_of(code: str) -> str:
    """Return what brings a fault: "urdfctl", or the package that is installed beside it, with its version."""
    return next((one.origin for one in installed_rules() if code in {rule.code for rule in one.rules}), "urdfctl")


def _placed(code: str) -> tuple[Family | None, Fault]:
    """The fault with a code, and its family; None for a rule of another package."""
    for family in FAMILIES:
        if code.startswith(family.prefix):
            for fault in family.load():
                if fault.code == code:
                    return family, fault
    return None, next(rule for one in installed_rules() for rule in one.rules if rule.code == code)
