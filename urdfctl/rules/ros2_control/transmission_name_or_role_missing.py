"""UC326."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ControlTransmissionEnd
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import label
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC326",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no attribute role in joint tag", "no '
    'attribute name in transmission tag"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    «<joint name="elbow">»<mechanical_reduction>30</mechanical_reduction></joint>
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
def transmission_name_or_role_missing(project: Project) -> Iterator[Finding]:
    """Transmission, joint or actuator without a name or role.

    The controller manager rejects the whole description. Both are attributes. The role is `joint1`, `joint2`,
    `actuator1` or `actuator2`.
    """
    for control in components(project):
        for transmission in control.transmissions:
            if transmission.name is None:
                yield Finding(transmission.at, f"<transmission> of {component(control)} has no 'name'")
            for end in (*transmission.joints, *transmission.actuators):
                of = f"{label(end.kind, end.name)} of {label('transmission', transmission.name)}"
                if end.name is None:
                    yield Finding(end.at, f"<{end.kind}> of {label('transmission', transmission.name)} has no 'name'")
                if end.role is None and not transmission.is_ros1:
                    message = f'{of} has no \'role\'; add role="{end.kind}1", or "{end.kind}2" for the second'
                    yield Finding(end.at, message, _as_element(end))


def _as_element(end: ControlTransmissionEnd) -> tuple[Note, ...]:
    return tuple(Note("<role> of ROS 1 is ignored", tag.at) for tag in end.tag.named("role"))
