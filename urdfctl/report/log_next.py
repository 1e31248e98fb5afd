"""What to run when a log has been explained."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.logs.digest import Known
from urdfctl.record import NamedTuple

_MOST_CODES = 6
_URGENT = ("failure", "consequence")


class Command(NamedTuple):
    """A command line, and what it is good for."""

    text: str
    purpose: str


def next_commands(known: Iterable[Known]) -> tuple[Command, ...]:
    """The commands that find the causes, the failures' before the others'."""
    known = tuple(known)
    urgent = [one for one in known if one.message.kind in _URGENT]
    codes = list(dict.fromkeys(code for one in urgent or known for code in one.message.rules))
    if not codes:
        return (Command("urdfctl lint robot.xacro controllers.yaml", "finds what else is wrong"),) if urgent else ()
    shown = ", ".join(codes[:_MOST_CODES]) + (" and others" if len(codes) > _MOST_CODES else "")
    controllers = " controllers.yaml" if any(code.startswith("UC4") for code in codes) else ""
    return (
        Command(f"urdfctl lint robot.xacro{controllers}", f"finds {shown} at the line you wrote"),
        Command(f"urdfctl explain {codes[0]}", "tells more of a rule, with an example"),
    )
