"""UC349."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, until
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, severity_where
from urdfctl.rules.ros2_control.common import components, is_number


@rule(
    "UC349",
    severity=Severity.WARNING,
    runtime="refuses",
    because="only hardware that loads transmissions does",
    distros=ROS2,
    authority='ros2_control transmission_interface/simple_transmission.hpp: "Transmission reduction ratio cannot be'
    ' zero."; component_parser.cpp get_parameter_value_or() uses the default for anything that is not a number',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow" role="joint1">«<mechanical_reduction>»0</mechanical_reduction></joint>
                    <actuator name="elbow_motor" role="actuator1"/>
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
                  <transmission name="elbow_gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
                    <actuator name="elbow_motor" role="actuator1"/>
                  </transmission>
                </ros2_control>
            """,
        },
    ],
)
def component_transmission_reduction(project: Project) -> Iterator[Finding]:
    """Invalid reduction or offset of a transmission in a component.

    Hardware that loads the transmission fails if the reduction is 0. A value that is not a number is silently replaced
    by the default: 1 for a reduction, 0 for an offset. Up to galactic, the description is rejected instead.
    """
    for control in components(project):
        for transmission in control.transmissions:
            for end in (*transmission.joints, *transmission.actuators):
                of = f"{label(end.kind, end.name)} of {label('transmission', transmission.name)}"
                for what, texts in (("reduction", end.reductions), ("offset", end.offsets)):
                    for text in texts[:1]:
                        value = text.past_comments
                        if not is_known(value):
                            continue
                        if not is_number(value):
                            default = "1" if what == "reduction" else "0"
                            message = f"{what} of {of} is '{value}', which is not a number; {default} is used instead"
                            yield Finding(text.at, message, severity=severity_where(project, until("galactic")))
                        elif what == "reduction" and float(value) == 0:
                            yield Finding(text.at, f"reduction of {of} must not be 0; for no reduction, use 1")
