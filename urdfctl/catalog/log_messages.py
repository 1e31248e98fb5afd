"""What ROS and Gazebo print, and what it means."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from urdfctl.catalog.distros import ALL, spanned
from urdfctl.catalog.store import log_message_entries
from urdfctl.hints import Any
from urdfctl.record import NamedTuple

KINDS = ("failure", "consequence", "warning", "harmless")
"""The most urgent first. A consequence tells that something failed, and another line tells why."""


class Cause(NamedTuple):
    """Why a message is printed, and the codes of the rules that find it."""

    text: str
    rules: tuple[str, ...] = ()


class LogMessage(NamedTuple):
    """A message in all its spellings. `{joint}` in its texts stands for the value that a line has in that place; the
    grammar is told in data/README.md."""

    id: str
    kind: str
    by: str
    distros: tuple[str, ...]
    patterns: tuple[str, ...]
    meaning: str
    causes: tuple[Cause, ...]
    fix: str
    authority: str

    @property
    def rules(self) -> tuple[str, ...]:
        """The codes of the rules that find its causes, the likeliest first."""
        return tuple(dict.fromkeys(code for cause in self.causes for code in cause.rules))


@lru_cache(maxsize=1)
def log_messages() -> tuple[LogMessage, ...]:
    """All messages, in the order of the data."""
    return tuple(_message(key, entry) for key, entry in log_message_entries().items())


def _message(key: str, entry: Mapping[str, Any]) -> LogMessage:
    span = entry.get("distros")
    return LogMessage(
        key,
        entry["kind"],
        entry["by"],
        (*spanned(span, 1), *spanned(span, 2)) if span else ALL,
        tuple(entry["messages"]),
        entry["meaning"],
        tuple(Cause(text, tuple(rules)) for text, *rules in entry["causes"]),
        entry.get("fix", ""),
        entry["authority"],
    )
