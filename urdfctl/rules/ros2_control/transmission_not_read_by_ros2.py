"""UC330."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.ros2_control.common import replacement


@rule(
    "UC330",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp reads the children of <ros2_control> alone;"
    " transmissions of ROS 1 stood in the root, and nothing of ROS 2 reads them there",
    bad={
        "robot.urdf": """
            «<transmission name="elbow_transmission">»
              <type>transmission_interface/SimpleTransmission</type>
              <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
              <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
            </transmission>
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="position"/>
                <state_interface name="position"/>
              </joint>
            </ros2_control>
        """,
    },
)
def transmission_not_read_by_ros2(project: Project) -> Iterator[Finding]:
    """A robot of ROS 2 has transmissions of ROS 1.

    They stand in the root, where nothing of ROS 2 reads them: joints that are in no `<ros2_control>` cannot be
    controlled, and for the others the transmissions are left over.
    """
    robot = robot_in(project)
    if robot is None or project.ros != 2:  # noqa: PLR2004 (the generation)
        return
    there = {part.name for control in robot.ros2_controls for part in control.of_kind("joint")}
    mimics = {joint.name for joint in robot.joints if joint.mimic}
    read = [transmission for transmission in robot.transmissions if not transmission.is_pr2]
    for transmission in read[:1]:
        more, their = (f" and {len(read) - 1} more are", "their") if len(read) > 1 else (" is", "its")
        missing = [joint for each in read for joint in each.joints if joint.name and joint.name not in there | mimics]
        message = f"{transmission.label}{more} not read by ROS 2, which has <ros2_control> in {their} place"
        if missing:
            message += f": {label('joint', missing[0].name)} is in none"
        joints = [(joint.name, [text.value for text in joint.interfaces]) for joint in missing[:1]]
        yield Finding(transmission.at, message, tuple(replacement(joints, there)))
