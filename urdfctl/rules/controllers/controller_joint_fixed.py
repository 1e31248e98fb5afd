"""UC441."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.interfaces import OfferedHardware
from urdfctl.control.parameters.readers import Reader, in_each_distro, robot_of
from urdfctl.control.unknown_joint_claims import is_misnamed
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Note, Project, Severity, Stage, rule
from urdfctl.rules.controllers.joints import hardware_in, named, severity_of

_ROBOT = """
    <transmission name="arm">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
      <actuator name="motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
"""
_CONTROLLERS = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    arm:
      type: position_controllers/JointGroupPositionController
      joints: [%s]
"""


@rule(
    "UC441",
    stage=Stage.ACTIVATE,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros_controllers: 'Could not find joint 'mount' in 'hardware_interface::EffortJointInterface'.'; Gazebo "
    "merges the link of a fixed joint into its parent, so the joint does not exist there",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow, «mount»"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"}],
)
def controller_joint_fixed(project: Project) -> Iterator[Finding]:
    """Controller uses a fixed joint.

    A fixed joint cannot move, and no hardware exports interfaces for it. The controller is not loaded (ROS 1) or cannot
    be activated (ROS 2).
    """
    robot = robot_of(project)
    if robot is not None:
        hardware = hardware_in(project, robot)
        yield from in_each_distro(project, lambda reader: _fixed(reader, robot, hardware[reader.distro], project))


def _fixed(reader: Reader, robot: Robot, hardware: OfferedHardware, project: Project) -> Iterator[Finding]:
    for name in named(reader):
        if name.name in hardware.fixed and is_misnamed(name.claim, hardware):
            joint = robot.joint(name.name)
            notes = (Note(f"joint '{name.name}' is defined here", joint.at),) if joint else ()
            message = (
                f"controller '{reader.name}' uses joint '{name.name}', which is fixed. "
                "Remove it, or change the joint's type"
            )
            yield Finding(name.at, message, notes, severity=severity_of(project, hardware, meant=True, others=True))
