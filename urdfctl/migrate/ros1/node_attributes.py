"""The attributes and parameters of a node of ROS 1 that are options of the node in ROS 2, and those that are lost."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from urdfctl.source.xml.dom import Element

_NUMBER = re.compile(r"\d+(\.\d*)?")
_RENAMED = {
    "joy_node": {"dev": "device_id (0 for js0) or device_name", "coalesce_interval": "coalesce_interval_ms"},
}
"""By program: parameters that ROS 2 ignores, and what it reads instead (joy README, ros2 branch)."""


def flags_of(attrs: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Yield the options of a node in ROS 2 for its attributes in ROS 1 (roslaunch/XML/node on wiki.ros.org; launch_ros Node)."""
    if attrs.get("output") in {"screen", "log"}:
        yield "output", attrs["output"]
    if _is_true(attrs.get("respawn")):
        yield "respawn", "True"
        delay = attrs.get("respawn_delay", "")
        if _NUMBER.fullmatch(delay):
            yield "respawn_delay", str(float(delay))
    if _is_true(attrs.get("required")):
        yield "on_exit", "shutdown"
    if attrs.get("launch-prefix") and "$(" not in attrs["launch-prefix"]:
        yield "prefix", attrs["launch-prefix"]


def _is_true(text: str | None) -> bool:
    return (text or "").strip().lower() in ("true", "1")


def lost_attributes(element: Element) -> Iterator[str]:
    """Yield what a person must do because of attributes of a node that have no counterpart."""
    attrs, node = element.attrs, f"node '{element.attrs.get('name') or element.attrs.get('type', '')}'"
    if "machine" in attrs:
        yield f"{node} ran on machine '{attrs['machine']}': start its launch file there"
    if attrs.get("cwd") == "node":
        yield f'{node} had cwd="node", the folder of its program: give it cwd=FOLDER if it reads files from there'
    if _is_true(attrs.get("clear_params")):
        yield f"{node} had clear_params: parameters of ROS 2 end with their node, nothing is left to clear"
    delay = attrs.get("respawn_delay", "")
    if delay and not _NUMBER.fullmatch(delay):
        yield f'{node} had respawn_delay="{delay}": give it respawn_delay=SECONDS'
    if "$(" in attrs.get("launch-prefix", ""):
        yield f'{node} had launch-prefix="{attrs["launch-prefix"]}": give it prefix=[...]'
    for name in ("respawn", "required"):
        if "$(" in attrs.get(name, ""):
            yield f'{node} had {name}="{attrs[name]}": make two nodes of it, each with its condition'


def renamed_parameters(element: Element) -> Iterator[str]:
    """Yield what a person must do because a node of ROS 2 has another parameter for one that is set in a node."""
    renamed = _RENAMED.get(element.attrs.get("type", ""), {})
    for one in element.elements():
        name = one.attrs.get("name", "").strip("~/")
        if one.tagName == "param" and name in renamed:
            node = element.attrs.get("name") or element.attrs["type"]
            yield f"node '{node}' ignores parameter '{name}' in ROS 2: give it {renamed[name]}"


def lost_commands(element: Element) -> Iterator[str]:
    """Yield what a person must do because a parameter of a node is the output of a command, which had other effects."""
    for one in element.elements():
        if one.tagName == "param" and "command" in one.attrs:
            yield f"'{one.attrs['command']}' was run for parameter '{one.attrs.get('name', '')}': run it before"
