"""UC512."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ALL, in_words
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.simulation.common import Unread, unread_settings


@rule(
    "UC512",
    severity=Severity.INFO,
    authority="sdformat Element::HasElement: a plugin asks for the elements that it knows, and nobody for the others",
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
    """A plugin does not read one of its settings.

    It does no harm, and it does nothing: what it was meant to say must be said elsewhere.
    """
    for unread in unread_settings(project):
        if unread.meant is None and unread.name not in _HARMLESS:
            readers = _readers(project, unread)
            where = f" in {in_words(project.distros)}, but in {in_words(readers)}" if readers else ""
            message = f"'{unread.one.filename}' does not read <{unread.name.removeprefix('ros/')}>{where}"
            yield Finding(unread.tag.at, message)


_HARMLESS = {"alwaysOn", "always_on", "robot_param", "robot_param_node", "visualize", "ignition-pose"}
"""What stands in many examples, and was or is read elsewhere."""


def _readers(project: Project, unread: Unread) -> list[str]:
    found = ((distro, project.catalog.simulator_plugin(unread.one.filename, distro)) for distro in ALL)
    return [distro for distro, plugin in found if plugin and unread.name in plugin.children]
