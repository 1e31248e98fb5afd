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
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                <robotNamespace>/arm</robotNamespace>
                «<jointName>»elbow</jointName>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
                <robotNamespace>/arm</robotNamespace>
              </plugin>
            </gazebo>
        """,
    },
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
