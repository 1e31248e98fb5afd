"""Trajectory controllers that command velocities in open loop, whose successor puts a PID between."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.migrate.edits.yaml_edits import ByName, MapEdits, deepest, leaves, text_at, texts_at
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, sections
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import todo_line

_TYPE = "joint_trajectory_controller/JointTrajectoryController"
_OLD, _NEW = "open_loop_control", "interpolate_from_desired_state"
_AUTHORITY = (
    "ros2_controllers#1525; joint_trajectory_controller.cpp, use_closed_loop_pid_adapter_: a controller of velocities "
    "alone has a PID unless it is in open loop"
)
_PASSED_ON = "gains of zero and ff_velocity_scale 1.0 pass the velocities on as before"
_UNKNOWN = "a PID commands the velocities now: set the gains of each joint to 0.0 and its ff_velocity_scale to 1.0"


def _open_loops(packages: MigratedPackages) -> Iterator[Proposal]:
    for section in packages.found(sections) if packages.reaches("jazzy") else ():
        if section.type == _TYPE and packages.may_change(section.path):
            given = dict(leaves(section.parameters))
            if text_at(given, _OLD).lower() == "true" and texts_at(given, "command_interfaces") == ["velocity"]:
                yield _closed(packages, section, given)


def _closed(packages: MigratedPackages, section: FileSection, given: ByName) -> Proposal:
    """The proposal to give a controller the gains with which its PID passes the velocities on."""
    edits = MapEdits(packages.read(section.path))
    parent, entry = given[_OLD][-1]
    at = entry.key.at
    joints = texts_at(given, "command_joints") or texts_at(given, "joints")
    entries = [ReportEntry(EntryKind.DONE, f"'{_OLD}' of '{section.node}' became '{_NEW}'", at, authority=_AUTHORITY)]
    if joints:
        entries.append(ReportEntry(EntryKind.DONE, f"{_PASSED_ON}: '{section.node}'", at, authority=_AUTHORITY))
    else:
        edits.insert(parent, todo_line(section.path, _UNKNOWN), after=entry)
        entries.append(ReportEntry(EntryKind.FOR_YOU, _UNKNOWN, at, authority=_AUTHORITY))
    for joint in joints:
        for name, value in {"p": "0.0", "i": "0.0", "d": "0.0", "ff_velocity_scale": "1.0"}.items():
            _set(edits, section, given, f"gains.{joint}.{name}", value)
    if _NEW in given:
        edits.drop(given[_OLD])
    else:
        edits.replace(entry.key, _NEW)
    return Proposal(edits=edits.edits(), entries=tuple(entries), fixes=("UC435", "UC436"))


def _set(edits: MapEdits, section: FileSection, given: ByName, name: str, value: str) -> None:
    """Give a parameter a value; one that is missing has 0.0."""
    if name in given:
        edits.replace(given[name][-1][1].value, value)
    elif value != "0.0":
        parent, key = deepest(section.parameters, name)
        edits.insert(parent, f"{key}: {value}")


_CONTROLLER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        arm:
          type: joint_trajectory_controller/JointTrajectoryController
    arm:
      ros__parameters:
        joints: [shoulder, elbow]
        command_interfaces: [%s]
        state_interfaces: [position, velocity]
        %s
        gains:
          shoulder: %s
"""
_OPEN = "open_loop_control: true"

OPEN_LOOP = Step(
    name="open-loop",
    part=Part.YAML,
    summary="Trajectory controllers that command velocities in open loop",
    propose=_open_loops,
    rows=(Row(f"{_TYPE.partition('/')[0]} of velocities: {_OLD}: true", f"{_NEW}; {_PASSED_ON}", "jazzy", _AUTHORITY),),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": _CONTROLLER % ("velocity", _OPEN, "{p: 10.0, i: 0.5}"),
        },
    ],
    after=[
        {
            "config/controllers.yaml": _CONTROLLER
            % (
                "velocity",
                "interpolate_from_desired_state: true",
                "{p: 0.0, i: 0.0, ff_velocity_scale: 1.0}\n          elbow.ff_velocity_scale: 1.0",
            ),
        },
    ],
)
