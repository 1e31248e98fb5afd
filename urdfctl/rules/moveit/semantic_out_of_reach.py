"""UC671."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.launch import Launch, Node
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.source.span import Place

_READERS = ("moveit_ros_move_group", "moveit_servo", "moveit_commander", "moveit_ros_visualization")


def _files(node: str, namespace: str) -> dict[str, str]:
    return {
        "arm.urdf": "",
        "arm.launch": f"""
            <launch>
              <group ns="left">
                <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
                <param name="robot_description_semantic" textfile="$(find arm)/arm.srdf"/>
              </group>
              {node.format(namespace)}
            </launch>
        """,
        "arm.srdf": """
            <robot name="arm">
              <group name="arm"><joint name="shoulder"/><joint name="elbow"/></group>
            </robot>
        """,
        "package.xml": """
            <package format="2"><name>arm</name><exec_depend>moveit_ros_move_group</exec_depend></package>
        """,
    }


_NODE = '<node name="move_group" pkg="moveit_ros_move_group" type="move_group"{}/>'


@rule(
    "UC671",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    options=("--distro=noetic",),
    authority="moveit_ros_planning rdf_loader.cpp: the name is searched in the node's namespace and those above it: 'Robot "
    "semantic description not found. Did you forget to define or remap 'robot_description_semantic'?'",
    bad=[
        _files(f"«{_NODE}»", ""),
        _files(
            """«<node name="servo" pkg="moveit_servo" type="servo_server"/>»
              «<node name="commander" pkg="moveit_commander" type="moveit_commander_cmdline.py"/>»
              «<node name="view" pkg="moveit_ros_visualization" type="moveit_ros_visualization"/>»
              <node name="rviz" pkg="rviz" type="rviz"/>""",
            "",
        ),
        _files(f"«{_NODE}»" + '«<node name="rviz" pkg="rviz" type="rviz"/>»', ""),
    ],
    good=[_files(_NODE, ' ns="left"')],
)
def semantic_out_of_reach(project: Project) -> Iterator[Finding]:
    """robot_description_semantic is in another namespace than the node that reads it.

    A node finds the SRDF in its own namespace or in one above it. Start the node in the namespace of the parameter, or
    remap robot_description and robot_description_semantic.
    """
    launch = project.launch if project.launch and project.launch.ros == 1 else None
    known = [files for files in launch.moveit if files.namespace is not None] if launch else []
    if launch is None or not known or len(known) < len(launch.moveit):
        return
    for node in launch.nodes:
        if node.sure and node.complete and _reads(node, launch) and node.namespace is not None:
            own = f"{node.namespace}/{node.name}/"
            if not any(own.startswith(f"{files.namespace}/") for files in known) and not node.remaps:
                yield _finding(node, known[0].namespace or "/", known[0].at)


def _reads(node: Node, launch: Launch) -> bool:
    """Whether a node reads the SRDF. RViz does, if MoveIt's display is used: assumed beside move_group."""
    if node.package.text != "rviz":
        return node.package.text in _READERS
    return not node.words and any(other.runs("moveit_ros_move_group", "move_group") for other in launch.nodes)


def _finding(node: Node, namespace: str, at: Place) -> Finding:
    name = node.name or node.executable.text
    message = (
        f"node '{name}' does not find robot_description_semantic, which is in namespace '{namespace}'; "
        "start it there, or remap the parameter"
    )
    severity = Severity.WARNING if node.package.text == "rviz" else None
    return Finding(node.at, message, (Note("the SRDF is set here", at),), severity=severity)
