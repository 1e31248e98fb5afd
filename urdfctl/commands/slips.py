"""Answers to words on the command line that are no command."""

from __future__ import annotations

import os

_COMMANDS = {
    **dict.fromkeys(("validate", "verify"), "lint"),
    **dict.fromkeys(("fix", "repair", "format"), "lint --fix"),
    **dict.fromkeys(("test", "simulate", "sim", "run"), "smoke"),
    **dict.fromkeys(("gen", "generate", "new", "init", "create"), "gen-all"),
    **dict.fromkeys(("xacro", "convert"), "expand"),
    **dict.fromkeys(("list", "ls"), "rules"),
    **dict.fromkeys(("compare", "changes"), "diff"),
    **dict.fromkeys(("draw", "plot", "wiring"), "graph"),
    **dict.fromkeys(("visualize", "visualise", "3d", "open"), "view"),
    **dict.fromkeys(("trace", "where", "whence"), "why"),
    "version": "--version",
    "help": "--help",
}
_ROBOTS = (".urdf", ".xacro", ".yaml", ".yml", ".launch", ".py", ".xml", ".gazebo", ".ros2_control")
_LOGS = (".log", ".txt")


def command_hint(word: str) -> str | None:
    """Return the command that is meant by a word that is none; None if nobody knows."""
    if word in _COMMANDS:
        return f"there is no command '{word}'; use: urdfctl {_COMMANDS[word]}"
    if word.lower().endswith(_LOGS):
        return f"'{word}' is not a command; to explain a log: urdfctl explain {word}"
    if word.lower().endswith(_ROBOTS) or os.path.exists(word):
        return f"'{word}' is not a command; to check it: urdfctl lint {word}"
    return None
