"""Calls of macros that belong to another robot: the fault is in the call, not in the macro."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Note
from urdfctl.rules.common import in_words
from urdfctl.source.span import Call, Place
from urdfctl.startup.records import NamedTuple


class WrongCall(NamedTuple):
    """A call of a macro that belongs to another robot."""

    call: Call
    """The call of the macro."""
    names: tuple[str, ...]
    """The joints that the macro names."""
    first: Place
    """Where the macro names the first joint."""

    @property
    def finding(self) -> Finding:
        """Return the finding to report at the call."""
        message = f"macro '{self.call.name}' drives {in_words(self.names)}, but this robot has none of these joints"
        return Finding(self.call.at, message, (Note("the macro's first joint is here", self.first),))


def macro_call(at: Place) -> Call | None:
    """Return the call of the macro that a part comes from; None if it is not in a macro."""
    return next((step for step in at.call.chain() if step.kind == "macro"), None) if at.call else None


def wrong_calls(
    robot: Robot, named: Iterable[tuple[Place, str]], is_alike: Callable[[str], bool]
) -> dict[Call | None, WrongCall]:
    """Return the macro calls that name several joints, none of them similar to a joint of this robot.

    Only macros from other files are considered, and only if they define no links or joints themselves.

    named: the place and name of each joint to check.
    is_alike: returns whether a name is similar to that of a joint of the robot.
    """
    by_call: dict[Call | None, list[tuple[Place, str]]] = {}
    for at, name in named:
        by_call.setdefault(macro_call(at), []).append((at, name))
    places = (*(joint.at for joint in robot.joints), *(link.at for link in robot.links))
    parts = {step for at in places if at.call for step in at.call.chain()}
    return {
        call: WrongCall(call, tuple(dict.fromkeys(name for _, name in joints)), joints[0][0])
        for call, joints in by_call.items()
        if call is not None
        and call not in parts
        and call.definition is not None
        and call.definition.file != call.source.path
        and len(joints) > 1
        and not any(is_alike(name) for _, name in joints)
    }
