"""The examples of the faults: complete them to whole robots, and find the place that « and » mark.

An example with only a part of a robot is put into a small valid arm with links base, upper and fore, and revolute joints
shoulder and elbow. The tests and `urdfctl explain` lint the examples.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Mapping
from typing import Any

from urdfctl.fault import Example
from urdfctl.source.disk.files import is_launch, is_yaml
from urdfctl.startup.records import NamedTuple

_LINK = """\
<link name="{name}">
  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
</link>
"""
_JOINT = """\
<joint name="{name}" type="revolute">
  <parent link="{parent}"/><child link="{child}"/><axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="10" velocity="2"/>
</joint>
"""
_ARM = (
    '<link name="world"/>\n'
    + _LINK.format(name="base")
    + '<joint name="mount" type="fixed"><parent link="world"/><child link="base"/></joint>\n'
    + _LINK.format(name="upper")
    + _LINK.format(name="fore")
    + _JOINT.format(name="shoulder", parent="base", child="upper")
    + _JOINT.format(name="elbow", parent="upper", child="fore")
)


_OF_MOVEIT = ("kinematics.yaml", "joint_limits.yaml", "_planning.yaml")
"""Files that only MoveIt reads."""


class Mark(NamedTuple):
    """The place where an example expects its finding: the file, and byte offsets that do not count the marks."""

    file: str
    start: int
    end: int


def completed(name: str, text: str) -> str:
    """Return the whole text of an example's file. A part of a robot is put into the arm."""
    if not name.endswith((".urdf", ".xacro")) or re.search(r"<robot[\s>]", text):
        return text
    namespace = ' xmlns:xacro="http://www.ros.org/wiki/xacro"' if name.endswith(".xacro") else ""
    inside = textwrap.indent(_ARM + text, "  ")
    return f'<?xml version="1.0"?>\n<robot name="arm"{namespace}>\n{inside}</robot>\n'


def options_of(example: Example) -> tuple[dict[str, Any], tuple[tuple[str, str], ...]]:
    """Return the settings by name, and the `name:=value` arguments, that an example is linted with."""
    settings: dict[str, Any] = {}
    for option in example.options:
        name, _, value = option.removeprefix("--").partition("=")
        if name == "start":
            settings["started"] = tuple(value.split(","))
        elif ":=" not in option:
            settings[name] = value
    arguments = [option.split(":=", 1) for option in example.options if ":=" in option]
    return settings, tuple((name, value) for name, value in arguments)


def companions(names: Iterable[str]) -> tuple[tuple[str, ...], str | None]:
    """Return the controller files and the launch file of an example, which are linted together with its first file."""
    _, *rest = names
    launches = [name for name in rest if is_launch(name)]
    controllers = (name for name in rest if is_yaml(name) and not name.endswith(_OF_MOVEIT))
    return tuple(controllers), launches[0] if launches else None


def unmarked(files: Mapping[str, str]) -> tuple[dict[str, str], list[Mark]]:
    """Return the completed files without their marks, and the marked places."""
    plain, marks = {}, []
    for name, text in files.items():
        whole = completed(name, text)
        parts = whole.replace("»", "«").split("«")
        plain[name] = "".join(parts)
        offset = 0
        for index, part in enumerate(parts[:-1]):
            offset += len(part.encode())
            if index % 2 == 0:
                marks.append(Mark(name, offset, offset + len(parts[index + 1].encode())))
    return plain, marks


def marked_lines(files: Mapping[str, str], marks: Iterable[Mark]) -> str:
    """Return places of completed files as text: a file, the number of a line, and the line with « and » around the place."""
    shown = []
    for file, start, end in sorted(marks):
        data = files[file].encode()
        before, inside, after = (
            part.decode("utf-8", "replace") for part in (data[:start], data[start:end], data[end:])
        )
        line = f"{before.rpartition(chr(10))[2]}«{inside}»{after.partition(chr(10))[0]}"
        shown.append(f"{file}:{before.count(chr(10)) + 1}: {line.strip()}")
    return "\n".join(shown) or "nowhere"
