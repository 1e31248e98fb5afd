"""The launch files of a workspace: what is started in which file, and which arguments are passed on."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from types import ModuleType

from systems.possible import Idioms
from systems.render.actions import Action, Arg, Group, Include, LaunchFile, Value, Variable, args_in
from systems.render.arguments import Values
from systems.render.description import ADDRESS, CHOICE
from systems.render.launch import ros1_nodes, ros2_nodes
from systems.render.places import DESCRIPTION, MANAGER, SIMULATOR, Places, pick, starts_of
from systems.system import Robot, System

_ENDS = {"python": ".py", "xml": ".xml", "yaml": ".yaml", "launch": ""}
_STEMS = {DESCRIPTION: "description", MANAGER: "hardware"}


@dataclass
class Plan:
    """The launch files of a workspace, those that somebody starts first, and the values of their arguments."""

    system: System
    idioms: Idioms
    places: Places
    files: list[LaunchFile] = field(default_factory=list)
    starts: list[LaunchFile] = field(default_factory=list)
    right: dict[str, Value] = field(default_factory=dict)
    wrong: dict[str, Value] = field(default_factory=dict)

    @property
    def passing(self) -> str:
        """How arguments are passed; robots that share files are given theirs."""
        passing = self.idioms["passing"]
        return "overridden" if self.idioms["fleet"] == "shared" and passing == "default" else passing

    @property
    def nodes(self) -> ModuleType:
        """The module with what is started in its generation of ROS."""
        return ros1_nodes if self.system.generation == 1 else ros2_nodes

    def language(self, switch: str) -> str:
        """Return the language of the files that a switch is about."""
        return "launch" if self.system.generation == 1 else self.idioms[switch]

    @property
    def needs_examples(self) -> bool:
        """Whether defaults name files that are only examples."""
        shares = (value for file in self.files for _, value in file.declared if value)
        return self.idioms["described"] == "twice" or any("example" in str(value) for value in shares)


def file_name(plan: Plan, file: LaunchFile) -> str:
    """Return the name of a launch file with what its language adds."""
    if file.language == "launch":
        is_part = file not in plan.starts and pick(plan.system, "part", (True, False))
        return f"{file.stem}.launch{'.xml' if is_part else ''}"
    return f"{file.stem}{plan.idioms['suffix']}{_ENDS[file.language]}"


def planned(system: System, idioms: Idioms, places: Places) -> Plan:
    """Return the launch files of a ROS 2 system."""
    plan = Plan(system, idioms, places)
    for name, roles in starts_of(system, idioms):
        start = LaunchFile(places.bringup, name, plan.language("top"), ())
        actions = _flat(plan, roles) if idioms["depth"] == "flat" else _included(plan, start.stem, roles)
        start.actions = tuple(actions[::-1] if idioms["order"] == "backward" else actions)
        start.declared = _declared(plan, start, is_top=True)
        start.is_set = idioms["defaults"] == "set"
        plan.starts.append(start)
    plan.files[:0] = plan.starts
    return plan


def _values(plan: Plan, robot: Robot) -> Values:
    return Values(plan.system, plan.idioms, plan.places, robot)


def _actions(plan: Plan, roles: Iterable[str], robots: Sequence[Robot]) -> list[Action]:
    found: list[Action] = []
    for role in roles:
        if role == SIMULATOR:
            found += plan.nodes.simulator(plan.system, plan.idioms)
        for robot in robots:
            values = _values(plan, robot)
            found += plan.nodes.actions_of(role, values)
            plan.right.update(values.right)
            plan.wrong.update(values.wrong)
    return found


def _flat(plan: Plan, roles: Sequence[str]) -> list[Action]:
    return _actions(plan, roles, plan.system.robots)


# -- files that are included --------------------------------------------------------------------------------------


def _included(plan: Plan, start: str, roles: Sequence[str]) -> list[Action]:
    """What a start consists of if each role has a file of its own, and maybe each robot one around them."""
    shared = plan.idioms["fleet"] == "shared"
    actions: list[Action] = []
    if SIMULATOR in roles:
        actions.append(_of_simulator(plan))
    own = [role for role in roles if role != SIMULATOR]
    for index, robot in enumerate(plan.system.robots):
        is_new = index == 0 or not shared
        label = f"{robot.name}_" if plan.system.is_fleet and not shared else ""
        files = [_file_of(plan, role, robot, label, is_new=is_new) for role in own]
        includes: list[Action] = [_include(plan, file, robot, is_top=plan.idioms["depth"] == "parts") for file in files]
        if plan.idioms["depth"] == "nested" and own:
            stem = f"{label}{start}_{pick(plan.system, 'middle file', ('all', 'parts', 'base'))}"
            middle = _file(plan, stem, plan.places.bringup, includes, is_new=is_new)
            includes = [_include(plan, middle, robot, is_top=True)]
        around = plan.idioms["namespacing"] == "group around include" and robot.namespace
        actions += [Group(tuple(includes), (robot.namespace,))] if around else includes
    return actions


def _of_simulator(plan: Plan) -> Include:
    file = _file(plan, "simulator", plan.places.bringup, plan.nodes.simulator(plan.system, plan.idioms), is_new=True)
    return Include(file.package, file.stem)


def _file_of(plan: Plan, role: str, robot: Robot, label: str, *, is_new: bool) -> LaunchFile:
    package = plan.places.description if role == DESCRIPTION else plan.places.control
    stem = label + _STEMS.get(role, pick(plan.system, "spawner file", ("spawners", "load_controllers")))
    return _file(plan, stem, package, _actions(plan, [role], [robot]), is_new=is_new)


def _file(plan: Plan, stem: str, package: str, actions: list[Action], *, is_new: bool) -> LaunchFile:
    """An included file; the one that is there already if it is shared by robots."""
    if not is_new:
        return next(file for file in plan.files if file.stem == stem)
    ordered = actions[::-1] if plan.idioms["order"] == "backward" else actions
    file = LaunchFile(package, stem, plan.language("inner"), tuple(ordered))
    file.declared = _declared(plan, file, is_top=False)
    plan.files.append(file)
    return file


def _include(plan: Plan, file: LaunchFile, robot: Robot, *, is_top: bool) -> Include:
    """An include with the arguments that the file declares. is_top: whether a file that somebody starts includes it."""
    passing = plan.passing
    right = plan.right
    if plan.idioms["fleet"] == "shared":
        right = {**right, **_right_of(plan, robot)}
    names = [name for name, _ in file.declared if name in right]
    if passing == "default":
        names = []
    names += [ADDRESS] if (ADDRESS, None) in file.declared else []
    literal = passing == "overridden" or (plan.idioms["fleet"] == "shared" and passing == "required")
    given = tuple((name, right[name] if literal and is_top and name in right else (Arg(name),)) for name in names)
    return Include(file.package, file.stem, given)


def _right_of(plan: Plan, robot: Robot) -> dict[str, Value]:
    """The arguments of one robot of those that share their files."""
    values = _values(plan, robot)
    _ = values.namespace, values.files, values.description, values.controller
    return values.right


# -- arguments ----------------------------------------------------------------------------------------------------


def _declared(plan: Plan, file: LaunchFile, *, is_top: bool) -> tuple[tuple[str, Value | None], ...]:
    """The arguments of a file: those that it uses, with the default that the switch "passing" says."""
    found: list[tuple[str, Value | None]] = []
    for name in args_in(file.actions):
        if name == ADDRESS:
            found.append((name, None))
        elif name in plan.right:
            found.append((name, _default(plan, name, is_top=is_top)))
        else:
            found.append((name, (plan.nodes.DEFAULTS.get(name, _usual(plan, name)),)))
    return tuple(found)


def _from_environment(plan: Plan, name: str) -> Value:
    """The right value, by way of an environment variable that is not set if the switch says so."""
    right = plan.right[name]
    if plan.idioms["defaults"] == "environment" and is_typed(right):
        return (Variable(f"START_{name}".upper(), str(right[0])),)
    return right


def is_typed(value: Value) -> bool:
    """Return whether a value can be typed in a terminal."""
    return len(value) == 1 and isinstance(value[0], str) and bool(value[0])


def _usual(plan: Plan, name: str) -> str:
    return str(plan.system.is_simulated).lower() if name == CHOICE else "true"


def _default(plan: Plan, name: str, *, is_top: bool) -> Value | None:
    passing = plan.passing
    if is_top and plan.idioms["told"] != "nowhere" and is_typed(plan.right[name]):
        return None
    if is_top or passing == "default":
        return _from_environment(plan, name)
    return None if passing == "required" else plan.wrong[name]
