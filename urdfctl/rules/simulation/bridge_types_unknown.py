"""UC533."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.bridge_types import BRIDGED
from urdfctl.model.launch import Word
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced
from urdfctl.rules.launch_samples import MANIFEST, PUBLISHER, launched

_BRIDGE = """
      <node pkg="ros_gz_bridge" exec="parameter_bridge" args="{}"/>"""
_OPTION = r"[^@]+@([\w/]+)[@\[\]]([\w.]+)"
_OF_GZ = frozenset(name for pairs in BRIDGED.values() for name in pairs)


def _bridged(option: str) -> dict[str, str]:
    manifest = MANIFEST.replace("</package>", "<exec_depend>ros_gz_bridge</exec_depend></package>")
    return {**launched(PUBLISHER, _BRIDGE.format(option)), "package.xml": manifest}


@rule(
    "UC533",
    severity=Severity.WARNING,
    runtime="drops",
    because="the robot may move without the topic",
    distros=ROS2,
    authority="ros_gz_bridge get_factory(): 'No template specialization for the specified ROS and Gazebo Transport type', and the "
    "bridge goes on without the topic; README.md lists the pairs of types",
    bad=[
        _bridged("/clock@rosgraph_msgs/msg/Clock[«gz.msgs.Clok»"),
        _bridged("/clock@«rosgraph_msg/msg/Clock»[gz.msgs.Clock"),
        _bridged("/scan@sensor_msgs/LaserScan[«gz.msgs.LasarScan»"),
        _bridged("/scan@sensor_msgs/msg/LaserScan[«gz.msgs.PointCloudPacked»"),
    ],
    good=[
        {**_bridged("/clock@rosgraph_msgs/msg/Clock[ignition.msgs.Clock"), "options": "--distro=humble"},
        _bridged("/odom@nav_msgs/msg/Odometry[gz.msgs.OdometryWithCovariance"),
        _bridged("/own@arm_msgs/msg/State[gz.msgs.State"),
    ],
)
def bridge_types_unknown(project: Project) -> Iterator[Finding]:
    """ros_gz_bridge does not translate between these types.

    It prints an error and goes on without the topic. Without /clock the time of all nodes with `use_sim_time` stands still. A
    type that urdfctl does not know is told only if it is nearly one that the bridge knows.
    """
    for node in project.launch.nodes if project.launch else ():
        if node.sure and node.runs("ros_gz_bridge", "parameter_bridge"):
            for word in node.words:
                yield from _of_option(word)


def _of_option(word: Word) -> Iterator[Finding]:
    """What is wrong with one `TOPIC@ROS_TYPE[GZ_TYPE`."""
    match = re.fullmatch(_OPTION, word.text) if is_known(word.text) else None
    if match is None:
        return
    ros, gz = match.groups()
    pairs = BRIDGED.get(ros if "/msg/" in ros else ros.replace("/", "/msg/"))
    name = gz.replace("ignition.", "gz.", 1)
    if pairs is None:
        wrong, right = ros, nearest(ros, BRIDGED)
    else:
        wrong, right = gz, None if name in pairs else nearest(name, pairs) or (pairs[0] if name in _OF_GZ else None)
    if right is not None:
        at = word.at.part(wrong)
        message = f"ros_gz_bridge does not translate between '{ros}' and '{gz}'; did you mean '{right}'?"
        yield Finding(at, message, fix=replaced(at, wrong, right))
