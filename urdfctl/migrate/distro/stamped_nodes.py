"""Nodes in launch files that command a mobile base, from jazzy on with a stamp: their parameter."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.distro.stamped import PARAMETERS, SINCE, drives
from urdfctl.migrate.edits.markup import indent_of, step_of
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of
from urdfctl.migrate.edits.xml_edits import elements_of, inserted
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import sections
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.xml.dom import Element

_PROGRAMS: Mapping[tuple[str, str], str] = {
    ("twist_mux", "twist_mux"): "twist_mux",
    ("teleop_twist_joy", "teleop_node"): "teleop_twist_joy_node",
    ("teleop_twist_keyboard", "teleop_twist_keyboard"): "teleop_twist_keyboard",
}
"""By package and program: the node's name."""
_XML = (".launch.xml", "_launch.xml", ".launch")


def _nodes(packages: MigratedPackages) -> Iterator[Proposal]:
    if not drives(packages):
        return
    set_in_files = {entry.key.text for section in packages.found(sections) for entry in section.parameters.entries}
    for path in packages.files(".py", *_XML):
        source = packages.read(path)
        if not any(package.encode() in source.data for package, _ in _PROGRAMS) or not packages.may_change(path):
            continue
        if path.endswith(".py"):
            yield from _of_python(PythonFile(source), set_in_files)
        else:
            for element in elements_of(source):
                yield from _of_xml(element, set_in_files)


def _of_python(file: PythonFile, set_in_files: set[str]) -> Iterator[Proposal]:
    for call, scope in file.calls("Node"):
        package, program = (text_of(getattr(keyword(call, name), "value", None)) for name in ("package", "executable"))
        node = _PROGRAMS.get((package, program))
        parameter = PARAMETERS[node][0] if node else ""
        given = keyword(call, "parameters")
        if node is None or parameter in file.text(call):
            continue
        value = file.value_of(given.value, scope) if given else None
        items = value.elts if isinstance(value, ast.List) else []
        if parameter in set_in_files and any(not isinstance(item, ast.Dict) for item in items):
            continue
        text = f'{{"{parameter}": True}}'
        if isinstance(value, ast.List):
            yield _proposal(file.appended(value, [text]), node, file.at(call))
        elif given is None and call.keywords:
            end = file.span(call.keywords[-1]).end
            edit = Edit(SourceSpan(file.source, end, end), f", parameters=[{text}]")
            yield _proposal(edit, node, file.at(call))


def _of_xml(element: Element, set_in_files: set[str]) -> Iterator[Proposal]:
    node = _PROGRAMS.get((element.attrs.get("pkg", ""), element.attrs.get("exec", "")))
    if element.tagName != "node" or node is None:
        return
    parameter = PARAMETERS[node][0]
    params = [child for child in element.elements() if child.tagName == "param"]
    is_in_file = parameter in set_in_files and any("from" in param.attrs for param in params)
    if is_in_file or any(param.attrs.get("name") == parameter for param in params):
        return
    edit = _with_child(element, f'<param name="{parameter}" value="true"/>')
    if edit is not None:
        yield _proposal(edit, node, element.at)


def _with_child(element: Element, text: str) -> Edit | None:
    """The edit that adds a child to an element, which may have no end tag."""
    tag = element.source.start_tag(element.start)
    if tag is None or not tag.self_closed:
        return inserted(element, text)
    indent, step = indent_of(element), step_of(element.source)
    lines = f">\n{indent}{step}{text}\n{indent}</{element.tagName}>"
    return Edit(SourceSpan(element.source, tag.end - len(b"/>"), tag.end), lines)


def _proposal(edit: Edit, node: str, at: Place) -> Proposal:
    parameter, authority = PARAMETERS[node]
    what = f"'{node}' publishes velocities with a stamp, which the controllers read: {parameter}"
    entry = ReportEntry(EntryKind.DECIDED, what, at, authority=authority, option=f"remove {parameter}")
    return Proposal((edit,), entries=(entry,))


STAMPED_NODES = Step(
    name="stamped-nodes",
    part=Part.LAUNCH,
    summary="Nodes in launch files that command a mobile base",
    propose=_nodes,
    rows=tuple(
        Row(f"{package} {program}", f"{PARAMETERS[node][0]}: true", SINCE, PARAMETERS[node][1])
        for (package, program), node in _PROGRAMS.items()
    ),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base:
                      type: diff_drive_controller/DiffDriveController
                base:
                  ros__parameters:
                    left_wheel_names: [left]
                    right_wheel_names: [right]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
            """,
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="teleop_twist_joy" exec="teleop_node"/>
                </launch>
            """,
        },
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base:
                      type: diff_drive_controller/DiffDriveController
                base:
                  ros__parameters:
                    left_wheel_names: [left]
                    right_wheel_names: [right]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
            """,
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription([Node(package="teleop_twist_joy", executable="teleop_node")])
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.xml": """
                <launch>
                  <node pkg="teleop_twist_joy" exec="teleop_node">
                    <param name="publish_stamped_twist" value="true"/>
                  </node>
                </launch>
            """,
        },
        {
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription([Node(package="teleop_twist_joy", executable="teleop_node", parameters=[{"publish_stamped_twist": True}])])
            """,
        },
    ],
)
