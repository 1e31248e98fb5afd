"""UC468."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import Parameter, Parameters
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import seen
from urdfctl.rules.claims.ros1 import bare
from urdfctl.rules.common import in_words

_SECTION = "joint_limits"
_PARTS = ("velocity", "acceleration", "jerk", "effort")
_NEEDED = {"EffortJointInterface": ("velocity", "effort"), "VelocityJointInterface": ("velocity",)}
_ROBOT = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
"""
_LIMITS = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    joint_limits:
      elbow: {%s}
"""


@rule(
    "UC468",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS1,
    authority='ros_control joint_limits_interface/joint_limits_rosparam.h; joint_limits_interface.h: "Cannot enforce '
    "limits for joint 'elbow'. It has no velocity limits specification.\"",
    options=["--distro=noetic"],
    bad=[
        {"robot.urdf": _ROBOT, "controllers.yaml": _LIMITS % "«has_velocity_limits»: true"},
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
                joint_limits:
                  elbow: {«has_acceleration_limits»: true, «max_jerk»: 5.0, «has_effort_limits»: true}
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
                joint_limits:
                  elbow: {«max_velocity»: 1.0, «max_acceleration»: 1.0, «has_jerk_limits»: true, «max_effort»: 5.0}
            """,
        },
        {
            "robot.urdf": """
                <robot name="arm">
                  <link name="world"/>
                  <link name="base">
                    <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  </link>
                  <joint name="elbow" type="continuous"><parent link="world"/><child link="base"/></joint>
                  <transmission name="elbow_trans">
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
                    <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                  </transmission>
                  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
                </robot>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                joint_limits:
                  «elbow»: {has_position_limits: false}
            """,
        },
        {
            "robot.urdf": """
                <robot name="arm">
                  <link name="world"/>
                  <link name="base">
                    <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  </link>
                  <joint name="elbow" type="continuous"><parent link="world"/><child link="base"/></joint>
                  <transmission name="elbow_trans">
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
                    <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                  </transmission>
                  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
                </robot>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                joint_limits:
                  «elbow»: {has_velocity_limits: false, max_velocity: 1.0}
            """,
        },
    ],
    good=[
        {"robot.urdf": _ROBOT, "controllers.yaml": _LIMITS % "has_velocity_limits: true, max_velocity: 1.0"},
        {
            "robot.urdf": """
                <robot name="arm">
                  <link name="world"/>
                  <link name="base">
                    <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  </link>
                  <joint name="elbow" type="continuous"><parent link="world"/><child link="base"/></joint>
                  <transmission name="elbow_trans">
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
                    <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                  </transmission>
                  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
                </robot>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                joint_limits:
                  elbow: {has_velocity_limits: true, max_velocity: 1.0, has_effort_limits: true, max_effort: 5.0}
            """,
        },
        {
            "robot.urdf": """
                <robot name="arm">
                  <link name="world"/>
                  <link name="base">
                    <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  </link>
                  <joint name="elbow" type="continuous"><parent link="world"/><child link="base"/></joint>
                  <transmission name="elbow_trans">
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
                    <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                  </transmission>
                  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
                </robot>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                joint_limits:
                  elbow: {has_position_limits: false}
            """,
        },
    ],
)
def joint_limits_incomplete(project: Project) -> Iterator[Finding]:
    """Incomplete limit in joint_limits.

    A limit requires both `has_velocity_limits: true` and its value `max_velocity`; one without the other is ignored
    silently. If a joint has no <limit> in the URDF, and joint_limits lacks a limit that its interface requires, Gazebo
    exits.
    """
    for section in controllers_in(project).others:
        if section.name == _SECTION and "planning" not in section.path:
            for joint in section.parameters.below():
                limits = section.parameters.under(joint.name)
                yield from _halves(joint, limits)
                yield from _unenforced(project, joint, limits)


def _halves(joint: Parameter, limits: Parameters) -> Iterator[Finding]:
    for part in _PARTS:
        has, most = limits.get(f"has_{part}_limits"), limits.get(f"max_{part}")
        if has is not None and has.value.value is True and most is None:
            yield Finding(has.key, f"joint '{joint.name}' has no 'max_{part}'; its {part} is not limited")
        if most is not None and has is None:
            yield Finding(
                most.key, f"'max_{part}' of joint '{joint.name}' is ignored without 'has_{part}_limits: true'"
            )


def _unenforced(project: Project, joint: Parameter, limits: Parameters) -> Iterator[Finding]:
    sessions, robot = seen(project), project.robot
    urdf = robot.joint(joint.name) if robot else None
    if not sessions or urdf is None or urdf.limit is not None or in_gazebo(project) is not Severity.ERROR:
        return
    for offer in sessions[-1].hardware.of(ClaimKind.COMMAND, joint.name):
        lacking = [part for part in _NEEDED.get(bare(offer.interface), ()) if not _is_given(limits, part)]
        if lacking:
            names = in_words([f"max_{part}" for part in lacking])
            message = (
                f"joint '{joint.name}' has no <limit> in the URDF and no {names} here; Gazebo exits with an exception"
            )
            yield Finding(joint.key, message, severity=Severity.ERROR)


def _is_given(limits: Parameters, part: str) -> bool:
    has, most = limits.value(f"has_{part}_limits"), limits.value(f"max_{part}")
    return has is not None and most is not None and has.value is not False
