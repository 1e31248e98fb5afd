"""The messages of ROS and Gazebo, with their meaning, causes and fix."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from urdfctl.catalog.distros import ALL, spanned
from urdfctl.catalog.store import log_message_entries
from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple

KINDS = ("failure", "consequence", "warning", "harmless")
"""The kinds of messages, most urgent first. A consequence reports a failure whose reason is in another line."""


class Cause(NamedTuple):
    """A cause of a message, and the codes of the rules that find it."""

    text: str
    rules: tuple[str, ...] = ()


class LogMessage(NamedTuple):
    """A message with all its patterns. In the texts, `{joint}` is replaced by the value in the line; data/README.md
    describes the grammar."""

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
        """The codes of the rules that find its causes, most likely first."""
        return tuple(dict.fromkeys(code for cause in self.causes for code in cause.rules))


@lru_cache(maxsize=1)
def log_messages() -> tuple[LogMessage, ...]:
    """Return all messages, in the order of the data."""
    return tuple(_message(key, entry) for key, entry in log_message_entries().items())


def _message(key: str, entry: Mapping[str, Any]) -> LogMessage:
    span = entry.get("distros")
    return LogMessage(
        id=key,
        kind=entry["kind"],
        by=entry["by"],
        distros=(*spanned(span, 1), *spanned(span, 2)) if span else ALL,
        patterns=tuple(entry["messages"]),
        meaning=entry["meaning"],
        causes=tuple(Cause(text, tuple(rules)) for text, *rules in entry["causes"]),
        fix=entry.get("fix", ""),
        authority=entry["authority"],
    )
