"""Links that are named where a joint is expected: the joint that moves the link is meant."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from urdfctl.model.robot import Joint, Robot
from urdfctl.names import differ_by_kind
from urdfctl.rule import Note
from urdfctl.startup.records import NamedTuple


class MeantJoint(NamedTuple):
    """The joint that an unknown name means."""

    name: str | None
    """None if it is unknown."""
    sure: bool = False


def joint_meant_by(robot: Robot, name: str, similar: str | None, taken: Collection[str | None] = ()) -> MeantJoint:
    """Return the joint that a name means: a similar one, or the one that moves the link of this name.

    It is sure if both are the same joint, whose name differs only by the word for its kind: `wheel` for `wheel_joint`.
    taken: joints that are named beside, so that none of them is meant.
    """
    mover = _mover(robot, name)
    if mover is None or not mover.moves or mover.name in taken or similar not in (None, mover.name):
        return MeantJoint(similar)
    return MeantJoint(mover.name, differ_by_kind(name, mover.name or ""))


def links_called(robot: Robot, name: str) -> Iterator[Note]:
    """Yield a note if a name is that of a link: it names the joint that moves the link."""
    link, mover = robot.link(name), _mover(robot, name)
    if link is not None and mover is None:
        yield Note(f"'{name}' is a link, not a joint", link.at)
    if mover is not None:
        moves = "moves" if mover.moves else "holds"
        yield Note(f"'{name}' is a link; the joint that {moves} it is '{mover.name}'", mover.at)


def _mover(robot: Robot, name: str) -> Joint | None:
    """The only joint whose child is the link of a name."""
    if robot.link(name) is None:
        return None
    joints = [joint for joint in robot.joints if joint.child is not None and joint.child.name == name]
    return joints[0] if len(joints) == 1 and joints[0].name else None
