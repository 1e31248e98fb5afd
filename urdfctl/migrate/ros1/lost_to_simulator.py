"""What Gazebo Classic gets from launch files of ROS 1, and gz does not: remappings, and arguments of its own.

gz_ros2_control runs the controllers in the process of gz, which launch's remappings do not reach: they are for nodes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.migrate.edits.markup import attribute
from urdfctl.migrate.launch.actions import Text, is_literal, plain
from urdfctl.migrate.ros1.roslaunch_values import around
from urdfctl.source.xml.dom import Element

_DESCRIPTION = "robot_description"
_ARGUMENTS = {"extra_gazebo_args": ("",), "physics": ("", "ode"), "recording": ("", "false")}
"""Arguments of empty_world.launch that gz's launch file does not have, each with the values that change nothing."""


def remapped_in_simulator(start: Element) -> Iterator[str]:
    """Yield what is left to a person of each remapping that applies to an include or a node of Gazebo Classic."""
    for outer in (start, *around(start)):
        for one in outer.elements():
            old, new = attribute(one, "from"), attribute(one, "to")
            is_after = outer is not start and one.start > start.start
            if one.tagName != "remap" or is_after or old.rpartition("/")[2] == _DESCRIPTION:
                continue
            yield (
                f"the remapping of '{old}' to '{new}' reached the controllers in the simulator: give it to their spawner "
                "by --controller-ros-args if they use the topic"
            )


def lost_arguments(given: Mapping[str, Text], defaults: Mapping[str, str]) -> Iterator[str]:
    """Yield what is left to a person of the arguments of empty_world.launch that gz's launch file does not have.

    defaults: of the arguments of the launch file, which may be their values.
    """
    for name, nothing in _ARGUMENTS.items():
        value = given.get(name, ())
        is_argument = len(value) == 1 and value[0].kind == "arg"
        text = defaults.get(value[0].text, "") if is_argument else plain(value) if is_literal(value) else name
        if text not in nothing:
            yield f"gz has no argument '{name}': what '{text}' did is missing; see the options of gz_args"
