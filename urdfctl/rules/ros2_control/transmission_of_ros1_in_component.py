"""UC324."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import label
from urdfctl.rules.ros2_control.common import component, components, hardware_interfaces, replacement


@rule(
    "UC324",
    severity=Severity.ERROR,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "Missing <plugin> tag of <transmission> '
    'element in your URDF."; foxy, galactic and iron crash there',
    bad={
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
    good={
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
)
def transmission_of_ros1_in_component(project: Project) -> Iterator[Finding]:
    """A transmission in a component is written as ROS 1 has it.

    ROS 2 refuses the description, and no interface would come of the transmission: what a joint takes and gives
    stands in `<joint>`, with a command interface for what controllers write and state interfaces for what they read.
    A transmission of ROS 2 names a `<plugin>`, has roles, and is there only for a gear between motor and joint.
    """
    for control in components(project):
        there = {joint.name for joint in control.of_kind("joint")}
        for transmission in control.transmissions:
            if transmission.is_ros1:
                name = label("transmission", transmission.name)
                message = (
                    f"{name} in {component(control)} is written as ROS 1 has it, which ROS 2 refuses: "
                    "the interfaces of a joint stand in <joint> there"
                )
                joints = [(end.name, hardware_interfaces(end.tag)) for end in transmission.joints]
                notes = tuple(replacement(joints, there))
                yield Finding(transmission.at, message, notes, Fix("write the <joint> instead of the transmission"))
