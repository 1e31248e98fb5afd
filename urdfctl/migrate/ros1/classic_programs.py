"""The programs of gazebo_ros that a launch file of ROS 1 starts as nodes: the simulator, its server or its window."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.migrate.classic.starting import OPTIONS_WITH_VALUE
from urdfctl.migrate.launch.actions import Text, is_literal, literal, plain

SERVERS = ("gazebo", "gzserver", "debug", "gdbrun", "perf")
"""The programs of gazebo_ros in ROS 1 that start a simulator."""
CLIENT = "gzclient"
_FLAGS = {"-u": "paused", "--pause": "paused", "--verbose": "verbose"}


def given_to_simulator(program: str, words: Sequence[Text]) -> dict[str, Text]:
    """Return the arguments of gazebo_ros' empty_world.launch that mean what the command line of a program does."""
    given = dict(_given(words))
    return {"gui": literal("false"), **given} if program == "gzserver" else given


def _given(words: Sequence[Text]) -> Iterator[tuple[str, Text]]:
    rest = iter(words)
    for word in reversed([word for word in rest if not _skips_value(word, rest)]):
        text = plain(word) if is_literal(word) else ""
        if text in _FLAGS:
            yield _FLAGS[text], literal("true")
        elif not text.startswith("-"):
            yield "world_name", word


def _skips_value(word: Text, rest: Iterator[Text]) -> bool:
    """Whether a word is an option with a value, which is passed over with it."""
    is_option = is_literal(word) and plain(word) in OPTIONS_WITH_VALUE
    if is_option:
        next(rest, None)
    return is_option
