"""The programs of gazebo_ros that a launch file of ROS 1 starts as nodes: the simulator, its server or its window."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.migrate.classic.starting import OPTIONS_WITH_VALUE
from urdfctl.migrate.launch.actions import Text, is_literal, literal, plain

SERVERS = ("gazebo", "gzserver", "debug", "gdbrun", "perf")
"""The programs of gazebo_ros in ROS 1 that start a simulator."""
CLIENT = "gzclient"
_FLAGS = {"-u": "paused", "--pause": "paused", "--verbose": "verbose"}


def given_to_simulator(program: str, words: Sequence[Text]) -> dict[str, Text]:
    """Return the arguments of gazebo_ros' empty_world.launch that mean what the command line of a program does."""
    given = {"gui": literal("false")} if program == "gzserver" else {}
    rest = iter(words)
    for word in rest:
        text = plain(word) if is_literal(word) else ""
        if text in OPTIONS_WITH_VALUE:
            next(rest, None)
        elif text in _FLAGS:
            given[_FLAGS[text]] = literal("true")
        elif not text.startswith("-"):
            given.setdefault("world_name", word)
    return given
