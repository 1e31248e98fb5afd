"""Which joints are meant: of a robot's, of names, or of a list."""

from __future__ import annotations

import re
from collections.abc import Iterable

from urdfctl.errors import UserError
from urdfctl.generate.facts import JointFacts, RobotFacts
from urdfctl.suggest import did_you_mean


def chosen(
    robot: RobotFacts | None,
    named: Iterable[JointFacts] = (),
    patterns: Iterable[str] = (),
    excluded: Iterable[str] = (),
) -> tuple[JointFacts, ...]:
    """Joints by name, in the order of the names; else all of the robot that can move and mimic no other.

    The `patterns` keep those that they match as a whole, the `excluded` take out. UserError where a name is none of
    the robot's joints, a pattern is none, or nothing is left.
    """
    listed = list(named)
    if listed:
        joints = [_of_robot(joint, robot) if robot else joint for joint in listed]
    else:
        free = [joint for joint in (robot.joints if robot else ()) if not joint.mimics]
        joints = [joint for joint in free if joint.can_move] or free
    wanted, unwanted = [_regex(text) for text in patterns], [_regex(text) for text in excluded]
    _check(wanted, joints)
    kept = [joint for joint in joints if not wanted or any(one.fullmatch(joint.name) for one in wanted)]
    kept = [joint for joint in kept if not any(one.fullmatch(joint.name) for one in unwanted)]
    return tuple({joint.name: joint for joint in kept}.values())


def stuck(robot: RobotFacts, joints: Iterable[JointFacts]) -> tuple[str, ...]:
    """The names of the joints that were passed over, for their limits hold them fast."""
    taken = {joint.name for joint in joints}
    return tuple(joint.name for joint in robot.joints if not (joint.mimics or joint.can_move or joint.name in taken))


def joint_named(robot: RobotFacts | None, name: str) -> JointFacts:
    """A joint by name: the robot's, where there is one. UserError where the robot has none of that name."""
    return _of_robot(JointFacts(name), robot) if robot else JointFacts(name)


def _of_robot(listed: JointFacts, robot: RobotFacts) -> JointFacts:
    """The robot's joint, with what the list says over it."""
    known = {joint.name: joint for joint in robot.joints}
    joint = known.get(listed.name)
    if joint is None:
        if listed.name in robot.fixed:
            raise UserError(f"the joint '{listed.name}' cannot be controlled: it does not move about or along one axis")
        raise UserError(f"the robot has no joint '{listed.name}'{did_you_mean(listed.name, known)}")
    told = {key: value for key, value in listed._asdict().items() if value != JointFacts._field_defaults.get(key)}
    return joint._replace(**told)


def _check(wanted: list[re.Pattern[str]], joints: list[JointFacts]) -> None:
    for one in wanted:
        if not any(one.fullmatch(joint.name) for joint in joints):
            names = [joint.name for joint in joints]
            raise UserError(f"no joint matches '{one.pattern}'{did_you_mean(one.pattern, names)}")


def _regex(text: str) -> re.Pattern[str]:
    try:
        return re.compile(text)
    except re.error as error:
        raise UserError(f"'{text}' is no regular expression: {error}") from None
