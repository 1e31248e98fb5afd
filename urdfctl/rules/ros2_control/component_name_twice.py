"""UC310."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.ros2_control import Ros2Control
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.ros2_control.common import components


@rule(
    "UC310",
    severity=Severity.ERROR,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/resource_manager.cpp: "Hardware name arm is duplicated. Please '
    "provide a unique 'name' in the URDF.\"",
    in_library=False,
    bad={
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
    good={
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
)
def component_name_twice(project: Project) -> Iterator[Finding]:
    """Two components have the same name.

    The controller manager refuses the description; galactic took it, and could not tell them apart.
    """
    first: dict[str, Ros2Control] = {}
    for control in components(project):
        name = (control.name or "").strip()
        if not name or not is_known(name):
            continue
        before = first.setdefault(name, control)
        if before is not control:
            message = f"there is already a component '{name}'; each <ros2_control> has a name of its own"
            severity = Severity.WARNING if project.distro == "galactic" else Severity.ERROR
            yield Finding(control.at["name"], message, (Note("it is here", before.at["name"]),), severity=severity)
