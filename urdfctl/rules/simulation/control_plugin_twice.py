"""UC509."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, control_plugins, namespace_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known


@rule(
    "UC509",
    runtime="misbehaves",
    severity=Severity.WARNING,
    in_library=False,
    authority="gazebo_ros_control and gz_ros2_control: each plugin creates its own controller manager; roscpp: 'Tried to "
    "advertise a service that is already advertised in this node'; ros-controls/gz_ros2_control#145",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
                </gazebo>
                <gazebo>
                  «<plugin name="control_again" filename="libgazebo_ros_control.so"/>»
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
                </gazebo>
            """,
        },
    ],
)
def control_plugin_twice(project: Project) -> Iterator[Finding]:
    """Control plugin is loaded twice.

    Each plugin creates a controller manager, and both have the same name. One of them is never reached, and both
    command the joints. Robots with several arms give each plugin its own namespace.
    """
    seen: dict[tuple[str | None, str, str], LoadedPlugin] = {}
    for sim_plugin in control_plugins(project):
        manager = _manager(sim_plugin)
        if not is_known(*manager):
            continue
        first = seen.setdefault((sim_plugin.simulator, *manager), sim_plugin)
        if first is not sim_plugin:
            message = f"'{sim_plugin.filename}' is loaded twice, and both controller managers have the same name"
            yield Finding(sim_plugin.plugin.at, message, (Note("first loaded here", first.plugin.at),))


def _manager(sim_plugin: LoadedPlugin) -> tuple[str, str]:
    """The namespace and name of the controller manager that a plugin creates."""
    namespace = sim_plugin.setting("robotNamespace") or sim_plugin.setting("ros/namespace")
    name = sim_plugin.setting("controller_manager_name")
    return namespace_of(namespace.text) if namespace else "", name.text if name else ""
