"""UC343."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label
from urdfctl.rules.ros2_control.common import called, component, parts


@rule(
    "UC343",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="ros2_control hardware_interface: sensors export only state interfaces; a component of type sensor "
    "has no write()",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <sensor name="wrist_sensor">
                    «<command_interface name="tare"/>»
                    <state_interface name="force.z"/>
                  </sensor>
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
                  <sensor name="wrist_sensor"><state_interface name="force.z"/></sensor>
                  <gpio name="wrist_io"><command_interface name="tare"/></gpio>
                </ros2_control>
            """,
        },
    ],
)
def sensor_commanded(project: Project) -> Iterator[Finding]:
    """Sensor with a command interface.

    Sensors, and all parts of a component of type sensor, export only state interfaces: this one is ignored, and no
    controller can claim it. For commands that belong to no joint, use a `<gpio>` in a system.
    """
    for control, part in parts(project):
        whole = (control.type or "").strip() == "sensor"
        for interface in part.commands if whole or part.kind == "sensor" else ():
            owner, what = label("sensor", part.name), "a sensor"
            if whole:
                owner, what = component(control), "a component of type 'sensor'"
            message = f"{called(interface)} of {owner} is not exported; {what} has only state interfaces"
            yield Finding(interface.at, message)
