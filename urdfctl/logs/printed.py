"""What the runtime prints because of a fault, so that who has the log finds the rule."""

from __future__ import annotations

import re

from urdfctl.catalog.log_messages import KINDS, LogMessage, log_messages
from urdfctl.startup.records import NamedTuple

_MOST = 4


class PrintedMessage(NamedTuple):
    """A message of the runtime. text: with the names in capitals. by: the program that prints it. id: its name in the
    catalogue."""

    text: str
    by: str
    id: str


def printed_because_of(code: str) -> tuple[PrintedMessage, ...]:
    """Return the messages that a fault causes, by the code of its rule: those that it is the likeliest cause of
    first, and failures before consequences and warnings."""
    caused = [message for message in log_messages() if code in message.rules]
    caused.sort(key=lambda message: _distance(message, code))
    return tuple(
        PrintedMessage(with_capitals(message.patterns[0]), message.by, message.id) for message in caused[:_MOST]
    )


def with_capitals(text: str) -> str:
    """Return a text of the catalogue with its placeholders in capitals."""
    return re.sub(r"\{\{|\}\}|\{(\w*)(:\w+)?\}", _capitals, text)


def _capitals(gap: re.Match[str]) -> str:
    return gap[0][0] if gap[1] is None else gap[1].upper() or "…"


def _distance(message: LogMessage, code: str) -> tuple[int, int]:
    place = next(number for number, cause in enumerate(message.causes) if code in cause.rules)
    return place, KINDS.index(message.kind)
