"""Decide which controllers to create for the joints, and what each of them commands and reads."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.errors import UserError
from urdfctl.generate.controllers.fit import copies_commands, offered_by
from urdfctl.generate.controllers.recipes import NamedType
from urdfctl.generate.controllers.values import Task
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.request.choice import joint_named
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.generate.robot.wheels import driven_and_steered, sides

_READ = ("position", "velocity")
_LISTED = 6


def tasks_of(
    kind: NamedType, joints: Sequence[JointFacts], options: GeneratorOptions, robot: RobotFacts
) -> Iterator[Task]:
    """Yield a task for each controller of a kind. Joints with different interfaces get different controllers.

    UserError if the joints do not fit, or if a controller of the kind cannot command all requested interfaces.
    """
    if kind.roles:
        yield _drive(kind, joints, options, robot)
        return
    if kind.short == "gpio":
        joints = _gpios(options, robot)
    by_interfaces: dict[tuple[str, ...], list[JointFacts]] = {}
    known = _known(options, robot)
    common = next((names for joint in joints if (names := _offered(kind, joint, known))), ())
    for joint in joints:
        there = _offered(kind, joint, known) or common
        by_interfaces.setdefault(_commanded(kind, joint, options, there), []).append(joint)
    if not kind.interface:
        by_interfaces = {options.interfaces or ("position",): list(joints)}
    elif not by_interfaces:
        by_interfaces[kind.interface,] = []
    for interfaces, members in by_interfaces.items():
        if kind.interface and len(interfaces) > 1 and not kind.several:
            raise UserError(f"'{kind.name}' commands one interface per joint, not {', '.join(interfaces)}")
        states = _read(kind, interfaces, members, options, robot)
        yield Task(
            kind=kind.short,
            interfaces=interfaces,
            joints=tuple(members),
            robot=robot,
            options=options,
            states=states,
            fit=kind.fit,
        )


def _known(options: GeneratorOptions, robot: RobotFacts) -> Mapping[str, tuple[str, ...]]:
    """The interfaces of the joints; without the efforts of transmissions where mock hardware would only copy them."""
    if not copies_commands(options):
        return robot.interfaces
    moving = {joint: tuple(name for name in names if name != "effort") for joint, names in robot.interfaces.items()}
    return {**moving, **offered_by(robot, options)}


def _offered(kind: NamedType, joint: JointFacts, known: Mapping[str, tuple[str, ...]]) -> tuple[str, ...]:
    """The interfaces of a joint that a kind can command."""
    return tuple(name for name in known.get(joint.name, ()) if name in kind.fit or "any" in kind.fit)


def _commanded(
    kind: NamedType, joint: JointFacts, options: GeneratorOptions, there: tuple[str, ...]
) -> tuple[str, ...]:
    """The command interfaces of a joint: from the joint list, from the user, or those that it or another joint has."""
    if joint.interface:
        return (joint.interface,)
    if options.interfaces:
        return options.interfaces
    fit, wanted = kind.fit, kind.interface or "position"
    if not there or ("any" not in fit and wanted in there):
        return (wanted,)
    return there if "any" in fit and kind.several else there[:1]


def _read(
    kind: NamedType,
    interfaces: Sequence[str],
    joints: Sequence[JointFacts],
    options: GeneratorOptions,
    robot: RobotFacts,
) -> tuple[str, ...]:
    """The state interfaces to read: from the user, or those that all joints offer."""
    if options.states is not None:
        return options.states
    if kind.short == "pid":
        return ("velocity",) if interfaces[0] == "velocity" else ("position",)
    offered = {part.name: part.states for part in robot.of_kind("joint")}
    known = [offered[joint.name] for joint in joints if joint.name in offered]
    return tuple(name for name in _READ if all(name in states for states in known)) or _READ


def _gpios(options: GeneratorOptions, robot: RobotFacts) -> list[JointFacts]:
    """The gpios that the user names, or the robot's gpios, as joints."""
    named = [name.rpartition("/")[0] for name in (*options.interfaces, *(options.states or ())) if "/" in name]
    names = named or [part.name for part in robot.of_kind("gpio")]
    return [JointFacts(name) for name in dict.fromkeys(names or ["gpio"])]


def _drive(kind: NamedType, joints: Sequence[JointFacts], options: GeneratorOptions, robot: RobotFacts) -> Task:
    """The wheels by role: from the user, or determined by their positions."""
    known = robot if robot.joints else None
    roles = [role for role, _ in kind.roles]
    by_role = {role: tuple(joint_named(known, name) for name in getattr(options.roles, role)) for role in roles}
    guessed = sides(joints) if "left" in roles else driven_and_steered(joints)
    for (role, count), guess in zip(kind.roles, guessed, strict=True):
        by_role[role] = by_role[role] or tuple(guess)
        _count(kind, role, count, by_role[role], joints)
    if "left" in by_role and len(by_role["left"]) != len(by_role["right"]):
        left, right = len(by_role["left"]), len(by_role["right"])
        raise UserError(f"{left} wheels on the left and {right} on the right: name them with --left and --right")
    members = tuple(dict.fromkeys(joint for role in by_role.values() for joint in role))
    passive = tuple(joint for joint in joints if joint not in members and kind.short.startswith("tricycle"))
    rolling = [joint for role in ("left", "right", "traction") for joint in by_role.get(role, ())]
    states = _read(kind, ("velocity",), rolling, options, robot)
    of = [by_role.get(role, ()) for role in ("left", "right", "traction", "steering")]
    return Task(
        kind=kind.short,
        interfaces=("velocity",),
        joints=members,
        robot=robot,
        options=options,
        states=states,
        left=of[0],
        right=of[1],
        traction=of[2],
        steering=of[3],
        passive=passive,
    )


def _count(kind: NamedType, role: str, count: int, members: Sequence[JointFacts], joints: Sequence[JointFacts]) -> None:
    """UserError if a role does not have the required number of joints, of which it names those that may have it."""
    if members and count in (0, len(members)):
        return
    wanted = f"{count} joint{'s' if count != 1 else ''}" if count else "joints"
    names = ", ".join(joint.name for joint in members)
    turning = [joint.name for joint in joints if joint.type == "continuous"] or [joint.name for joint in joints]
    choices = f"; choose from: {', '.join(turning[:_LISTED])}" if turning else ""
    more = f" and {len(turning) - _LISTED} more" if len(turning) > _LISTED else ""
    why = f"{len(members)} given: {names}" if members else f"cannot be determined from the robot{choices}{more}"
    raise UserError(f"'{kind.name}' requires --{role} with {wanted}; {why}")
