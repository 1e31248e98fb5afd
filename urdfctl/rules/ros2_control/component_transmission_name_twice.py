"""UC350."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ControlTransmission
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC350",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="measured with jazzy's controller manager, which accepts both; hardware identifies transmissions by name",
    in_library=False,
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow" role="joint1"/><actuator name="elbow_motor" role="actuator1"/>
                  </transmission>
                  <transmission name="«gear»">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="shoulder" role="joint1"/><actuator name="shoulder_motor" role="actuator1"/>
                  </transmission>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow" role="joint1"/><actuator name="elbow_motor" role="actuator1"/>
                  </transmission>
                  <transmission name="shoulder_gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="shoulder" role="joint1"/><actuator name="shoulder_motor" role="actuator1"/>
                  </transmission>
                </ros2_control>
            """,
        },
    ],
)
def component_transmission_name_twice(project: Project) -> Iterator[Finding]:
    """Duplicate transmission name in a component.

    The parser accepts both transmissions. Hardware that stores transmissions by name keeps only one of them, and log
    messages do not say which one they mean.
    """
    for control in components(project):
        first: dict[str, ControlTransmission] = {}
        for transmission in control.transmissions:
            name = transmission.name
            if not name or not is_known(name) or transmission.is_ros1:
                continue
            before = first.setdefault(name, transmission)
            if before is not transmission:
                message = f"transmission name '{name}' is already used in {component(control)}"
                yield Finding(transmission.at["name"], message, (Note("first used here", before.at["name"]),))
