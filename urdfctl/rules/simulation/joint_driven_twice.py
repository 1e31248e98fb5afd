"""UC519."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import components, control_plugins, loaded_plugins, named_joints
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in
from urdfctl.source.span import Place


@rule(
    "UC519",
    runtime="misbehaves",
    severity=Severity.WARNING,
    in_library=False,
    authority="gazebo_plugins gazebo_ros_diff_drive.cpp sets each wheel's velocity and force in every step, and "
    "gazebo_ros_control's DefaultRobotHWSim::writeSim writes to the same joint",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
                <gazebo>
                  <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>shoulder</leftJoint>
                    <rightJoint>«elbow»</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                    <leftJoint>shoulder</leftJoint>
                    <rightJoint>elbow</rightJoint>
                    <wheelSeparation>0.3</wheelSeparation>
                    <wheelDiameter>0.1</wheelDiameter>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def joint_driven_twice(project: Project) -> Iterator[Finding]:
    """Joint is driven twice.

    A drive plugin and ros_control, or two drive plugins, command the same joint. Each writes its command in every step.
    The joint follows the last command or jerks between the two.
    """
    driven = dict(_controlled(project))
    for sim_plugin in loaded_plugins(project):
        for name, place in named_joints(sim_plugin) if sim_plugin.moves_joints else ():
            first = driven.setdefault(name, ("another plugin", place))
            if first[1] is not place and is_known(name):
                message = f"joint '{name}' is driven by '{sim_plugin.filename}' and by {first[0]}; remove one of them"
                yield Finding(place, message, (Note(f"{first[0]} drives it here", first[1]),))


def _controlled(project: Project) -> Iterator[tuple[str, tuple[str, Place]]]:
    """The joints that ros_control or ros2_control commands in the simulator, each with its owner and place."""
    robot = robot_in(project)
    if robot is None or not control_plugins(project):
        return
    for transmission in robot.transmissions if project.ros == 1 else ():
        for joint in transmission.joints:
            yield joint.name or "", (transmission.label, joint.at["name"])
    for control in components(project):
        for part in control.of_kind("joint"):
            if part.commands:
                yield part.name or "", (f"component '{control.name}'", part.at["name"])
