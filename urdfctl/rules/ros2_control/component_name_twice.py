"""UC310."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Ros2Control
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.ros2_control.common import components


@rule(
    "UC310",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/resource_manager.cpp: "Hardware name arm is duplicated. Please '
    "provide a unique 'name' in the URDF.\"",
    in_library=False,
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <ros2_control name="«arm»" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <ros2_control name="arm_base" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def component_name_twice(project: Project) -> Iterator[Finding]:
    """Duplicate component name.

    The controller manager rejects the description. Galactic accepts it, but cannot tell the components apart.
    """
    first: dict[str, Ros2Control] = {}
    for control in components(project):
        name = (control.name or "").strip()
        if not name or not is_known(name):
            continue
        before = first.setdefault(name, control)
        if before is not control:
            message = f"component name '{name}' is already used; give each <ros2_control> a unique name"
            severity = Severity.WARNING if project.distro == "galactic" else Severity.ERROR
            yield Finding(control.at["name"], message, (Note("first used here", before.at["name"]),), severity=severity)
