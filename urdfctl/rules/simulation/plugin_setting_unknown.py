"""UC512."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ALL, in_words
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.simulation.common import Unread, unread_settings


@rule(
    "UC512",
    runtime="ignores",
    because="the setting may not matter",
    severity=Severity.INFO,
    authority="sdformat Element::HasElement: a plugin asks only for the elements that it knows",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotNamespace>/arm</robotNamespace>
                    «<jointName>»elbow</jointName>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <gazebo>
                  <plugin name="pose" filename="libgazebo_ros_p3d.so">
                    <body_name>fore</body_name>
                    «<zzz>»1</zzz>
                    «<bodyName>»fore</bodyName>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                    <robotNamespace>/arm</robotNamespace>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <gazebo>
                  <plugin name="pose" filename="libgazebo_ros_p3d.so">
                    <alwaysOn>true</alwaysOn>
                    <always_on>true</always_on>
                    <visualize>true</visualize>
                    <robot_param>robot_description</robot_param>
                    <robot_param_node>robot_state_publisher</robot_param_node>
                    <bodyName>fore</bodyName>
                    <topicName>pose</topicName>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <gazebo>
                  <plugin name="gz::sim::systems::JointStatePublisher" filename="gz-sim-joint-state-publisher-system">
                    <ignition-pose>0</ignition-pose>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def plugin_setting_unknown(project: Project) -> Iterator[Finding]:
    """Unknown plugin setting.

    The setting does no harm, but has no effect. If its value matters, set it elsewhere.
    """
    for unread in unread_settings(project):
        if unread.meant is None and unread.name not in _HARMLESS:
            readers = _readers(project, unread)
            where = f" in {in_words(project.distros)}, only in {in_words(readers)}" if readers else "; it is ignored"
            message = f"'{unread.sim_plugin.filename}' has no setting <{unread.name.removeprefix('ros/')}>{where}"
            yield Finding(unread.tag.at, message)


_HARMLESS = {"alwaysOn", "always_on", "robot_param", "robot_param_node", "visualize", "ignition-pose"}
"""Settings of many examples that were or are read elsewhere."""


def _readers(project: Project, unread: Unread) -> list[str]:
    by_distro = ((distro, project.catalog.simulator_plugin(unread.sim_plugin.filename, distro)) for distro in ALL)
    return [distro for distro, plugin in by_distro if plugin and unread.name in plugin.children]
