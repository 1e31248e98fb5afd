"""UC324."""

from __future__ import annotations

from collections.abc import Container, Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ControlTransmission
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import label
from urdfctl.rules.ros2_control.common import (
    component,
    components,
    hardware_interfaces,
    joint_element,
    replacement,
    whole_element,
)


@rule(
    "UC324",
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
                  «<transmission name="elbow_transmission">»
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow"><hardwareInterface>EffortJointInterface</hardwareInterface></joint>
                    <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
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
                  <joint name="elbow">
                    <command_interface name="effort"/>
                    <state_interface name="position"/>
                    <state_interface name="velocity"/>
                    <state_interface name="effort"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def transmission_of_ros1_in_component(project: Project) -> Iterator[Finding]:
    """Transmission of a component in the ROS 1 format.

    ROS 2 rejects the description, and the transmission would not create an interface. Interfaces belong in `<joint>`:
    command interfaces for what controllers write, state interfaces for what they read. A ROS 2 transmission has a
    `<plugin>` and roles. It is needed only for a gear between motor and joint.
    """
    for control in components(project):
        controlled = {joint.name for joint in control.of_kind("joint")}
        for transmission in control.transmissions:
            if transmission.is_ros1:
                name = label("transmission", transmission.name)
                message = (
                    f"{name} in {component(control)} uses the ROS 1 format, which ROS 2 rejects; "
                    "declare the joint's interfaces in <joint>"
                )
                joints = [(end.name, hardware_interfaces(end.tag)) for end in transmission.joints]
                notes = tuple(replacement(joints, controlled))
                yield Finding(transmission.at, message, notes, _as_joints(transmission, controlled))


def _as_joints(transmission: ControlTransmission, controlled: Container[str | None]) -> Fix:
    """The fix that replaces a transmission by the joints that the component lacks, with the names as they are written.

    Unsafe: the interfaces are those that it names, but the driver may offer others.
    """
    missing = [end for end in transmission.joints if end.name and end.name not in controlled]
    names = [end.at["name"].span.text for end in missing]
    title = (
        "replace the transmission with a <joint>" if missing or not transmission.joints else "remove the transmission"
    )
    span = whole_element(transmission.at)
    if span is None or not transmission.joints or any(end.at.source is not span.source for end in missing):
        return Fix(title)
    joints = [joint_element(name, hardware_interfaces(end.tag)) for name, end in zip(names, missing, strict=True)]
    return Fix(title, (Edit(span, "".join(joints)),))
