"""UC501."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label


@rule(
    "UC501",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="sdformat src/Element.cc: 'Required attribute[filename] in element[plugin] is not specified in SDF.'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  «<plugin name="gazebo_ros_control">»
                    <robotNamespace>/arm</robotNamespace>
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
    ],
)
def plugin_without_filename(project: Project) -> Iterator[Finding]:
    """Gazebo plugin without a file name.

    Gazebo loads a library by its file name. Without one, the plugin is not loaded, or the whole model is rejected.
    """
    for sim_plugin in loaded_plugins(project):
        plugin = sim_plugin.plugin
        if not (plugin.filename or "").strip():
            empty = "filename" in plugin.tag.attributes
            fault = "an empty 'filename'" if empty else "no 'filename'"
            yield Finding(plugin.at, f"{label('plugin', plugin.name)} has {fault}; Gazebo has nothing to load")
