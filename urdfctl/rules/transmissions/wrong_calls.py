"""Calls of macros that are made for another robot: the fault is not in the macro, but where it is called."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.rule import Finding, Note
from urdfctl.rules.common import in_words
from urdfctl.source.span import Call, Place


class WrongCall(NamedTuple):
    """A call of a macro that fits another robot: the names that the macro gives, and where the first one stands."""

    call: Call
    names: tuple[str, ...]
    first: Place

    @property
    def finding(self) -> Finding:
        """What is to be told of it."""
        message = f"macro '{self.call.name}' drives {in_words(self.names)}, and this robot has none of them"
        return Finding(self.call.at, message, (Note("the macro's first joint is here", self.first),))


def macro_call(at: Place) -> Call | None:
    """The call of the macro that a part was written in; None where it stands in none."""
    return next((step for step in at.call.chain() if step.kind == "macro"), None) if at.call else None


def wrong_calls(
    robot: Robot, named: Iterable[tuple[Place, str]], is_alike: Callable[[str], bool]
) -> dict[Call | None, WrongCall]:
    """The calls of macros of other files that name several joints, all of them like none of this robot's, and bring no
    part themselves."""
    by_call: dict[Call | None, list[tuple[Place, str]]] = {}
    for at, name in named:
        by_call.setdefault(macro_call(at), []).append((at, name))
    places = (*(joint.at for joint in robot.joints), *(link.at for link in robot.links))
    parts = {step for at in places if at.call for step in at.call.chain()}
    return {
        call: WrongCall(call, tuple(dict.fromkeys(name for _, name in found)), found[0][0])
        for call, found in by_call.items()
        if call is not None
        and call not in parts
        and call.definition is not None
        and call.definition.file != call.source.path
        and len(found) > 1
        and not any(is_alike(name) for _, name in found)
    }
