"""Files with the parameters of one node, which ROS 2 reads below `ros__parameters`."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.doubles import with_doubles
from urdfctl.migrate.ros1.launch_files import own_packages
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.ros1.left_over import named_files
from urdfctl.migrate.ros1.node_sections import has_nested_list
from urdfctl.migrate.ros1.roslaunch_nodes import has_successor
from urdfctl.migrate.ros1.roslaunch_values import given_by_name, root_around
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping, Node, YamlFile, read_yaml

_FORM = "rcl_yaml_param_parser: parameters are below ros__parameters of their node"
_ANALYZERS = (
    "write the analyzers directly below ros__parameters, and base_path as path: the aggregator reads them there"
)
_AGGREGATOR = "diagnostic_aggregator README (ros2 branch): analyzers: ros__parameters: NAME: type"
_HEAD = "/**:\n  ros__parameters:\n"


def _node_files(packages: MigratedPackages) -> Iterator[Proposal]:
    programs: dict[str, str] = {}
    for path, spaces in _loaded(packages, programs).items():
        file = read_yaml(packages.read(path))
        root = file.documents[0] if file.documents else None
        if None in spaces or not isinstance(root, Mapping) or not root.entries or not packages.may_change(path):
            continue
        if b"ros__parameters" in file.source.data:
            continue
        obstacle = _obstacle(file, root) if spaces == {""} else "a launch file of ROS 1 loads them below another name"
        if obstacle:
            yield for_you(root.at, f"write these parameters below ros__parameters of their node: {obstacle}")
            continue
        entry = ReportEntry(
            EntryKind.DONE, "the parameters of a node are in the form of ROS 2", root.at, authority=_FORM
        )
        entries = [entry]
        if programs.get(path) == "aggregator_node" and isinstance(root.get("analyzers"), Mapping):
            entries.append(ReportEntry(EntryKind.FOR_YOU, _ANALYZERS, root.at, authority=_AGGREGATOR))
        yield Proposal((_wrapped(root, programs.get(path, "")),), entries=tuple(entries))


def _loaded(packages: MigratedPackages, programs: dict[str, str]) -> dict[str, set[str | None]]:
    """The files that launch files of ROS 1 load: below which names of nodes that ROS 2 has, too; None for others.

    programs: gets the programs of those nodes.
    """
    found: dict[str, set[str | None]] = {}
    own = frozenset(own_packages(packages))
    for root in packages.found(launch_roots).values():
        for element in elements(root):
            written = attribute(element, "file") if element.tagName == "rosparam" else ""
            reader, name = _reader(element) if written else (None, "")
            is_known = reader is not None and has_successor(reader, own)
            for file in named_files(packages, element) if written else ():
                found.setdefault(file, set()).add(name if is_known else None)
                if reader is not None:
                    programs[file] = attribute(reader, "type")
    return found


def _reader(element: Element) -> tuple[Element | None, str]:
    """The node whose parameters a <rosparam> loads, the one around it or of its namespace, and their name in it."""
    around = element.parentNode
    if isinstance(around, Element) and around.tagName == "node":
        return around, attribute(element, "ns").strip("~/")
    given = given_by_name(root_around(element))
    return next(((node, name) for node, one, name in given if one is element), (None, ""))


def _obstacle(file: YamlFile, root: Node) -> str:
    """What ROS 2 cannot read in a file of parameters; empty if nothing."""
    if file.aliases or len(file.documents) > 1:
        return "it reads no aliases, and one document"
    return "no parameter is a list of maps or lists" if has_nested_list(root) else ""


def _wrapped(root: Mapping, program: str) -> Edit:
    source = root.source
    start = source.data.rfind(b"\n", 0, root.start) + 1
    text = with_doubles(program, source.data[start:].decode("utf-8", "surrogateescape"))
    lines = (f"    {line}" if line.strip() else line for line in text.splitlines(keepends=True))
    return Edit(SourceSpan(source, start, len(source.data)), _HEAD + "".join(lines))


NODE_FILES = Step(
    name="node-parameters",
    part=Part.YAML,
    summary="Files with the parameters of a node",
    propose=_node_files,
    generation=1,
    is_needed=True,
    rows=(Row("<rosparam file> in a <node>: NAME: VALUE", "/**: ros__parameters: NAME: VALUE", "", _FORM),),
    before=[
        {
            "arm.launch": """
                <launch>
                  <node pkg="twist_mux" type="twist_mux" name="twist_mux">
                    <rosparam file="$(find arm)/config/topics.yaml" command="load"/>
                  </node>
                </launch>
            """,
            "config/topics.yaml": "use_stamped: false",
        },
    ],
    after=[
        {
            "config/topics.yaml": """
                /**:
                  ros__parameters:
                    use_stamped: false
            """,
        },
    ],
)
