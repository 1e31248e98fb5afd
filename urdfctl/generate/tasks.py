"""Which controllers are to be made of some joints: how many of each kind, and what each commands and reads."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.errors import UserError
from urdfctl.generate.choice import joint_named
from urdfctl.generate.facts import JointFacts, RobotFacts
from urdfctl.generate.options import Options
from urdfctl.generate.recipes import Kind
from urdfctl.generate.values import Task
from urdfctl.generate.wheels import driven_and_steered, sides

_READ = ("position", "velocity")


def tasks_of(kind: Kind, joints: Sequence[JointFacts], options: Options, robot: RobotFacts) -> Iterator[Task]:
    """What a kind's controllers are for: joints of different interfaces have one each. UserError where the joints do
    not fit, or more interfaces are asked for than a controller of the kind commands."""
    if kind.roles:
        yield _drive(kind, joints, options, robot)
        return
    if kind.name == "gpio":
        joints = _gpios(options, robot)
    by_interfaces: dict[tuple[str, ...], list[JointFacts]] = {}
    for joint in joints:
        by_interfaces.setdefault(_commanded(kind, joint, options, robot), []).append(joint)
    if not kind.interface:
        by_interfaces = {options.interfaces or ("position",): list(joints)}
    elif not by_interfaces:
        by_interfaces[kind.interface,] = []
    for interfaces, members in by_interfaces.items():
        if kind.interface and len(interfaces) > 1 and not kind.several:
            raise UserError(f"'{kind.name}' commands one interface of a joint, not {', '.join(interfaces)}")
        states = _read(kind, interfaces, members, options, robot)
        yield Task(kind.name, interfaces, tuple(members), robot, options, states)


def _commanded(kind: Kind, joint: JointFacts, options: Options, robot: RobotFacts) -> tuple[str, ...]:
    """What a joint is commanded by: as the list says, or the user, else what it has."""
    if joint.interface:
        return (joint.interface,)
    if options.interfaces:
        return options.interfaces
    fit, wanted = kind.fit, kind.interface or "position"
    there = tuple(name for name in robot.interfaces.get(joint.name, ()) if name in fit or "any" in fit)
    if not there or ("any" not in fit and wanted in there):
        return (wanted,)
    return there if "any" in fit and kind.several else there[:1]


def _read(
    kind: Kind, interfaces: Sequence[str], joints: Sequence[JointFacts], options: Options, robot: RobotFacts
) -> tuple[str, ...]:
    """The states that are read: as the user says, else those of all the joints that the robot offers."""
    if options.states is not None:
        return options.states
    if kind.name == "pid":
        return ("velocity",) if interfaces[0] == "velocity" else ("position",)
    offered = {part.name: part.states for part in robot.of_kind("joint")}
    known = [offered[joint.name] for joint in joints if joint.name in offered]
    return tuple(name for name in _READ if all(name in states for states in known)) or _READ


def _gpios(options: Options, robot: RobotFacts) -> list[JointFacts]:
    """The gpios that the user names, else the robot's, as if they were joints."""
    named = [name.rpartition("/")[0] for name in (*options.interfaces, *(options.states or ())) if "/" in name]
    found = named or [part.name for part in robot.of_kind("gpio")]
    return [JointFacts(name) for name in dict.fromkeys(found or ["gpio"])]


def _drive(kind: Kind, joints: Sequence[JointFacts], options: Options, robot: RobotFacts) -> Task:
    """The wheels by their roles: as the user says, else by where they are."""
    known = robot if robot.joints else None
    roles = [role for role, _ in kind.roles]
    found = {role: tuple(joint_named(known, name) for name in getattr(options.roles, role)) for role in roles}
    guessed = sides(joints) if "left" in roles else driven_and_steered(joints)
    for (role, count), guess in zip(kind.roles, guessed, strict=True):
        found[role] = found[role] or tuple(guess)
        _count(kind, role, count, found[role])
    if "left" in found and len(found["left"]) != len(found["right"]):
        left, right = len(found["left"]), len(found["right"])
        raise UserError(f"{left} wheels on the left and {right} on the right: name them with --left and --right")
    members = tuple(dict.fromkeys(joint for role in found.values() for joint in role))
    passive = tuple(joint for joint in joints if joint not in members and kind.name.startswith("tricycle"))
    rolling = [joint for role in ("left", "right", "traction") for joint in found.get(role, ())]
    states = _read(kind, ("velocity",), rolling, options, robot)
    of = [found.get(role, ()) for role in ("left", "right", "traction", "steering")]
    return Task(kind.name, ("velocity",), members, robot, options, states, of[0], of[1], of[2], of[3], passive)


def _count(kind: Kind, role: str, count: int, members: Sequence[JointFacts]) -> None:
    """UserError where a role has not as many joints as it wants."""
    if members and count in (0, len(members)):
        return
    wanted = f"{count} joint{'s' if count != 1 else ''}" if count else "joints"
    found = ", ".join(joint.name for joint in members)
    why = f"it is given {len(members)}: {found}" if members else "the robot does not tell which they are"
    raise UserError(f"'{kind.name}' needs --{role} with {wanted}: {why}")
