"""UC502."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, rule


@rule(
    "UC502",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="sdformat src/Element.cc, up to version 1.9 of the format: 'Required attribute[name] in element[plugin] is not "
    "specified in SDF.'",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  «<plugin filename="libgazebo_ros_control.so"/>»
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin filename="libgazebo_ros_control.so" name="gazebo_ros_control"/>
                </gazebo>
            """,
        },
    ],
)
def plugin_without_name(project: Project) -> Iterator[Finding]:
    """Gazebo Classic plugin without a name.

    Any name is accepted, but without one the whole model is rejected. gz does not need a name and uses the only class
    of the library.
    """
    for sim_plugin in loaded_plugins(project):
        if sim_plugin.simulator == "gazebo-classic" and not (sim_plugin.plugin.name or "").strip():
            fix = Fix(f'add name="{sim_plugin.library}"')
            yield Finding(
                sim_plugin.plugin.at,
                f"plugin '{sim_plugin.filename}' has no 'name'; Gazebo Classic rejects the model",
                fix=fix,
            )
