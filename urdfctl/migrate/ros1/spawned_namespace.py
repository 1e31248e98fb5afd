"""The namespace in which a launch file of ROS 1 spawns a robot: it is that of the robot's plugins without one."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import (
    CONDITIONS,
    ancestors,
    appended,
    attribute,
    elements,
    indent_of,
    step_of,
)
from urdfctl.migrate.edits.places import plugin_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.shared.hardware import host_plugin
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.xml.dom import Element

_AUTHORITY = "gazebo_ros noetic scripts/spawn_model: -robot_namespace is the node's namespace by default"
_SPAWNER, _PUBLISHER = ("gazebo_ros", "spawn_model"), ("robot_state_publisher", "robot_state_publisher")
_ARGUMENT = re.compile(r"\$\(arg ([\w-]+)\)")


def _namespaces(packages: MigratedPackages) -> Iterator[Proposal]:
    host = host_plugin(packages)
    spaces = packages.found(_spawned_in) if host is not None else frozenset()
    if len(spaces) != 1 or "" in spaces or host is None:
        return
    space = next(iter(spaces))
    for element in plugin_elements(packages):
        if attribute(element, "filename") not in host.filenames or _has_namespace(element):
            continue
        if not _is_known(packages, space):
            what = f"name the namespace '{space}' in <ros> of the plugin: the robot is spawned in it"
            if what.encode() not in element.source.data:
                yield for_you(element.at, what, authority=_AUTHORITY)
            continue
        message = f"the plugin is in namespace '{space}', in which the robot is spawned"
        entry = ReportEntry(EntryKind.DECIDED, message, element.at, authority=_AUTHORITY)
        yield Proposal((_added(packages, element, space),), entries=(entry,))


def _has_namespace(plugin: Element) -> bool:
    return any(one.tagName == "ros" or one.tagName in CONDITIONS for one in plugin.elements())


def _added(packages: MigratedPackages, plugin: Element, space: str) -> Edit:
    """The edit that adds the namespace, and where the description is published if it is not there."""
    indent, step = indent_of(plugin) + step_of(plugin.source), step_of(plugin.source)
    lines = [f"{indent}<ros>", f"{indent}{step}<namespace>{space}</namespace>"]
    if space not in packages.found(_published_in):
        lines.append(f"{indent}{step}<remapping>robot_description:=/robot_description</remapping>")
    return appended(plugin, [*lines, f"{indent}</ros>"])


def _is_known(packages: MigratedPackages, space: str) -> bool:
    """Whether a description knows a namespace: it has no argument but one of the same name, which launch files give."""
    names = _ARGUMENT.findall(space)
    texts = [packages.read(path).data for path in packages.files(".xacro", ".launch", ".xml")] if names else []
    return all(
        any(re.search(rb"<xacro:arg\s+name=[\"']" + name.encode() + rb"[\"']", text) for text in texts)
        and any(re.search(rb"\b" + name.encode() + rb":=\$\(arg " + name.encode() + rb"\)", text) for text in texts)
        for name in names
    ) and "$(" not in _ARGUMENT.sub("", space)


def _spawned_in(packages: MigratedPackages) -> frozenset[str]:
    return frozenset(_spaces_of(packages, *_SPAWNER))


def _published_in(packages: MigratedPackages) -> frozenset[str]:
    return frozenset(_spaces_of(packages, *_PUBLISHER))


def _spaces_of(packages: MigratedPackages, package: str, program: str) -> Iterator[str]:
    """The namespaces, as they are written, of the nodes of a program."""
    for root in packages.found(launch_roots).values():
        for node in elements(root) if package.encode() in root.source.data else ():
            is_meant = (attribute(node, "pkg"), attribute(node, "type")) == (package, program)
            if is_meant and node.tagName == "node" and "-sdf" not in attribute(node, "args").split():
                yield _space_of(node)


def _space_of(node: Element) -> str:
    given = re.search(r"-robot_namespace\s+(\$\([^)]*\)\S*|\S+)", attribute(node, "args"))
    if given is not None:
        return given[1].strip("/")
    around = [one for one in (node, *ancestors(node)) if attribute(one, "ns")]
    parts: list[str] = []
    for one in around:
        parts.insert(0, attribute(one, "ns").strip("/"))
        if attribute(one, "ns").startswith("/"):
            break
    return "/".join(filter(None, parts))


SPAWNED_NAMESPACE = Step(
    name="spawned-namespace",
    part=Part.URDF,
    summary="The namespace in which a robot is spawned",
    propose=_namespaces,
    generation=1,
    before=[
        {
            "options": "--from=noetic --to=jazzy --simulator=gz",
            "robot.xacro": """
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
            "launch/sim.launch": """
                <launch>
                  <node name="robot_state_publisher" pkg="robot_state_publisher" type="robot_state_publisher"/>
                  <group ns="left">
                    <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param /robot_description -model a"/>
                  </group>
                </launch>
            """,
        },
    ],
    after=[
        {
            "robot.xacro": """
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                    <ros>
                      <namespace>left</namespace>
                      <remapping>robot_description:=/robot_description</remapping>
                    </ros>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
