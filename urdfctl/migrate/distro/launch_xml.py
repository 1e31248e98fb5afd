"""The controller manager and its spawners in launch files in XML."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from itertools import takewhile

from urdfctl.catalog.moves import MANAGER
from urdfctl.diagnostic import Edit
from urdfctl.migrate.distro.launch_python import (
    AUTHORITY_OF_FILE,
    AUTHORITY_OF_OPTIONS,
    AUTHORITY_OF_TOPIC,
    WITH_FILE,
)
from urdfctl.migrate.edits.xml_edits import elements_of, removed
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, installed_path, sections, sections_near
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_ENDINGS = (".launch.xml", "_launch.xml", ".launch")


def _launch_xml(packages: MigratedPackages) -> Iterator[Proposal]:
    known = [section for section in packages.found(sections) if section.type != MANAGER]
    for path in packages.files(*_ENDINGS):
        source = packages.read(path)
        if b"controller_manager" not in source.data or not packages.may_change(path):
            continue
        all_nodes = (element for element in elements_of(source) if element.tagName == "node")
        nodes = [one for one in all_nodes if one.attrs.get("pkg") == "controller_manager" and "exec" in one.attrs]
        for node in nodes:
            if node.attrs["exec"] == "ros2_control_node" and packages.crosses("jazzy", node.source.path):
                yield from _manager(node)
            elif node.attrs["exec"].startswith("spawner"):
                yield from _spawner(packages, node, nodes, known)


def _manager(node: Element) -> Iterator[Proposal]:
    """Remove what gives the manager the robot description: it reads the topic robot_description."""
    for child in node.elements():
        is_parameter = child.tagName == "param" and child.attrs.get("name") == "robot_description"
        is_remapping = child.tagName == "remap" and child.attrs.get("from") == "~/robot_description"
        if is_remapping and child.attrs.get("to", "").lstrip("/") != "robot_description":
            edit = Edit(child.at["from"].span, "robot_description")
            yield Proposal((edit,), entries=(_done("the topic is now robot_description", child),))
        elif is_parameter or is_remapping:
            what = "the controller manager reads the robot description from the topic robot_description"
            yield Proposal((removed(child),), entries=(_done(what, child),))


def _done(what: str, element: Element, authority: str = AUTHORITY_OF_TOPIC) -> ReportEntry:
    return ReportEntry(EntryKind.DONE, what, element.at, authority=authority)


def _spawner(
    packages: MigratedPackages, node: Element, nodes: Sequence[Element], known: Sequence[FileSection]
) -> Iterator[Proposal]:
    span = node.at["args"].span
    words = span.text.split()
    if "--stopped" in words:
        edit = Edit(span, span.text.replace("--stopped", "--inactive"))
        yield Proposal((edit,), entries=(_done("'--stopped' is now '--inactive'", node, AUTHORITY_OF_OPTIONS),))
        return
    if (
        not packages.crosses("jazzy", node.source.path)
        or {"--param-file", "-p"} & set(words)
        or "args" not in node.attrs
    ):
        return
    files = sections_near(known, node.source, _without_spawners(nodes, node.source.data))
    names = list(takewhile(lambda word: not word.startswith("-"), words))
    own = {path for name in names for path in files.get(name, ())}
    file = _file_of_manager(nodes) or (_file(packages, nodes, next(iter(own))) if len(own) == 1 else None)
    if not own:
        return
    if file is None:
        yield for_you(node.at, WITH_FILE, authority=AUTHORITY_OF_FILE)
        return
    edit = Edit(SourceSpan(span.source, span.end, span.end), f" --param-file {file}")
    what = "the spawner gives its controllers their parameters: --param-file"
    yield Proposal((edit,), entries=(_done(what, node, AUTHORITY_OF_FILE),))


def _without_spawners(nodes: Sequence[Element], text: bytes) -> bytes:
    """The text of a file without the arguments of spawners: one of them names the file of its controllers."""
    for node in nodes:
        if node.attrs["exec"].startswith("spawner") and node.attrs.get("args"):
            span = node.at["args"].span
            text = text.replace(node.source.data[span.start : span.end], b"")
    return text


def _file_of_manager(nodes: Sequence[Element]) -> str | None:
    """The only file that the controller managers of a launch file get; None if there is none, or several."""
    managers = (node for node in nodes if node.attrs["exec"] == "ros2_control_node")
    files = {child.attrs.get("from", "") for node in managers for child in node.elements() if child.tagName == "param"}
    files.discard("")
    return files.pop() if len(files) == 1 else None


def _file(packages: MigratedPackages, nodes: Sequence[Element], path: str) -> str:
    """The file as the controller manager of the same launch file names it, or else in its package."""
    name = os.path.basename(path)
    given = (child.attrs.get("from", "") for node in nodes for child in node.elements() if child.tagName == "param")
    package, parts = installed_path(packages, path)
    return next((one for one in given if one.endswith(name)), f"$(find-pkg-share {package})/{'/'.join(parts)}")


LAUNCH_XML = Step(
    "launch-files-in-xml",
    Part.LAUNCH,
    "The controller manager in launch files in XML",
    _launch_xml,
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="controller_manager" exec="ros2_control_node">
                    <remap from="~/robot_description" to="/robot_description"/>
                  </node>
                  <node pkg="controller_manager" exec="spawner" args="arm --stopped"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="controller_manager" exec="ros2_control_node">
                  </node>
                  <node pkg="controller_manager" exec="spawner" args="arm --inactive"/>
                </launch>
            """,
        },
    ],
)
