"""Answers to words on the command line that cannot be what is meant."""

from __future__ import annotations

import os
import re

from urdfctl.errors import UserError

_COMMANDS = {
    **dict.fromkeys(("check", "validate", "verify"), "lint"),
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
_OF_SDF = (".sdf", ".world")
_MESHES = (".stl", ".dae", ".obj", ".glb", ".gltf", ".ply", ".3ds", ".fbx")


def command_hint(word: str) -> str | None:
    """Return the command that is meant by a word that is none; None if nobody knows."""
    if word in _COMMANDS:
        return f"there is no command '{word}'; use: urdfctl {_COMMANDS[word]}"
    if word.lower().endswith(_LOGS):
        return f"'{word}' is not a command; to explain a log: urdfctl explain {word}"
    if word.lower().endswith(_ROBOTS) or os.path.exists(word):
        return f"'{word}' is not a command; to check it: urdfctl lint {word}"
    return None


def check_path(path: str) -> None:
    """Raise UserError if a word cannot name something to check: an address, a substitution, another kind of file."""
    problem = None if os.path.isdir(path) else _problem(path)
    if problem:
        raise UserError(problem)


def _problem(path: str) -> str | None:
    kind = os.path.splitext(path)[1].lower()
    if kind in _OF_SDF:
        return f"'{path}' is an SDF file; name the robot's URDF or xacro"
    if kind in _MESHES:
        return f"'{path}' is a mesh; name the robot's URDF or xacro"
    if os.path.exists(path):
        return None
    if re.match(r"[\w-]+=\S", path) and os.sep not in path.partition("=")[0]:
        name, _, value = path.partition("=")
        return f"file or folder '{path}' does not exist; to set a xacro argument, write {name}:={value}"
    if path.startswith("package://"):
        return f"'{path}' is an address of ROS; name the file, e.g. src/{path.removeprefix('package://')}"
    if re.match(r"\w+://", path):
        return f"'{path}' is an address; urdfctl reads local files: clone or download it first"
    if "$(" in path:
        return f"'{path}' contains a substitution of ROS, which a command line does not expand; name the file"
    return None


def check_description(path: str) -> None:
    """Raise UserError if a file cannot be a robot's description."""
    check_path(path)
    if path.endswith((".launch", ".launch.py", ".launch.xml", ".launch.yaml")):
        raise UserError(f"'{path}' is a launch file; name the robot's URDF or xacro that it starts")
