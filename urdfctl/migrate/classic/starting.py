"""What starts Gazebo Classic, and spawns robots in it, as options of gz and of ros_gz_sim's `create`."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TypeVar

from urdfctl.migrate.packages import MigratedPackages
from urdfctl.startup.records import NamedTuple

SERVER, CLIENT = "gzserver.launch.py", "gzclient.launch.py"
FILES = ("gazebo.launch.py", SERVER, CLIENT)
"""The launch files of gazebo_ros."""
_FIXED = {SERVER: {"gui": "false"}}
ARGUMENTS = ("world", "gui", "pause", "verbose", "server")
"""The arguments of those launch files that gz has, too."""
EMPTY_WORLDS = ("worlds/empty.world", "empty.world")
OPTIONS_WITH_VALUE = (
    "-s",
    "--server-plugin",
    "-g",
    "--gui-client-plugin",
    "-e",
    "--physics",
    "--seed",
    "--iters",
    "-o",
    "--profile",
)
"""Options of Gazebo Classic with a value, which gz has not, or with another meaning."""
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


class GzOption(NamedTuple):
    """An option of gz, and the argument of Gazebo Classic that asks for it.

    default: of the argument.
    wanted: the value of the argument that asks for the option.
    text: the option, with a blank.
    """

    argument: str
    default: bool
    wanted: bool
    text: str

    def given(self, value: str) -> str:
        """Return the option if a value of the argument asks for it, its default for an empty one; otherwise nothing."""
        is_true = value.strip().lower() in ("true", "1") if value else self.default
        return self.text if is_true is self.wanted else ""

    def expression(self, value: str) -> str:
        """Return the option as an expression in Python, for a value of the argument that is an expression too."""
        chosen, other = (self.text, "") if self.wanted else ("", self.text)
        return f"'{chosen}' if {value} == 'true' else '{other}'"


OPTIONS = (
    GzOption("pause", default=False, wanted=False, text="-r "),
    GzOption("gui", default=True, wanted=False, text="-s "),
    GzOption("verbose", default=False, wanted=True, text="-v4 "),
)


def flags(file: str, given: Mapping[str, str | None]) -> str:
    """Return the options of gz for a launch file of gazebo_ros.

    given: its arguments; those that are known only when it starts are None, and give no option.
    """
    if file == CLIENT:
        return "-g "
    values = {**given, **_FIXED.get(file, {})}
    known = ((option, values.get(option.argument, "")) for option in OPTIONS)
    return "".join(option.given(value) for option, value in known if value is not None)


def undecided(file: str, given: Mapping[str, str | None]) -> list[GzOption]:
    """Return the options of gz that depend on arguments which are known only when a launch file starts."""
    values = {**given, **_FIXED.get(file, {})}
    return [option for option in OPTIONS if file != CLIENT and values.get(option.argument, "") is None]


def is_empty_world(world: str, *, is_own: bool) -> bool:
    """Return whether a world is the empty one of Gazebo Classic, or none.

    is_own: whether a world of this name is in the packages, and the simulator looks there first.
    """
    named = world in EMPTY_WORLDS and not is_own
    return not world or named or world.endswith("gazebo_ros)/worlds/empty.world")


def has_own_empty_world(packages: MigratedPackages) -> bool:
    """Return whether a world in the packages has the name of the empty one of Gazebo Classic."""
    return any(os.path.basename(path) in EMPTY_WORLDS for path in packages.files(".world"))
