"""UC502."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.simulation.common import loaded


@rule(
    "UC502",
    severity=Severity.ERROR,
    authority="sdformat src/Element.cc, up to version 1.9 of the format: 'Required attribute[name] in element[plugin] is not "
    "specified in SDF.'",
    bad={
        "robot.urdf": """
            <gazebo>
              «<plugin filename="libgazebo_ros_control.so"/>»
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin filename="libgazebo_ros_control.so" name="gazebo_ros_control"/>
            </gazebo>
        """,
    },
)
def plugin_without_name(project: Project) -> Iterator[Finding]:
    """A plugin of Gazebo Classic has no name.

    It may be any, but there must be one: without it the whole model is refused. gz does without, and takes the only class of the
    library.
    """
    for one in loaded(project):
        if one.simulator == "gazebo-classic" and not (one.plugin.name or "").strip():
            fix = Fix(f'write name="{one.library}"')
            yield Finding(one.plugin.at, f"the plugin of '{one.filename}' has no name, and is refused", fix=fix)
