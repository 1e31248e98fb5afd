"""Where a launch file of ROS 2 publishes the robot description: the controller manager of gz reads it from a topic."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import child, content, indent_of, indented, step_of
from urdfctl.migrate.edits.places import key_of, key_of_element
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.model.launch import Node, joined
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

AUTHORITY = (
    "gz_ros2_control gz_ros2_control_plugin.cpp: <ros><remapping>; ros2_control#1410: the manager reads the topic "
    "robot_description"
)
_TOPIC = "robot_description"


def published_elsewhere(packages: MigratedPackages, plugin: Element) -> str:
    """Return the topic of the description if the manager of a plugin would read another one; empty if it does not.

    The manager of gazebo_ros2_control asked robot_state_publisher for a parameter.
    """
    if packages.options.target not in since("jazzy"):
        return ""
    ros = child(plugin, "ros")
    inner = ros.elements() if ros is not None else []
    if any(content(one).startswith(f"{_TOPIC}:=") for one in inner):
        return ""
    space = next((content(one) for one in inner if one.tagName == "namespace"), "")
    key = key_of_element(plugin)
    topics = {
        topic
        for loaded in packages.loaded()
        if loaded.project.robot and any(key_of(one.at) == key for one in loaded.project.robot.plugins)
        for topic in _topics(loaded.project.launch.nodes if loaded.project.launch else ())
    }
    read = joined(joined("", space), _TOPIC)
    topic = next(iter(topics)) if len(topics) == 1 else read
    return "" if UNKNOWN in (topic, read) or topic == read else topic


def _topics(nodes: tuple[Node, ...]) -> Iterator[str]:
    for node in nodes:
        if node.runs("robot_state_publisher", "robot_state_publisher"):
            new = next((new for old, new in node.remaps if old.strip("/") == _TOPIC), _TOPIC)
            is_known = node.complete and node.namespace is not None
            yield joined(node.namespace or "", new) if is_known else UNKNOWN


def reading(plugin: Element, topic: str) -> Edit:
    """Return the edit that makes the manager of a plugin read the description from a topic."""
    ros, step = child(plugin, "ros"), step_of(plugin.source)
    line = f"<remapping>{_TOPIC}:={topic}</remapping>\n"
    around = ros if ros is not None else plugin
    tag = around.source.start_tag(around.start)
    at = tag.end if tag is not None else around.start
    text = line if ros is not None else f"<ros>\n{step}{line}</ros>\n"
    return Edit(SourceSpan(around.source, at, at), "\n" + indented(text, indent_of(around) + step).rstrip("\n"))
