"""Remappings around Gazebo Classic: the controllers in it had them, and those in gz do not.

gz_ros2_control runs the controllers in the process of gz, which launch's remappings do not reach: they are for nodes.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.migrate.edits.markup import attribute
from urdfctl.migrate.ros1.roslaunch_values import around
from urdfctl.source.xml.dom import Element

_DESCRIPTION = "robot_description"


def remapped_in_simulator(include: Element) -> Iterator[str]:
    """Yield what is left to a person of each remapping that applies to an include of Gazebo Classic."""
    for outer in around(include):
        for one in outer.elements():
            old, new = attribute(one, "from"), attribute(one, "to")
            if one.tagName != "remap" or one.start > include.start or old.rpartition("/")[2] == _DESCRIPTION:
                continue
            yield (
                f"the remapping of '{old}' to '{new}' reached the controllers in the simulator: give it to their spawner "
                "by --controller-ros-args if they use the topic"
            )
