"""The controllers in a YAML file for ROS 1, where each is a map with a type, in maps that are namespaces."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.catalog.catalog import catalog_with
from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.ros1.left_over import named_files
from urdfctl.model.launch import ParameterLoad
from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, YamlEntry, read_yaml
from urdfctl.startup.records import NamedTuple

_MANAGER = "controller_manager"
GAINS_OF_GAZEBO = "gazebo_ros_control"
_OF_ROS2 = (b"ros__parameters", b"moveit_simple_controller_manager", b"moveit_ros_control_interface")


class MapItem(NamedTuple):
    """A controller, or another map of parameters.

    namespace: the keys above it, joined with slashes; empty at the root.
    parent: the map that it is in.
    type: its type; empty if it is no controller.
    is_file: whether the file holds its parameters alone, and launch files name it.
    """

    namespace: str
    parent: Mapping
    entry: YamlEntry
    type: str = ""
    is_file: bool = False

    @property
    def name(self) -> str:
        """Its key."""
        return self.entry.key.text


def controller_maps(packages: MigratedPackages) -> Iterator[tuple[SourceText, Node, list[MapItem]]]:
    """Yield the controller files in the form of ROS 1: each with its map and the controllers and maps in it.

    The maps with a type in a file that only other nodes read are plugins of these, unless they are known controllers.
    """
    catalog = catalog_with(packages.settings.additions)
    of_others = packages.found(files_of_other_nodes)
    for path in packages.files(".yaml", ".yml"):
        source = packages.read(path)
        documents = read_yaml(source).documents if b"type" in source.data else ()
        if len(documents) == 1 and not any(mark in source.data for mark in _OF_ROS2):
            items = _whole_file(packages, documents[0]) or list(items_of(documents[0]))
            types = {item.type for item in items if item.type}
            is_other = path in of_others and not any(catalog.controller(each, "noetic") for each in types)
            if types and not is_other:
                yield source, documents[0], items


def files_of_other_nodes(packages: MigratedPackages) -> frozenset[str]:
    """Return the files that launch files of ROS 1 load for single nodes alone, none of which spawns controllers."""
    of_nodes: set[str] = set()
    of_all: set[str] = set()
    for root in packages.found(launch_roots).values():
        for element in elements(root):
            node = element.parentNode
            is_own = isinstance(node, Element) and node.tagName == "node" and attribute(node, "pkg") != _MANAGER
            (of_nodes if is_own else of_all).update(
                named_files(packages, element) if element.tagName == "rosparam" else ()
            )
    return frozenset(of_nodes - of_all)


def loads_of(packages: MigratedPackages, path: str) -> Iterator[ParameterLoad]:
    """Yield where launch files of ROS 1 load a file into the parameters of a namespace."""
    real = os.path.realpath(path)
    for loaded in packages.loaded():
        launch = loaded.project.launch
        for load in launch.loads if launch is not None and launch.ros == 1 else ():
            if load.file.path and os.path.realpath(load.file.path) == real and not load.in_node:
                yield load


def _whole_file(packages: MigratedPackages, root: Node) -> list[MapItem]:
    """The only controller of a file that holds its parameters alone: launch files name it by the namespace."""
    kind = type_in(root)
    spaces = {load.namespace or "" for load in loads_of(packages, root.source.path)} if kind else set()
    if len(spaces) != 1 or not isinstance(root, Mapping):
        return []
    namespace, _, name = spaces.pop().strip("/").rpartition("/")
    key = root.entries[0].key._replace(text=name)
    return [MapItem(namespace, root, YamlEntry(key, root), kind, is_file=True)] if name else []


def items_of(root: Node) -> Iterator[MapItem]:
    """Yield the controllers and the other maps in a file, in order."""
    if isinstance(root, Mapping):
        yield from _below(root, "")


def _below(parent: Mapping, namespace: str) -> Iterator[MapItem]:
    for entry in parent.entries:
        value = entry.value
        kind = type_in(value)
        if kind:
            yield MapItem(namespace, parent, entry, kind)
        elif isinstance(value, Mapping) and any(item.type for item in _below(value, "")):
            yield from _below(value, f"{namespace}/{entry.key.text}".strip("/"))
        else:
            yield MapItem(namespace, parent, entry)


def type_in(value: Node) -> str:
    """Return the type of a controller by its parameters; empty if it is no controller."""
    kind = value.get("type") if isinstance(value, Mapping) else None
    return kind.text if isinstance(kind, Scalar) and "/" in kind.text and "::" not in kind.text else ""
