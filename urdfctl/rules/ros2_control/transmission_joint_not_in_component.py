"""UC327."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import Names, is_all_there, is_known, label, replaced
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC327",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: \"Error while parsing 'arm'. Transmission "
    "'gear' declared joint 'elbw' is not available in component 'arm'.\"",
    bad={
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
    good={
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
)
def transmission_joint_not_in_component(project: Project) -> Iterator[Finding]:
    """A transmission names a joint that is not in its component.

    The controller manager refuses the whole description: the joint has to stand in the same `<ros2_control>`.
    """
    for control in components(project):
        known = Names((joint.name or "").strip() for joint in control.of_kind("joint"))
        if not is_all_there(project, control.tag) or not is_known(*(joint.name for joint in control.of_kind("joint"))):
            continue
        for transmission in control.transmissions:
            for end in transmission.joints if not transmission.is_ros1 else ():
                if end.name is None or not is_known(end.name) or end.name.strip() in known:
                    continue
                right = known.meant_by(end.name)
                reason = f"; did you mean '{right}'?" if right else "; give the component a <joint> of that name"
                fix = replaced(end.at["name"], end.name, right) if right else None
                of = label("transmission", transmission.name)
                message = f"{label('joint', end.name)} of {of} is not in {component(control)}{reason}"
                yield Finding(end.at["name"], message, fix=fix)
