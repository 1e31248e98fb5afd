"""UC330."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import loaded_plugins, named_joints
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in, whole_robot_in
from urdfctl.rules.ros2_control.common import replacement


@rule(
    "UC330",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp reads only the children of <ros2_control>;"
    " transmissions of ROS 1 are in the root, where ROS 2 ignores them",
    bad=[
        {
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
    ],
    good=[
        {
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
    ],
)
def transmission_not_read_by_ros2(project: Project) -> Iterator[Finding]:
    """Transmission of ROS 1 in a ROS 2 robot.

    ROS 2 ignores transmissions in the root. Joints that are in no `<ros2_control>` cannot be controlled. For the other
    joints, and for those that a simulator's plugin moves, the transmissions are leftovers, which is only worth knowing.
    So are those of joints that the robot does not have, if all that move are controlled.
    """
    robot = robot_in(project)
    if robot is None or project.ros != 2:  # noqa: PLR2004 (the generation)
        return
    controlled = {part.name for control in robot.ros2_controls for part in control.of_kind("joint")}
    moved = {name for plugin in loaded_plugins(project) for name, _ in named_joints(plugin)}
    moved |= {joint.name for joint in robot.joints if joint.mimic and joint.name}
    moving = {joint.name for joint in robot.joints if joint.name and joint.moves}
    of_ros1 = [transmission for transmission in robot.transmissions if not transmission.is_pr2]
    for transmission in of_ros1[:1]:
        more = f" and {len(of_ros1) - 1} more are" if len(of_ros1) > 1 else " is"
        joints = [joint for other in of_ros1 for joint in other.joints]
        named = [joint for joint in joints if joint.name and is_known(joint.name)]
        missing = [joint for joint in named if joint.name not in controlled | moved]
        if whole_robot_in(project) is not None and project.complete and moving <= controlled | moved:
            missing = []
        message = f"{transmission.label}{more} ignored by ROS 2, which reads <ros2_control> instead"
        if missing:
            message += f"; {label('joint', missing[0].name)} is in none"
        first = [(joint.name, [text.value for text in joint.interfaces]) for joint in missing[:1]]
        severity = None if missing else Severity.INFO
        yield Finding(transmission.at, message, tuple(replacement(first, controlled)), severity=severity)
