"""Launch files in XML and YAML that start Gazebo Classic: they start gz."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.generate.files.bringup import gz_names
from urdfctl.generate.text.scalars import xml_text
from urdfctl.migrate.classic.empty_worlds import EMPTY
from urdfctl.migrate.classic.starting import (
    CLIENT,
    FILES,
    SPAWN,
    create_options,
    flags,
    has_own_empty_world,
    is_empty_world,
    undecided,
)
from urdfctl.migrate.edits.markup import attribute, children, elements, end_of, indent_of, removal, root_of, step_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.bridge_file import bridge_file_of
from urdfctl.migrate.shared.hardware import goes_to_gz, leaves_classic
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.model.launch.ros1 import is_of_ros2
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping as Map
from urdfctl.source.yaml.tree import Node, Scalar, read_yaml
from urdfctl.source.yaml.tree import Sequence as List

_AUTHORITY = "ros_gz_sim README; gazebosim.org, Migrating Gazebo Classic ROS 2 packages"
_XML = (".launch.xml", "_launch.xml", ".launch")
_YAML = (".launch.yaml", "_launch.yaml", ".launch.yml", "_launch.yml")
_CLASSIC = b"gazebo_ros"


def _launch(packages: MigratedPackages) -> Iterator[Proposal]:
    if not leaves_classic(packages) or not goes_to_gz(packages):
        return
    for path in packages.files(*_XML):
        source = packages.read(path)
        root = root_of(source) if _CLASSIC in source.data and packages.may_change(path) else None
        if root is not None and root.tagName == "launch" and is_of_ros2(root):
            yield from _proposed(_of_xml(packages, root), source)
    for path in packages.files(*_YAML):
        source = packages.read(path)
        if _CLASSIC in source.data and packages.may_change(path):
            yield from _proposed(_of_yaml(packages, source), source)


def _proposed(edits: Iterator[Edit], source: SourceText) -> Iterator[Proposal]:
    found = tuple(edits)
    if found:
        at = Place(source, found[0].span.start)
        yield Proposal(
            found, entries=(ReportEntry(EntryKind.DONE, "the launch file starts gz", at, authority=_AUTHORITY),)
        )


def _launched(file: str) -> str | None:
    """The launch file of gazebo_ros that an address names; None for another one."""
    name = file.rpartition("/")[2]
    return name if "gazebo_ros)" in file and name in FILES else None


def _arguments(packages: MigratedPackages, name: str, written: Mapping[str, str]) -> str:
    """The arguments of gz for those of an included launch file."""
    given = {key: None if "$" in value else value for key, value in written.items()}
    options, world = flags(name, given), written.get("world", "")
    if name == CLIENT:
        return options.strip()
    for option in undecided(name, given):
        options += f'$(eval "{option.expression(repr(written[option.argument]))}")'
    is_empty = is_empty_world(world, is_own=has_own_empty_world(packages))
    return f"{options}{'empty.sdf' if is_empty else world}"


def _spawned(args: str) -> str:
    words = args.split()
    return " ".join(word for word, _ in create_options([(word, None) for word in words]))


# -- XML ---------------------------------------------------------------------------------------------------------------


def _of_xml(packages: MigratedPackages, root: Element) -> Iterator[Edit]:
    gz = gz_names(packages.options.target)
    has_bridge = b"parameter_bridge" in root.source.data
    for element in elements(root):
        if element.tagName == "include" and (name := _launched(attribute(element, "file"))) is not None:
            address = f"$(find-pkg-share {gz['package']})/launch/{gz['launch']}"
            yield Edit(_value(element, "file"), address)
            yield from _filled_default(root, element)
            given = {attribute(one, "name"): attribute(one, "value") for one in children(element, "arg")}
            line = f'<arg name="{gz["argument"]}" value="{xml_text(_arguments(packages, name, given))}"/>'
            after = "" if has_bridge else _bridge_in_xml(packages, element, gz["bridge"], gz["messages"])
            has_bridge = True
            yield from _with_argument(element, line, after)
        elif element.tagName == "node" and attribute(element, "exec") == SPAWN:
            yield Edit(_value(element, "pkg"), gz["package"])
            yield Edit(_value(element, "exec"), "create")
            if attribute(element, "args"):
                yield Edit(_value(element, "args"), _spawned(attribute(element, "args")))


def _filled_default(root: Element, include: Element) -> Iterator[Edit]:
    """The edit of an empty default of the argument that says which world is started."""
    given = [attribute(one, "value") for one in children(include, "arg") if attribute(one, "name") == "world"]
    for argument in elements(root):
        is_empty = argument.tagName == "arg" and argument.attrs.get("default") == ""
        if is_empty and f"$(var {attribute(argument, 'name')})" in given:
            yield Edit(_value(argument, "default"), EMPTY)


def _value(element: Element, name: str) -> SourceSpan:
    tag = element.source.start_tag(element.start)
    start, end = tag.attributes[name] if tag is not None else (element.start, element.start)
    return SourceSpan(element.source, start, end)


def _with_argument(element: Element, line: str, after: str) -> Iterator[Edit]:
    """The edits that give an include one argument instead of those of Gazebo Classic, and add lines after it."""
    source, indent = element.source, indent_of(element)
    end, inner = end_of(element), f"\n{indent}{step_of(source)}{line}"
    tag = source.start_tag(element.start)
    if tag is None or element.close is None or tag.self_closed:
        yield Edit(SourceSpan(source, end - 2, end), f">{inner}\n{indent}</include>{after}")
        return
    yield from (removal(one) for one in children(element, "arg"))
    yield Edit(SourceSpan(source, tag.end, tag.end), inner)
    if after:
        yield Edit(SourceSpan(source, end, end), after)


def _bridge_in_xml(packages: MigratedPackages, element: Element, package: str, messages: str) -> str:
    """The node that bridges the clock and the topics of the robot, as lines after an element."""
    indent, step = indent_of(element), step_of(element.source)
    found = bridge_file_of(packages, element.source.path)
    head = f'\n{indent}<node pkg="{package}" exec="parameter_bridge"'
    if found is None:
        return f'{head} args="{_clock(messages)}"/>'
    address = f"$(find-pkg-share {found})/{BRIDGE_FILE}"
    return f'{head}>\n{indent}{step}<param name="config_file" value="{address}"/>\n{indent}</node>'


def _clock(messages: str) -> str:
    return f"/clock@rosgraph_msgs/msg/Clock[{messages}.Clock"


# -- YAML --------------------------------------------------------------------------------------------------------------


def _of_yaml(packages: MigratedPackages, source: SourceText) -> Iterator[Edit]:
    gz = gz_names(packages.options.target)
    has_bridge = b"parameter_bridge" in source.data
    for action, start in _actions(source):
        file, program = _text(action, "file"), _text(action, "exec")
        if file is not None and (name := _launched(file.text)) is not None:
            yield _scalar(file, f"$(find-pkg-share {gz['package']})/launch/{gz['launch']}")
            given = dict(_given(action))
            yield _argument_in_yaml(action, file, gz["argument"], _arguments(packages, name, given))
            if not has_bridge:
                has_bridge = True
                yield _bridge_in_yaml(packages, source, start, gz)
        elif program is not None and program.text == SPAWN:
            yield from (_scalar(one, gz["package"]) for one in [_text(action, "pkg")] if one is not None)
            yield _scalar(program, "create")
            yield from (_scalar(one, _spawned(one.text)) for one in [_text(action, "args")] if one is not None)


def _actions(source: SourceText) -> Iterator[tuple[Map, int]]:
    """The actions of a launch file, each with the offset of the item of the list that it is."""
    pending: list[Node] = list(read_yaml(source).documents)
    while pending:
        node = pending.pop(0)
        if isinstance(node, Map):
            pending += [entry.value for entry in node.entries]
        elif isinstance(node, List):
            for item in node.items:
                pending.append(item)
                if isinstance(item, Map):
                    yield from ((one.value, item.start) for one in item.entries if isinstance(one.value, Map))


def _text(action: Map, name: str) -> Scalar | None:
    value = action.get(name)
    return value if isinstance(value, Scalar) else None


def _scalar(node: Scalar, text: str) -> Edit:
    return Edit(SourceSpan(node.source, node.start, node.end), json.dumps(text))


def _given(action: Map) -> Iterator[tuple[str, str]]:
    arguments = action.get("arg")
    for one in arguments.items if isinstance(arguments, List) else ():
        if isinstance(one, Map) and (name := _text(one, "name")) and (value := _text(one, "value")):
            yield name.text, value.text


def _argument_in_yaml(action: Map, file: Scalar, name: str, value: str) -> Edit:
    """The edit that gives an include one argument instead of those of Gazebo Classic."""
    source = file.source
    text = f"[{{name: {name}, value: {json.dumps(value)}}}]"
    arguments = action.get("arg")
    if arguments is not None:
        written = source.data[arguments.start : arguments.end]
        start = source.data.rindex(b":", 0, arguments.start) + 1
        return Edit(SourceSpan(source, start, arguments.start + len(written.rstrip())), f" {text}")
    first = action.entries[0].key.start
    indent = " " * (first - source.data.rfind(b"\n", 0, first) - 1)
    lead = ", " if source.data[action.start : action.start + 1] == b"{" else f"\n{indent}"
    return Edit(SourceSpan(source, file.end, file.end), f"{lead}arg: {text}")


def _bridge_in_yaml(packages: MigratedPackages, source: SourceText, item: int, gz: Mapping[str, str]) -> Edit:
    """The edit that adds the bridge above an action."""
    start = source.data.rfind(b"\n", 0, item) + 1
    lead = source.data[start:item].decode()
    found = bridge_file_of(packages, source.path)
    if found is None:
        more = f"args: {json.dumps(_clock(gz['messages']))}"
    else:
        address = f"$(find-pkg-share {found})/{BRIDGE_FILE}"
        more = f"param: [{{name: config_file, value: {json.dumps(address)}}}]"
    text = f"{lead}node: {{pkg: {gz['bridge']}, exec: parameter_bridge, {more}}}\n"
    return Edit(SourceSpan(source, start, start), text)


CLASSIC_LAUNCH_XML = Step(
    name="classic-launch-files-in-xml",
    part=Part.LAUNCH,
    summary="Launch files in XML and YAML that start Gazebo Classic",
    propose=_launch,
    rows=(
        Row("gazebo_ros gazebo.launch.py: world, pause, gui", "gz_sim.launch.py: gz_args", "jazzy", _AUTHORITY),
        Row("spawn_entity.py -entity NAME -timeout T", "ros_gz_sim create -name NAME", "jazzy", _AUTHORITY),
    ),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "launch/arm.launch.xml": """
                <launch>
                  <include file="$(find-pkg-share gazebo_ros)/launch/gazebo.launch.py"/>
                  <node pkg="gazebo_ros" exec="spawn_entity.py" args="-topic robot_description -entity arm -timeout 30"/>
                </launch>
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.xml": """
                <launch>
                  <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py">
                    <arg name="gz_args" value="-r empty.sdf"/>
                  </include>
                  <node pkg="ros_gz_bridge" exec="parameter_bridge" args="/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"/>
                  <node pkg="ros_gz_sim" exec="create" args="-topic robot_description -name arm"/>
                </launch>
            """,
        },
    ],
)
