"""The commands to run after a log is explained."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.logs.digest import Known
from urdfctl.startup.records import NamedTuple

_MOST_CODES = 6
_URGENT = ("failure", "consequence")


class Command(NamedTuple):
    """A command line and its purpose."""

    text: str
    purpose: str


def next_commands(known: Iterable[Known]) -> tuple[Command, ...]:
    """Return the commands that find the causes: of the failures, or of the other messages if there are no failures."""
    known = tuple(known)
    urgent = [entry for entry in known if entry.kind in _URGENT]
    codes = list(dict.fromkeys(code for entry in urgent or known for code in entry.rules))
    if not codes:
        return (Command("urdfctl lint robot.xacro controllers.yaml", "finds other errors"),) if urgent else ()
    more = f" and {len(codes) - _MOST_CODES} more" if len(codes) > _MOST_CODES else ""
    shown = ", ".join(codes[:_MOST_CODES]) + more
    controllers = " controllers.yaml" if any(code.startswith("UC4") for code in codes) else ""
    return (
        Command(f"urdfctl lint robot.xacro{controllers}", f"finds {shown} in your files"),
        Command(f"urdfctl explain {codes[0]}", "explains a rule, with an example"),
    )
