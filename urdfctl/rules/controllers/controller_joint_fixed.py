"""UC441."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware import Hardware
from urdfctl.control.names import is_misnamed
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.joints import hardware_in, named, robot_of, severity_of
from urdfctl.rules.controllers.readers import Reader, in_each_distro

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
    severity=Severity.ERROR,
    authority="ros_controllers: 'Could not find joint 'mount' in 'hardware_interface::EffortJointInterface'.'; Gazebo has "
    "no joint for a fixed one, which it lumps into its parent",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow, «mount»"},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"},
)
def controller_joint_fixed(project: Project) -> Iterator[Finding]:
    """A controller names a joint that is fixed.

    A fixed joint cannot be moved, and no hardware offers anything of it: the controller is not loaded (ROS 1), or never
    activated (ROS 2).
    """
    robot = robot_of(project)
    if robot is not None:
        hardware = hardware_in(project, robot)
        yield from in_each_distro(project, lambda reader: _fixed(reader, robot, hardware[reader.distro], project))


def _fixed(reader: Reader, robot: Robot, hardware: Hardware, project: Project) -> Iterator[Finding]:
    for one in named(reader):
        if one.name in hardware.fixed and is_misnamed(one.claim, hardware):
            joint = robot.joint(one.name)
            notes = (Note("it is fixed here", joint.at),) if joint else ()
            message = f"joint '{one.name}' of controller '{reader.name}' is fixed, and nothing can move it"
            yield Finding(one.at, message, notes, severity=severity_of(project, hardware, meant=True, others=True))
