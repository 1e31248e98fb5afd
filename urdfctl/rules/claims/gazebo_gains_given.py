"""UC469."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware import Kind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import seen
from urdfctl.rules.claims.ros1 import bare
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.transmissions.common import in_gazebo
from urdfctl.suggest import nearest

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
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'No p gain specified for pid.  "
    "Namespace: /gazebo_ros_control/pid_gains/elbow'",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad={
        "robot.urdf": _ROBOT,
        "controllers.yaml": """
            states: {type: joint_state_controller/JointStateController, publish_rate: 50}
            arm: {type: position_controllers/JointPositionController, joint: elbow}
            gazebo_ros_control:
              pid_gains:
                «elbow»: {p: 100.0, i: 0.0, d: 1.0}
        """,
    },
    good={
        "robot.urdf": _ROBOT,
        "controllers.yaml": """
            states: {type: joint_state_controller/JointStateController, publish_rate: 50}
            arm: {type: position_controllers/JointPositionController, joint: elbow}
        """,
    },
)
def gazebo_gains_given(project: Project) -> Iterator[Finding]:
    """Gains under gazebo_ros_control change how Gazebo moves a joint.

    Without them Gazebo puts a joint of the PositionJointInterface where it is told to, and prints in noetic "No p gain
    specified for pid. Namespace: /gazebo_ros_control/pid_gains/...". Those words are harmless. With gains it pushes the
    joint by forces instead, which have to be tuned: a joint that swings or sags often has gains that were given to
    silence the words.
    """
    sessions = seen(project)
    if not sessions or in_gazebo(project) is not Severity.ERROR:
        return
    hardware = sessions[-1].hardware
    for section in controllers_in(project).others:
        for joint in section.parameters.below(_GAINS) if section.name == _SECTION and hardware.known else ():
            offers = hardware.of(Kind.COMMAND, joint.last)
            if not offers:
                right = nearest(joint.last, hardware.command)
                end = f"; did you mean '{right}'?" if right else ""
                message = f"no transmission drives '{joint.last}', so that nobody reads its gains{end}"
                yield Finding(joint.key, message, severity=Severity.WARNING)
            elif any(bare(offer.interface) in _BY_PID for offer in offers):
                message = (
                    f"with these gains Gazebo pushes '{joint.last}' by forces; without them it sets the joint directly"
                )
                yield Finding(joint.key, f"{message}, and prints a harmless 'No p gain specified for pid'")
            else:
                message = f"these gains of '{joint.last}' are not read: its EffortJointInterface needs none"
                yield Finding(joint.key, message)
