"""Keep Gazebo Classic beside gz: both forms of an element, and an argument of xacro that chooses one."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.systems import library_of
from urdfctl.migrate.edits.markup import ancestors, attribute, indent_of, indented, root_of, span_of, step_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

CHOICE = "use_gazebo_classic"
"""The xacro argument that chooses Gazebo Classic."""


def is_chosen(element: Element) -> bool:
    """Return whether an element is already in a branch for one of the simulators."""
    return any(CHOICE in attribute(around, "value") for around in ancestors(element))


def keeps_classic(packages: MigratedPackages, element: Element) -> bool:
    """Return whether an element stays for the case that Gazebo Classic is chosen: its file can declare the argument."""
    return packages.options.keep_classic and element.source.is_xacro


def replaced(packages: MigratedPackages, element: Element, new: str) -> Iterator[Edit]:
    """Yield the edits that replace an element; with `--keep-classic`, that keep it for the case that it is chosen.

    new: the new text, indented by nothing.
    """
    indent, step = indent_of(element), step_of(element.source)
    span = span_of(element)
    if not keeps_classic(packages, element):
        yield Edit(span, indented(new, indent).strip())
        return
    old = "".join(f"{line.removeprefix(indent)}\n" for line in span.text.splitlines())
    value = f'value="$(arg {CHOICE})"'
    both = f"<xacro:if {value}>\n{indented(old, step)}</xacro:if>\n"
    if new.strip():
        both += f"<xacro:unless {value}>\n{indented(new.rstrip() + chr(10), step)}</xacro:unless>\n"
    yield Edit(span, indented(both, indent).strip())
    yield from _declaration(element)


def _declaration(element: Element) -> Iterator[Edit]:
    """The edit that declares the argument at the beginning of the file."""
    root = root_of(element.source)
    tag = element.source.start_tag(root.start) if root is not None else None
    if root is None or tag is None or f'name="{CHOICE}"'.encode() in element.source.data:
        return
    text = f'\n{step_of(element.source)}<xacro:arg name="{CHOICE}" default="false"/>'
    yield Edit(SourceSpan(element.source, tag.end, tag.end), text)


def is_started(packages: MigratedPackages, plugin: Element, library: str) -> bool:
    """Return whether a launch file starts a robot in Gazebo Classic with a plugin of a file: it will start gz with it."""
    targets = (one.project for one in packages.loaded() if one.project.launch and packages.is_of_classic(one))
    robots = [] if packages.options.keep_classic else [one.robot for one in targets if one.robot is not None]
    path = plugin.source.path
    own = (one for robot in robots for one in robot.plugins if one.at.source.path == path)
    return any(library_of(one.filename or "") == library for one in own)
