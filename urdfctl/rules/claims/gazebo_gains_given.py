"""UC469."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import seen
from urdfctl.rules.claims.ros1 import bare

_SECTION, _GAINS = "gazebo_ros_control", "pid_gains"
_BY_PID = ("PositionJointInterface", "VelocityJointInterface")
_ROBOT = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
"""


@rule(
    "UC469",
    severity=Severity.INFO,
    runtime="works",
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'No p gain specified for pid.  "
    "Namespace: /gazebo_ros_control/pid_gains/elbow'",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm: {type: position_controllers/JointPositionController, joint: elbow}
                gazebo_ros_control:
                  pid_gains:
                    «elbow»: {p: 100.0, i: 0.0, d: 1.0}
            """,
        },
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
                  <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                </transmission>
                <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm: {type: velocity_controllers/JointVelocityController, joint: elbow, pid: {p: 1.0, i: 0.0, d: 0.0}}
                gazebo_ros_control:
                  pid_gains:
                    «elbow»: {p: 100.0, i: 0.0, d: 1.0}
            """,
        },
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
                  <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                </transmission>
                <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm: {type: effort_controllers/JointEffortController, joint: elbow}
                gazebo_ros_control:
                  pid_gains:
                    «elbow»: {p: 100.0, i: 0.0, d: 1.0}
            """,
        },
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
                  <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                </transmission>
                <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm: {type: position_controllers/JointPositionController, joint: elbow}
                gazebo_ros_control:
                  pid_gains:
                    «elbw»: {p: 100.0, i: 0.0, d: 1.0}
            """,
        },
    ],
    good=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm: {type: position_controllers/JointPositionController, joint: elbow}
            """,
        },
    ],
)
def gazebo_gains_given(project: Project) -> Iterator[Finding]:
    """Gains in gazebo_ros_control change how Gazebo moves a joint.

    Without gains Gazebo sets a joint of the PositionJointInterface directly, and in noetic prints "No p gain specified
    for pid. Namespace: /gazebo_ros_control/pid_gains/...". This message is harmless. With gains Gazebo applies forces
    to the joint, and the gains must be tuned. A joint that swings or sags often has gains that were added only to
    silence the message.
    """
    sessions = seen(project)
    if not sessions or in_gazebo(project) is not Severity.ERROR:
        return
    hardware = sessions[-1].hardware
    for section in controllers_in(project).others:
        for joint in section.parameters.below(_GAINS) if section.name == _SECTION and hardware.known else ():
            offers = hardware.of(ClaimKind.COMMAND, joint.last)
            if not offers:
                right = nearest(joint.last, hardware.command)
                hint = f"; did you mean '{right}'?" if right else ""
                message = f"gains of '{joint.last}' are ignored: no transmission drives a joint of this name{hint}"
                yield Finding(joint.key, message, severity=Severity.WARNING)
            elif any(bare(offer.interface) in _BY_PID for offer in offers):
                message = (
                    f"with these gains Gazebo moves joint '{joint.last}' by forces. "
                    "Without them it sets the joint directly, and prints a harmless 'No p gain specified for pid'"
                )
                yield Finding(joint.key, message)
            else:
                message = f"gains of joint '{joint.last}' are ignored: its EffortJointInterface uses none"
                yield Finding(joint.key, message)
