"""UC325."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, label
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC325",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "Missing <plugin> tag of <transmission> '
    'element in your URDF."; foxy, galactic and iron crash there',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  «<transmission name="elbow_gear">»
                    <joint name="elbow" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
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
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
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
def transmission_without_plugin(project: Project) -> Iterator[Finding]:
    """Transmission of a component without a plugin.

    If `<plugin>` is missing, the controller manager rejects the whole description. If it is empty, no hardware can load
    the transmission.
    """
    for control in components(project):
        for transmission in control.transmissions:
            of = f"{label('transmission', transmission.name)} in {component(control)}"
            element = "<plugin>transmission_interface/SimpleTransmission</plugin>"
            if transmission.plugins and not transmission.plugins[0].past_comments:
                message = f"<plugin> of {of} is empty; write {element}"
                yield Finding(transmission.plugins[0].at, message, severity=Severity.WARNING)
            elif not transmission.plugins and not transmission.is_ros1 and is_all_there(project, transmission.tag):
                yield Finding(transmission.at, f"{of} has no <plugin>; add {element}")
