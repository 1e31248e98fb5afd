"""UC502."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.simulation.common import loaded


@rule(
    "UC502",
    severity=Severity.ERROR,
    authority="gz-sim src/SystemLoader.cc: 'Failed to instantiate system plugin: empty argument'; sdformat: 'Required "
    "attribute[name] in element[plugin] is not specified in SDF.'",
    bad={
        "robot.urdf": """
            <gazebo>
              «<plugin filename="gz-sim-joint-state-publisher-system"/>»
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher"/>
            </gazebo>
        """,
    },
)
def plugin_without_name(project: Project) -> Iterator[Finding]:
    """A plugin of Gazebo has no name.

    In gz the name tells which class of the library is meant. In Gazebo Classic it may be any, but there must be one.
    """
    for one in loaded(project):
        if not one.filename or (one.plugin.name or "").strip():
            continue
        names = one.any.names if one.any else ()
        fix = Fix(f'write name="{names[0]}"' if names else "give it a name")
        yield Finding(one.plugin.at, f"the plugin of '{one.filename}' has no name, and is refused", fix=fix)
