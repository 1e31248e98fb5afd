"""UC626."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.launch import Node
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, launch_of
from urdfctl.rules.launch_samples import PUBLISHER
from urdfctl.source.opaque import UNKNOWN

_TIMED = PUBLISHER.replace("</node>", '  <param name="%s" value="true"/>\n      </node>')
_GZ = """
      <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"><arg name="gz_args" value="-r empty.sdf"/></include>
      <node pkg="ros_gz_sim" exec="create" args="-topic robot_description -name arm"/>"""
_BRIDGE = """
      <node pkg="ros_gz_bridge" exec="parameter_bridge" args="%s"/>"""
_CLOCK = r"/clock\b|clock@|topic_name\W+clock|rosgraph_msgs"


def _files(*nodes: str) -> dict[str, str]:
    packages = ("ros_gz_sim", "ros_gz_bridge", "robot_state_publisher", "xacro")
    manifest = "".join(f"<exec_depend>{name}</exec_depend>" for name in packages)
    return {
        "arm.launch.xml": f"<launch>{''.join(nodes)}</launch>",
        "arm.urdf": "",
        "package.xml": f"<package><name>arm</name>{manifest}</package>",
    }


@rule(
    "UC626",
    severity=Severity.WARNING,
    runtime="misbehaves",
    distros=ROS2,
    authority="rclcpp time_source.cpp: with use_sim_time a node takes its time from /clock, and stays at 0 without it; gz publishes "
    "its clock for gz alone: ros_gz_bridge README, rosgraph_msgs/msg/Clock",
    bad=[
        _files(_TIMED % "«use_sim_time»", _GZ),
        _files(_TIMED % "«use_sim_time»", _GZ, _BRIDGE % "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"),
    ],
    good=[
        _files(_TIMED % "use_sim_time", _GZ, _BRIDGE % "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"),
        _files(
            _TIMED % "use_sim_time",
            _GZ,
            (_BRIDGE % "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock").replace("exec=", 'if="false" exec='),
        ),
        {
            **_files(_TIMED % "use_sim_time", _GZ, _BRIDGE % "--ros-args -p config_file:=bridge.yaml"),
            "bridge.yaml": "- {ros_topic_name: clock, gz_topic_name: clock, ros_type_name: rosgraph_msgs/msg/Clock}\n",
        },
        {**_files(_TIMED % "use_sim_time", _GZ), "README.md": "ros2 run ros_gz_bridge parameter_bridge /clock@...\n"},
    ],
)
def clock_not_bridged(project: Project) -> Iterator[Finding]:
    """Nodes take the time of gz, but nothing bridges its clock.

    With `use_sim_time: true` a node waits for /clock. gz has a clock of its own, which only a bridge (ros_gz_bridge)
    publishes to ROS 2. Without it the node's time stands still at 0: MoveIt, Nav2 and RViz get no transforms in time.
    """
    launch = launch_of(project, ROS_2)
    if launch is None or not launch.complete:
        return
    simulation = next((one for one in launch.simulations if one.sure and one.simulator == "gz"), None)
    timed = [node for node in launch.nodes if node.sure and dict(node.values).get("use_sim_time", "").lower() == "true"]
    if simulation is None or not timed or any(map(_may_bridge, launch.nodes)) or project.may_mention(_CLOCK):
        return
    node = timed[0]
    at = next((word.at for word in node.parameters if word.text == "use_sim_time"), node.at)
    message = f"'{node.executable.text}' has use_sim_time true, but nothing here bridges /clock from gz"
    title = "start 'parameter_bridge' of ros_gz_bridge with /clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"
    yield Finding(at, message, (Note("gz is started here", simulation.at),), Fix(title))


def _may_bridge(node: Node) -> bool:
    """Whether a node may publish /clock: its words say so, or what it bridges is not known."""
    if any("clock" in word.text or word.known is None for word in (*node.words, node.executable)):
        return True
    files = any(name.endswith(("file", "bridge_names")) and UNKNOWN in value for name, value in node.values)
    return files or (not node.complete and "bridge" in f"{node.package.text} {node.executable.text}")
