"""Give each requested controller its joints, and see that no two controllers command the same interface."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.control.claims import claims
from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.controllers.recipes import NamedType
from urdfctl.generate.options import GeneratorOptions, Request, Roles
from urdfctl.generate.request.requests import joints_of
from urdfctl.generate.robot.anatomy import Anatomy, anatomy_of
from urdfctl.generate.robot.facts import JointFacts, PartFacts, RobotFacts
from urdfctl.names import did_you_mean
from urdfctl.startup.records import NamedTuple


class Wish(NamedTuple):
    """A requested controller with the kind of its type."""

    request: Request
    kind: NamedType

    @property
    def moves(self) -> bool:
        """Whether it commands joints."""
        return bool(self.kind.interface) and self.kind.short != "gpio"

    @property
    def names_joints(self) -> bool:
        """Whether the user named its joints."""
        return self.moves and bool(self.request.patterns)

    @property
    def title(self) -> str:
        """Its name, or its type."""
        return self.request.name or self.kind.name


class Assignment(NamedTuple):
    """A controller to create: its kind, its joints, and the options and the robot that it is created with."""

    request: Request
    kind: NamedType
    joints: tuple[JointFacts, ...]
    options: GeneratorOptions
    robot: RobotFacts


def assigned(
    wishes: Sequence[Wish], joints: Sequence[JointFacts], options: GeneratorOptions, robot: RobotFacts
) -> Iterator[tuple[int, Assignment]]:
    """Yield the index of each wish and its joints.

    Joints that a wish names go to it. Of the others, drives get their wheels, grippers the fingers, and one more
    controller the rest. UserError if it is ambiguous, or if joints do not exist.
    """
    anatomy = anatomy_of(robot, joints)
    parts = anatomy if sum(wish.moves for wish in wishes) > 1 else None
    named = [joints_of(wish.request, joints, robot) if wish.names_joints else () for wish in wishes]
    taken = {joint.name for members in named for joint in members}
    free = [joint for joint in joints if joint.name not in taken]
    order = sorted(range(len(wishes)), key=lambda index: _turn(wishes[index], shared=parts is not None))
    rest: list[Wish] = []
    for index in order:
        wish, members = wishes[index], named[index]
        if not wish.moves:
            yield from ((index, reading) for reading in _reading(wish, joints, options, robot))
            continue
        if not members:
            members = _alone(wish, free, anatomy) if parts is None else _fitting(wish, free, parts, rest, options)
        roles = wish.request.roles or (options.roles if any(options.roles) else _roles(wish, members, anatomy))
        its = options._replace(roles=roles, interfaces=wish.request.interfaces or options.interfaces)
        if wish.request.interfaces:
            members = tuple(joint._replace(interface=None) for joint in members)
        yield index, Assignment(wish.request, wish.kind, members, its, robot)
        if parts and not wish.names_joints:
            free = _without(free, wish, members, parts)


def _turn(wish: Wish, *, shared: bool) -> int:
    if wish.names_joints:
        return 0
    if wish.kind.roles:
        return 1
    return 2 if shared and wish.kind.short in ("gripper", "omni") else 3


def _alone(wish: Wish, free: Sequence[JointFacts], anatomy: Anatomy) -> tuple[JointFacts, ...]:
    """The joints of the only controller that moves any: the fingers for a gripper, or all."""
    names = {joint.name for joint in free}
    fingers = tuple(joint for tool in anatomy.tools for joint in tool.joints if joint.name in names)
    return (fingers if wish.kind.short == "gripper" else ()) or tuple(free)


def _roles(wish: Wish, members: Sequence[JointFacts], anatomy: Anatomy) -> Roles:
    """The roles of the robot's wheels in a drive of the same kind; none if the joints do not include them."""
    base, names = anatomy.base, {joint.name for joint in members}
    alike = {*_ON_TWO_SIDES} if wish.kind.short in _ON_TWO_SIDES else {wish.kind.short}
    if not wish.kind.roles or base is None or base.kind not in alike:
        return Roles()
    return base.roles if {name for role in base.roles for name in role} <= names else Roles()


_ON_TWO_SIDES = ("diff_drive", "mecanum")


def _fitting(
    wish: Wish, free: Sequence[JointFacts], parts: Anatomy, rest: list[Wish], options: GeneratorOptions
) -> tuple[JointFacts, ...]:
    """The joints of one of several controllers whose joints the user did not name."""
    if wish.kind.roles:
        return tuple(free)
    names = {joint.name for joint in free}
    if wish.kind.short == "gripper":
        fingers = tuple(joint for tool in parts.tools for joint in tool.joints if joint.name in names)
        if not fingers:
            raise UserError(f"'{wish.title}': no joint looks like a gripper; name its joints: {_example(wish)}")
        return fingers
    if wish.kind.short == "omni" and parts.base:
        return tuple(joint for joint in parts.base.joints if joint.name in names)
    same = next((other for other in rest if _interface(other, options) == _interface(wish, options)), None)
    if same:
        raise UserError(
            f"'{same.title}' and '{wish.title}' would command the same joints; name those of each: "
            f"{_example(same)} {_example(wish)}"
        )
    rest.append(wish)
    if not free:
        raise UserError(f"'{wish.title}': no joint remains for it; name its joints: {_example(wish)}")
    return tuple(free)


def _interface(wish: Wish, options: GeneratorOptions) -> str | None:
    asked = wish.request.interfaces[0] if wish.request.interfaces else options.interface
    return asked if asked in wish.kind.fit else wish.kind.interface


def _example(wish: Wish) -> str:
    return f"--controller {wish.request.name or wish.kind.label}={wish.request.type}:REGEX"


def _without(free: list[JointFacts], wish: Wish, members: Sequence[JointFacts], parts: Anatomy) -> list[JointFacts]:
    """The joints that remain after a controller got some that fit it."""
    base = parts.base
    if wish.kind.roles or wish.kind.short == "omni":
        roles = {name for role in wish.request.roles or () for name in role}
        used = roles | {joint.name for joint in (*base.joints, *base.others)} if base else roles
        return [joint for joint in free if joint.name not in used]
    if wish.kind.short == "gripper":
        used = {joint.name for joint in members}
        return [joint for joint in free if joint.name not in used]
    return free


def _reading(
    wish: Wish, joints: Sequence[JointFacts], options: GeneratorOptions, robot: RobotFacts
) -> Iterator[Assignment]:
    """A controller for each sensor that a request names, or one for all gpios that it names."""
    request, kind = wish
    if kind.short == "gpio":
        wanted = [part for part in robot.parts if part.kind != "gpio" or not request.patterns]
        wanted += [_part(name, "gpio", robot) for name in request.patterns]
        yield Assignment(request, kind, (), options, robot._replace(parts=tuple(wanted)))
        return
    if not request.patterns or "joint_state" in kind.short:
        yield Assignment(request, kind, tuple(joints), options, robot)
        return
    for sensor in request.patterns:
        _part(sensor, "sensor", robot)
        yield Assignment(request, kind, tuple(joints), options._replace(sensor=sensor), robot)


def _part(name: str, kind: str, robot: RobotFacts) -> PartFacts:
    """The sensor or gpio with a name. UserError if the robot's `<ros2_control>` does not have it."""
    known = {part.name: part for part in robot.parts if kind in ("sensor", part.kind)}
    if name in known:
        return known[name]
    if robot.components:
        raise UserError(f"the robot's <ros2_control> has no {kind} '{name}'{did_you_mean(name, known)}")
    return PartFacts(kind, name)


# -- conflicts -------------------------------------------------------------------------------------------------------


def without_conflicts(made: Sequence[GeneratedController], named: set[str]) -> list[GeneratedController]:
    """Return the controllers; of two with the same command interface, the later one waits until it is started.

    named: the controllers whose joints the user named. UserError if others command the same interface.
    """
    owners: dict[str, GeneratedController] = {}
    result: list[GeneratedController] = []
    for one in made:
        claimed = claims(one.type, one.name, one.values)
        mine = [claim.name for claim in claimed.command] if claimed else []
        shared = next((name for name in mine if name in owners), None)
        if shared is None:
            owners.update(dict.fromkeys(mine, one))
            result.append(one)
            continue
        other = owners[shared]
        if not {one.name, other.name} <= named:
            raise UserError(
                f"'{other.name}' and '{one.name}' would both command '{shared}'; give each its own joints: "
                "--controller NAME=TYPE:REGEX"
            )
        result.append(one._replace(waits=True))
    return result
