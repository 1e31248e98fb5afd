"""UC346."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, label
from urdfctl.rules.ros2_control.common import parts


@rule(
    "UC346",
    severity=Severity.INFO,
    runtime="ignores",
    because="many controllers need no state",
    distros=ROS2,
    authority="ros2_controllers: joint_trajectory_controller requires state interfaces of each joint; "
    "joint_state_broadcaster publishes those that exist",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  «<joint name="elbow">»<command_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def command_without_state(project: Project) -> Iterator[Finding]:
    """Joint with a command interface but no state interface.

    The joint is missing from the joint states, so RViz does not move it. Controllers with feedback reject it. Mock
    hardware and Gazebo can both provide its position.
    """
    for control, part in parts(project, "joint"):
        if (
            part.commands
            and not part.states
            and is_all_there(project, part.tag)
            and (control.type or "").strip() == "system"
        ):
            missing = '<state_interface name="position"/>'
            message = f"{label('joint', part.name)} has a command interface but no state interface; add {missing}"
            yield Finding(part.at, message)
