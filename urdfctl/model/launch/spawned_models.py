"""The models that programs of Gazebo Classic for ROS 1 put into the simulator from a file of their own."""

from __future__ import annotations

from collections.abc import Sequence

_PROGRAM = ("gazebo_ros", "spawn_model")


def urdf_file_of(package: str, program: str, words: Sequence[str]) -> int | None:
    """Return the index of the URDF file among a program's words; None if it takes its model from elsewhere.

    gazebo_ros (noetic), scripts/spawn_model: -file is the path of the model, and -urdf says what is in it.
    """
    if (package, program) != _PROGRAM or "-urdf" not in words:
        return None
    files = [index for index, word in enumerate(words) if index and words[index - 1] == "-file"]
    return files[0] if len(files) == 1 and words[files[0]].endswith(".urdf") else None
