"""The messages of ROS and Gazebo, with their meaning, causes and fix."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

from urdfctl.catalog.distros import ALL, spanned
from urdfctl.catalog.store import log_message_entries
from urdfctl.startup.records import NamedTuple

KINDS = ("failure", "consequence", "warning", "harmless", "progress")
"""The kinds of messages, most urgent first. A consequence reports a failure whose reason is in another line. Progress
is only evidence about other messages, and is not reported."""


class Cause(NamedTuple):
    """A cause of a message.

    rules: the codes of the rules that find it.
    first_if, only_if: conditions on the rest of the log; urdfctl/logs/evidence.py describes them.
    fix: what to do about this cause, if the message's fix does not fit.
    """

    text: str
    rules: tuple[str, ...] = ()
    first_if: str = ""
    only_if: str = ""
    fix: str = ""


class LogMessage(NamedTuple):
    """A message with all its patterns. In the texts, `{joint}` is replaced by the value in the line; data/README.md
    describes the grammar.

    info: whether it has its kind in a line of level INFO too. Others are then only progress.
    settles: the ids of earlier messages that this one makes harmless. ends: those of later messages that are normal.
    everywhere: whether it settles them in every process and at any time, not only earlier ones of its own process.
    """

    id: str
    kind: str
    by: str
    distros: tuple[str, ...]
    patterns: tuple[str, ...]
    meaning: str
    causes: tuple[Cause, ...]
    fix: str
    authority: str
    info: bool = False
    settles: tuple[str, ...] = ()
    ends: tuple[str, ...] = ()
    everywhere: bool = False

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
        meaning=entry.get("meaning", ""),
        causes=tuple(map(_cause, entry["causes"])),
        fix=entry.get("fix", ""),
        authority=entry["authority"],
        info=entry.get("info", False),
        settles=tuple(entry.get("settles", ())),
        ends=tuple(entry.get("ends", ())),
        everywhere=entry.get("everywhere", False),
    )


def _cause(entry: Sequence[str] | Mapping[str, Any]) -> Cause:
    """A cause from its text and rules, or from a map of its fields."""
    if isinstance(entry, Mapping):
        return Cause(**{**entry, "rules": tuple(entry.get("rules", ()))})
    text, *rules = entry
    return Cause(text, tuple(rules))
