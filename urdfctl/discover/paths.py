"""Answers to words that cannot name what is meant: a robot, a file that belongs to one, or a folder."""

from __future__ import annotations

import os
import re

from urdfctl.errors import UserError

_OF_SDF = (".sdf", ".world")
_MESHES = (".stl", ".dae", ".obj", ".glb", ".gltf", ".ply", ".3ds", ".fbx")


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
