"""What starts Gazebo Classic, and spawns robots in it, as options of gz and of ros_gz_sim's `create`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TypeVar

FILES: Mapping[str, str] = {"gazebo.launch.py": "-r ", "gzserver.launch.py": "-r -s ", "gzclient.launch.py": "-g "}
"""The launch files of gazebo_ros, with the options of gz that do the same."""
ARGUMENTS = ("world", "gui", "pause", "verbose", "server")
"""The arguments of those launch files that gz has, too."""
EMPTY_WORLDS = ("worlds/empty.world", "empty.world")
SPAWN = "spawn_entity.py"
_RENAMED = {"-entity": "-name", "-model": "-name"}
WITHOUT_SUCCESSOR = {
    "-b": 0,
    "-bond": 0,
    "-gazebo_namespace": 1,
    "-J": 2,
    "-package_to_model": 0,
    "-reference_frame": 1,
    "-robot_namespace": 1,
    "-sdf": 0,
    "-spawn_service_timeout": 1,
    "-timeout": 1,
    "-unpause": 0,
    "-urdf": 0,
    "-wait": 1,
}
"""Options of spawn_entity.py that `create` rejects, with the number of their values."""

Word = TypeVar("Word")


def create_options(words: Sequence[tuple[str, Word]]) -> Iterator[tuple[str, Word]]:
    """Yield the words of spawn_entity.py that `create` takes too: what they are now, and the word.

    words: the text of each word, empty if it is not known, and whatever stands for the word.
    """
    left = 0
    for text, word in words:
        if left:
            left -= 1
        elif text in WITHOUT_SUCCESSOR:
            left = WITHOUT_SUCCESSOR[text]
        else:
            yield _RENAMED.get(text, text), word


def flags(file: str, given: Mapping[str, str]) -> str:
    """Return the options of gz for a launch file of gazebo_ros with some arguments, which are known or empty."""
    found = FILES[file]
    if given.get("pause", "").lower() == "true":
        found = found.replace("-r ", "")
    if given.get("gui", "").lower() == "false" and "-s" not in found:
        found += "-s "
    if given.get("verbose", "").lower() == "true":
        found += "-v4 "
    return found


def is_empty_world(world: str) -> bool:
    """Return whether a world is the empty one of Gazebo Classic, or none."""
    return not world or world in EMPTY_WORLDS or world.endswith("gazebo_ros)/worlds/empty.world")
