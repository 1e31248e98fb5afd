"""UC328."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, label
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC328",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Error while parsing 'elbow'. There should"
    ' be exactly one joint defined in this component but found 2"',
    in_library=False,
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="elbow" type="actuator">
                  <hardware><plugin>arm_drivers/Motor</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
                  «<transmission name="gear">»
                    <plugin>transmission_interface/DifferentialTransmission</plugin>
                    <joint name="shoulder" role="joint1"/>
                    <joint name="elbow" role="joint2"/>
                    <actuator name="left" role="actuator1"/>
                    <actuator name="right" role="actuator2"/>
                  </transmission>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="elbow" type="actuator">
                  <hardware><plugin>arm_drivers/Motor</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def actuator_with_several_joints(project: Project) -> Iterator[Finding]:
    """Transmission of an actuator component without exactly one joint.

    A component of type `actuator` drives one joint. The parser counts the joints of each of its transmissions and
    rejects the description if there is not exactly one. Without a transmission it accepts several joints. For several
    joints, use type `system`.
    """
    for control in components(project):
        if (control.type or "").strip() != "actuator":
            continue
        for transmission in control.transmissions:
            count = len(transmission.joints)
            if count != 1 and not transmission.is_ros1 and is_all_there(project, transmission.tag):
                message = (
                    f"{label('transmission', transmission.name)} of {component(control)} has {count} joints, "
                    "but a component of type 'actuator' drives one. For several joints, use type 'system'"
                )
                yield Finding(transmission.at, message)
