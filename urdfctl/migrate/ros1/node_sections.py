"""Maps in controller files of ROS 1 that are the parameters of a node, as sections of this node in ROS 2."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping

from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.controller_map import MapItem
from urdfctl.migrate.ros1.doubles import with_doubles
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.ros1.roslaunch_values import namespace_of
from urdfctl.source.yaml.tree import Mapping as Map
from urdfctl.source.yaml.tree import Node, Sequence


def node_types(packages: MigratedPackages) -> dict[str, str]:
    """Return the programs of the nodes in launch files of ROS 1, by the nodes' full names without the slash before."""
    found = {}
    for root in packages.found(launch_roots).values():
        for node in elements(root):
            if node.tagName == "node" and "$(" not in attribute(node, "name"):
                parts = (namespace_of(node), attribute(node, "name"))
                found["/".join(part for part in parts if part)] = attribute(node, "type")
    return found


def node_section(packages: MigratedPackages, item: MapItem, namespace: str) -> str:
    """Return the sections of the nodes that read a map, or the maps in it; empty if a part of it is read by none, or
    cannot be read by ROS 2.

    namespace: that of the map; `/**` for any.
    """
    nodes = packages.found(node_types)
    return "\n".join(_sections(nodes, item.entry.value, f"{namespace.strip('/')}/{item.name}".strip("/")))


def _sections(nodes: Mapping[str, str], value: Node, full: str) -> list[str]:
    last = full.rpartition("/")[2]
    known = [name for name in nodes if name == full or ("*" in full and name.rpartition("/")[2] == last)]
    if not isinstance(value, Map) or not value.entries or has_nested_list(value):
        return []
    if not known:
        inner = [_sections(nodes, entry.value, f"{full}/{entry.key.text}") for entry in value.entries]
        return [text for each in inner for text in each] if all(inner) else []
    body = with_doubles(nodes[known[0]], _body(value))
    head = f'"/**/{last}"' if "*" in full else f"/{full}" if "/" in full else full
    return [f"{head}:\n{body}"]


def _body(value: Map) -> str:
    """The parameters of a node as lines below its name."""
    data = value.source.data
    end = value.start + len(data[value.start : value.end].rstrip())
    if data[value.start : value.start + 1] == b"{":
        return f"  ros__parameters: {data[value.start : end].decode('utf-8', 'surrogateescape')}\n"
    start, stop = data.rfind(b"\n", 0, value.entries[0].key.start) + 1, data.find(b"\n", end)
    lines = textwrap.dedent(data[start : stop if stop >= 0 else None].decode("utf-8", "surrogateescape"))
    return "  ros__parameters:\n" + textwrap.indent(lines.rstrip("\n") + "\n", "    ")


def has_nested_list(root: Node) -> bool:
    """Return whether there is a list of maps or lists, which is no parameter of ROS 2."""
    pending = [root]
    while pending:
        node = pending.pop()
        if isinstance(node, Map):
            pending += [entry.value for entry in node.entries]
        elif isinstance(node, Sequence) and any(isinstance(item, Map | Sequence) for item in node.items):
            return True
    return False
