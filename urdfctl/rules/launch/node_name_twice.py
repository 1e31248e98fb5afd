"""UC633."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.catalog.distros import ROS1
from urdfctl.model.launch import Node, joined
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import launch_of


def _files(name: str) -> dict[str, str]:
    return {
        "arm.launch": f"""
            <launch>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="view" pkg="rviz" type="rviz"/>
              {name.replace("NAME", "view" if "«" in name else "publisher")}
            </launch>
        """,
        "robot.urdf": "",
        "package.xml": """
            <package format="2">
              <name>arm</name>
              <exec_depend>robot_state_publisher</exec_depend>
              <exec_depend>joint_state_publisher</exec_depend>
              <exec_depend>rviz</exec_depend>
            </package>
        """,
    }


_NODE = '<node name="NAME" pkg="joint_state_publisher" type="joint_state_publisher"/>'


@rule(
    "UC633",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="roslaunch config.py add_node(): 'roslaunch file contains multiple nodes named [/spawner]. Please check all "
    "<node> 'name' attributes to make sure they are unique.'",
    bad=[_files(f"«{_NODE}»")],
    good=[_files(_NODE)],
)
def node_name_twice(project: Project) -> Iterator[Finding]:
    """Two nodes of a launch file have the same name.

    roslaunch refuses the whole file and starts nothing. Give each node its own name, or start the controllers with one
    spawner.
    """
    launch = launch_of(project, 1)
    for nodes in launch.beside or (launch.nodes,) if launch else ():
        yield from _twice(nodes)


def _twice(nodes: Sequence[Node]) -> Iterator[Finding]:
    """Yield a finding for each node of a launch file that has the name of an earlier one."""
    first: dict[str, Node] = {}
    for node in nodes:
        if not node.sure or not node.name or node.namespace is None:
            continue
        name = joined(node.namespace, node.name)
        earlier = first.setdefault(name, node)
        if earlier is not node:
            message = f"two nodes have the name '{name}', so roslaunch starts nothing; give each its own name"
            yield Finding(node.at, message, (Note("the other one is here", earlier.at),))
