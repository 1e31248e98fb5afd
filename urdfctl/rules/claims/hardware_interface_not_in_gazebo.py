"""UC463."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import home, of_each_candidate
from urdfctl.rules.claims.ros1 import bare, mended_severity
from urdfctl.rules.common import in_words

_SIMULATION = "gazebo_ros_control/DefaultRobotHWSim"
_JOINT_STATES = "hardware_interface/JointStateInterface"
_ROBOT = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
"""


@rule(
    "UC463",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority='ros_control controller_interface/controller.h: "This controller requires a hardware interface of type '
    "'hardware_interface::ImuSensorInterface'. Make sure this is registered in the hardware_interface::RobotHW class.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                imu: {type: «imu_sensor_controller/ImuSensorController», publish_rate: 50}
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
def hardware_interface_not_in_gazebo(project: Project) -> Iterator[Finding]:
    """Hardware interface is not available in Gazebo.

    DefaultRobotHWSim of gazebo_ros_control has only the joint interfaces for position, velocity, effort and state.
    Sensors have Gazebo plugins of their own, which publish their data themselves. The controller is not loaded.
    """
    return of_each_candidate(project, lambda session, controller: _unavailable(project, session, controller))


def _unavailable(project: Project, session: Session, controller: Configured) -> Iterator[Finding]:
    at, kind = home(controller.controller), controller.type
    simulation = project.catalog.hardware(_SIMULATION, session.distro)
    if at is None or kind is None or simulation is None:
        return
    offered = (_JOINT_STATES, *(simulation.command_interfaces or ()))
    lacking = [interface for interface in kind.hardware_interfaces if interface not in offered]
    severity = mended_severity(project, session, controller) if lacking else None
    if severity in (None, Severity.WARNING):
        return  # the hardware may be another one, which has them
    names = in_words([bare(interface) for interface in lacking])
    message = f"controller type '{kind.type}' requires {names}, which Gazebo's simulation does not have"
    yield Finding(at, message, severity=severity)
