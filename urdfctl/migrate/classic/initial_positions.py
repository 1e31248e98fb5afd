"""Positions of joints at the start: arguments of the spawner in Gazebo Classic, `initial_value` in <ros2_control>."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, children, end_of, indent_of, step_of
from urdfctl.migrate.edits.places import written_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = "gz_ros2_control doc/index.rst: initial_value of a state interface"
_OPTION = re.compile(rb"(?<![\w-])-J[\"'\s,]+(?:\w+::)?(\w+)[\"'\s,]+([-+]?\d[\d.eE+-]*)(?![\w.])")
_LAUNCHES = (".launch", ".launch.xml", "_launch.xml", ".launch.py", ".py", ".launch.yaml")
_OF_XML = (".xacro", ".urdf", ".xml")
_INITIAL = "initial_value"


def _positions(packages: MigratedPackages) -> Iterator[Proposal]:
    wanted = _wanted(packages) if goes_to_gz(packages) else {}
    for joint in _joints(packages) if wanted else ():
        value = wanted.get(attribute(joint, "name"), "")
        for state in children(joint, "state_interface") if value else ():
            if attribute(state, "name") == "position" and not _is_set(state):
                what = f"joint '{attribute(joint, 'name')}' starts at {value}, as the spawner said"
                yield Proposal(
                    (_edit(state, value),), entries=(ReportEntry(EntryKind.DONE, what, state.at, authority=_AUTHORITY),)
                )


def _wanted(packages: MigratedPackages) -> dict[str, str]:
    """The position of each joint in the launch files, unless they differ."""
    found: dict[str, set[str]] = {}
    for path in packages.files(*_LAUNCHES):
        for match in _OPTION.finditer(packages.read(path).data):
            found.setdefault(match[1].decode(), set()).add(match[2].decode())
    return {joint: next(iter(values)) for joint, values in found.items() if len(values) == 1}


def _joints(packages: MigratedPackages) -> Iterator[Element]:
    """The joints of <ros2_control>, as they are written."""
    for element in written_elements(packages, "<ros2_control", _OF_XML):
        if element.tagName == "ros2_control" and packages.may_change(element.source.path):
            yield from children(element, "joint")


def _is_set(state: Element) -> bool:
    return any(attribute(one, "name") == _INITIAL for one in children(state, "param"))


def _edit(state: Element, value: str) -> Edit:
    source, indent = state.source, indent_of(state)
    line = f'\n{indent}{step_of(source)}<param name="{_INITIAL}">{value}</param>'
    tag, end = source.start_tag(state.start), end_of(state)
    if tag is None or tag.self_closed:
        start = end - len(b"/>")
        start -= len(source.data[:start]) - len(source.data[:start].rstrip())
        return Edit(SourceSpan(source, start, end), f">{line}\n{indent}</state_interface>")
    return Edit(SourceSpan(source, tag.end, tag.end), line)


def joints_with_position(packages: MigratedPackages) -> set[str]:
    """Return the joints of <ros2_control> that have a position at the start."""
    return {
        attribute(joint, "name")
        for joint in _joints(packages)
        if any(_is_set(state) for state in children(joint, "state_interface"))
    }


INITIAL_POSITIONS = Step(
    name="initial-positions",
    part=Part.URDF,
    summary="Positions of joints at the start",
    propose=_positions,
    rows=(Row("spawn_model -J JOINT VALUE", '<param name="initial_value">', "jazzy", _AUTHORITY),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="gazebo_ros" exec="spawn_entity.py" args="-topic robot_description -entity arm -J elbow 0.5"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position">
                      <param name="initial_value">0.5</param>
                    </state_interface>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
