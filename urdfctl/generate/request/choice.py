"""Select joints: from a robot, by name, or from a list."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from urdfctl.errors import UserError
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.names import did_you_mean, enumerated, is_slip

_MOST_NAMED = 6


def chosen(
    robot: RobotFacts | None,
    named: Iterable[JointFacts] = (),
    patterns: Iterable[str] = (),
    excluded: Iterable[str] = (),
) -> tuple[JointFacts, ...]:
    """Return the named joints in that order, or else all joints of the robot that can move and mimic no other.

    Only joints that fully match one of the `patterns` are kept, if there are any. Joints that match one of `excluded`
    are removed. UserError if the robot does not have a named joint, or if a pattern is invalid or matches nothing.
    """
    listed = list(named)
    if listed:
        joints = [_of_robot(joint, robot) if robot else joint for joint in listed]
    else:
        free = [joint for joint in (robot.joints if robot else ()) if not joint.mimics]
        joints = [joint for joint in free if joint.can_move] or free
    wanted, unwanted = [regex_of(text) for text in patterns], [regex_of(text) for text in excluded]
    _check(wanted, joints)
    kept = [joint for joint in joints if not wanted or any(pattern.fullmatch(joint.name) for pattern in wanted)]
    kept = [joint for joint in kept if not any(pattern.fullmatch(joint.name) for pattern in unwanted)]
    return tuple({joint.name: joint for joint in kept}.values())


def stuck(robot: RobotFacts, joints: Iterable[JointFacts]) -> tuple[str, ...]:
    """Return the names of the joints that were skipped because their limits leave them no motion."""
    taken = {joint.name for joint in joints}
    return tuple(joint.name for joint in robot.joints if not (joint.mimics or joint.can_move or joint.name in taken))


def joint_named(robot: RobotFacts | None, name: str) -> JointFacts:
    """Return the joint of this name, from the robot if there is one. UserError if the robot has no such joint."""
    return _of_robot(JointFacts(name), robot) if robot else JointFacts(name)


def _of_robot(listed: JointFacts, robot: RobotFacts) -> JointFacts:
    """The robot's joint, overridden by the values of the list."""
    known = {joint.name: joint for joint in robot.joints}
    joint = known.get(listed.name)
    if joint is None:
        if listed.name in robot.fixed:
            raise UserError(
                f"joint '{listed.name}' cannot be controlled: it does not move about or along a single axis"
            )
        raise UserError(f"the robot has no joint '{listed.name}'{did_you_mean(listed.name, known)}")
    given = {key: value for key, value in listed._asdict().items() if value != JointFacts._field_defaults.get(key)}
    if "inertia" in given:
        given["load"] = None
    return joint._replace(**given)


def _check(wanted: list[re.Pattern[str]], joints: list[JointFacts]) -> None:
    for regex in wanted:
        if not any(regex.fullmatch(joint.name) for joint in joints):
            raise UserError(no_match(regex.pattern, [joint.name for joint in joints]))


def no_match(pattern: str, names: Sequence[str]) -> str:
    """Return the error for a pattern that matches no whole name: what would match, or the joints that there are."""
    problem = f"no joint matches '{pattern}'"
    parts = [name for name in names if pattern and re.search(pattern, name)]
    if parts and not any(is_slip(pattern, name) for name in names):
        wider = f"{'' if parts[0].startswith(pattern) else '.*'}{pattern}{'' if parts[0].endswith(pattern) else '.*'}"
        return f"{problem}: a pattern matches whole names; '{wider}' matches {_in_words(parts)}"
    return problem + (did_you_mean(pattern, names) or f"; the joints are {_in_words(names)}" * bool(names))


def _in_words(names: Sequence[str]) -> str:
    quoted = [f"'{name}'" for name in names]
    rest = len(quoted) - _MOST_NAMED
    return enumerated([*quoted[:_MOST_NAMED], f"{rest} more"] if rest > 1 else quoted)


def regex_of(text: str) -> re.Pattern[str]:
    """Return a regular expression. UserError if it is invalid."""
    try:
        return re.compile(text)
    except re.error as error:
        raise UserError(f"'{text}' is not a valid regular expression: {error}") from None
