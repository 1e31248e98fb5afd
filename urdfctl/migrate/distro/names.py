"""Names that were replaced by others: plugins, packages, programs, environment variables, elements."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence

from urdfctl.catalog.moves import MovedNames, name_moves
from urdfctl.diagnostic import Edit
from urdfctl.fault import Written
from urdfctl.migrate.edits.tokens import HOOKS, XML, elements_in, tokens_in
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.files import is_launch
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.source.workspaces.packages import package_name

OWN = "urdfctl.toml: migrate.names"
_READ = (*XML, *HOOKS, ".yaml", ".yml", ".py")


def part_of(path: str) -> Part | None:
    """Return the part of a package that a file belongs to; None if it belongs to none."""
    name = os.path.basename(path)
    if name in ("package.xml", "CMakeLists.txt", "setup.py", "setup.cfg"):
        return Part.MANIFEST
    if is_launch(path) or name.endswith(HOOKS):
        return Part.LAUNCH
    if name.endswith((".yaml", ".yml")):
        return Part.YAML
    return Part.URDF if name.endswith(XML) else None


def _names_in(part: Part, packages: MigratedPackages) -> Iterator[Proposal]:
    moves = [move for move in name_moves() if part.value in move.parts and packages.reaches(move.since)]
    if packages.options.successors:
        moves.append(MovedNames(packages.options.target, OWN, (part.value,), packages.options.successors))
    if not moves:
        return
    own = {package_name(path) for path in packages.files("package.xml")}
    for path in packages.files(*_READ):
        if part_of(path) is part and packages.may_change(path):
            source = packages.read(path)
            for move in moves:
                if any(_may_hold(source, old, move) for old in move.names):
                    yield from _renamed(source, move, own)
            if part is Part.MANIFEST:
                yield from _unconditional(source, moves, packages.options.target)


def _may_hold(source: SourceText, old: str, move: MovedNames) -> bool:
    return re.search(old.encode(), source.data) is not None if move.is_pattern else old.encode() in source.data


def _renamed(source: SourceText, move: MovedNames, own: set[str | None]) -> Iterator[Proposal]:
    for span in elements_in(source) if move.element == "*" else tokens_in(source, move.element):
        text = span.text
        new = _new_name(text, move)
        if new != text and text not in own:
            yield _proposal(span, text, new, move)


_CONDITION = re.compile(rb"""\s+condition=(["'])\s*\$ROS_DISTRO\s*==\s*(\w+)\s*\1""")


def _unconditional(source: SourceText, moves: Sequence[MovedNames], target: str) -> Iterator[Proposal]:
    """The dependencies that are renamed for the target, without the condition that another distro is used (REP 149)."""
    for found in _CONDITION.finditer(source.data):
        tag_end = source.data.find(b">", found.end()) + 1
        text = source.data[tag_end : max(source.data.find(b"<", tag_end), tag_end)].decode("utf-8", "replace").strip()
        is_renamed = any(_new_name(text, move) != text for move in moves)
        if tag_end and found[2].decode() != target and is_renamed:
            at = Place(source, found.start(), end=found.end())
            what = f"the condition on '{text}' is dropped: its successor is for {target} too"
            entry = ReportEntry(EntryKind.DONE, what, at, authority="REP 149: condition")
            yield Proposal((Edit(SourceSpan(source, found.start(), found.end()), ""),), entries=(entry,))


_COMMAND = re.compile(r"\bros2\s+(?:launch|run)\s")
_WORD = re.compile(r"(?<![\w./-])[\w-]+(?![\w./-])")


def _new_name(text: str, move: MovedNames) -> str:
    if not move.is_pattern:
        is_command = _COMMAND.search(text) is not None
        return (
            _WORD.sub(lambda word: move.names.get(word[0], word[0]), text) if is_command else move.names.get(text, text)
        )
    for old, new in move.names.items():
        text = re.sub(old, new, text)
    return text


def _proposal(span: SourceSpan, old: str, new: str, move: MovedNames) -> Proposal:
    at = Place(span.source, span.start, end=span.end)
    what = f"'{_short(old)}' was renamed to '{_short(new)}'"
    return Proposal((Edit(span, new),), entries=(ReportEntry(EntryKind.DONE, what, at, authority=move.authority),))


_MOST = 80


def _short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= _MOST else f"{text[:_MOST]}…"


def _rows(part: Part) -> tuple[Row, ...]:
    return tuple(
        Row(_readable(old) if move.is_pattern else old, new.replace("\\1", "X"), move.since, move.authority)
        for move in name_moves()
        if move.parts[0] == part.value
        for old, new in move.names.items()
    )


def _readable(pattern: str) -> str:
    """A pattern as a name, with X for what stays and N for a number."""
    text = pattern.replace("([a-z0-9-]+)", "X").replace(r"\d+", "N")
    return re.sub(r"\\b|\(\?:|\)\??|\\", "", text).replace(".so?", ".so").replace("lib?", "lib")


def _step(part: Part, what: str, before: Written, after: Written) -> Step:
    def propose(packages: MigratedPackages) -> Iterator[Proposal]:
        return _names_in(part, packages)

    return Step(
        f"names-in-{part.value}", part, f"Names in {what}", propose, _rows(part), before=[before], after=[after]
    )


_DESCRIPTION = """
    <ros2_control name="arm" type="system">
      <hardware>
        <plugin>%s</plugin>
      </hardware>
      <joint name="elbow">
        <command_interface name="position"/>
        <state_interface name="position"/>
      </joint>
    </ros2_control>
"""
_PARAMETERS = """
    driver:
      ros__parameters:
        plugin: %s
"""
_LAUNCH = """
    <launch>
      <node pkg="%s" exec="create" args="-topic robot_description"/>
    </launch>
"""
_MANIFEST = """
    <package format="3">
      <name>arm</name>
      <exec_depend>%s</exec_depend>
    </package>
"""
NAMES = (
    _step(
        Part.URDF,
        "descriptions and worlds",
        before={"robot.urdf": _DESCRIPTION % "ign_ros2_control/IgnitionSystem"},
        after={"robot.urdf": _DESCRIPTION % "gz_ros2_control/GazeboSimSystem"},
    ),
    _step(
        Part.YAML,
        "parameter files",
        before={"config/driver.yaml": _PARAMETERS % "fake_components/GenericSystem"},
        after={"config/driver.yaml": _PARAMETERS % "mock_components/GenericSystem"},
    ),
    _step(
        Part.LAUNCH,
        "launch files",
        before={"launch/arm.launch.xml": _LAUNCH % "ros_ign_gazebo"},
        after={"launch/arm.launch.xml": _LAUNCH % "ros_gz_sim"},
    ),
    _step(
        Part.MANIFEST,
        "package.xml",
        before={"package.xml": _MANIFEST % "ros_ign_gazebo"},
        after={"package.xml": _MANIFEST % "ros_gz_sim"},
    ),
)
