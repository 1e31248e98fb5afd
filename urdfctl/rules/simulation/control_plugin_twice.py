"""UC509."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import Loaded, control_plugins, namespace_of


@rule(
    "UC509",
    severity=Severity.WARNING,
    in_library=False,
    authority="gazebo_ros_control and gz_ros2_control: each plugin makes a controller manager of its own; roscpp: 'Tried to "
    "advertise a service that is already advertised in this node'; ros-controls/gz_ros2_control#145",
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
            </gazebo>
            <gazebo>
              «<plugin name="control_again" filename="libgazebo_ros_control.so"/>»
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
            </gazebo>
        """,
    },
)
def control_plugin_twice(project: Project) -> Iterator[Finding]:
    """A robot loads the plugin that runs its controllers twice.

    Each makes a controller manager, and both have the same name: one of them is never heard, and both command the
    joints. Robots with several arms give each plugin a namespace of its own.
    """
    seen: dict[tuple[str | None, str, str], Loaded] = {}
    for one in control_plugins(project):
        manager = _manager(one)
        if not is_known(*manager):
            continue
        first = seen.setdefault((one.simulator, *manager), one)
        if first is not one:
            message = f"'{one.filename}' is loaded twice, so that two controller managers have the same name"
            yield Finding(one.plugin.at, message, (Note("the first stands here", first.plugin.at),))


def _manager(one: Loaded) -> tuple[str, str]:
    """The namespace and name of the controller manager that a plugin makes."""
    namespace = one.setting("robotNamespace") or one.setting("ros/namespace")
    name = one.setting("controller_manager_name")
    return namespace_of(namespace.text) if namespace else "", name.text if name else ""
