"""UC327."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_all_there, is_known, label, replaced
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC327",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Error while parsing 'arm'. Transmission "
    "'gear' declared joint 'elbw' is not available in component 'arm'.\"",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="«elbw»" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
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
def transmission_joint_not_in_component(project: Project) -> Iterator[Finding]:
    """Transmission names a joint that is not in its component.

    The controller manager rejects the whole description. The joint must be in the same `<ros2_control>`.
    """
    for control in components(project):
        known = KnownNames((joint.name or "").strip() for joint in control.of_kind("joint"))
        if not is_all_there(project, control.tag) or not is_known(*(joint.name for joint in control.of_kind("joint"))):
            continue
        for transmission in control.transmissions:
            for end in transmission.joints if not transmission.is_ros1 else ():
                if end.name is None or not is_known(end.name) or end.name.strip() in known:
                    continue
                meant = known.meant_by(end.name)
                hint = f"; did you mean '{meant}'?" if meant else "; add a <joint> of that name to the component"
                fix = replaced(end.at["name"], end.name, meant) if meant else None
                owner = label("transmission", transmission.name)
                message = f"{owner} names {label('joint', end.name)}, which is not in {component(control)}{hint}"
                yield Finding(end.at["name"], message, fix=fix)
