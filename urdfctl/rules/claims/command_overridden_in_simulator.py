"""UC476."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.hardware import Behaviour
from urdfctl.control.claims import Claim
from urdfctl.control.hardware.behaviour import behaviour_of
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.claims.common import of_each_candidate, place_of
from urdfctl.source.span import Place

_HOLDS = "position"
"""The command that alone brings a joint to its goal."""
_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
      <joint name="elbow">
        <command_interface name="position"/><command_interface name="velocity"/><command_interface name="effort"/>
        <state_interface name="position"/><state_interface name="velocity"/>
      </joint>
    </ros2_control>
    <gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>/opt/arm/controllers.yaml</parameters>
      </plugin>
    </gazebo>
"""
_IN_MUJOCO = (
    _ROBOT.partition("<gazebo>")[0]
    .replace("gz_ros2_control/GazeboSimSystem", "mujoco_ros2_control/MujocoSystemInterface")
    .replace("</plugin></hardware>", '</plugin><param name="mujoco_model">/opt/arm/scene.xml</param></hardware>')
)
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: joint_trajectory_controller/JointTrajectoryController}
    arm:
      ros__parameters:
        joints: [elbow]
        command_interfaces: [%s]
        state_interfaces: [position, velocity]
"""


@rule(
    "UC476",
    severity=Severity.WARNING,
    runtime="misbehaves",
    distros=ROS2,
    authority="gz_ros2_control gz_system.cpp write() (jazzy 627-661, humble ign_system.cpp 632-666): if VELOCITY, else if "
    "POSITION, else if EFFORT; mujoco_ros2_control mujoco_system_interface.cpp perform_command_mode_switch(): 'Only one type of "
    "control mode can be active at a time'; joint_trajectory_controller: with position among the command interfaces it runs no loop",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«position», velocity"},
        {"robot.urdf": _IN_MUJOCO, "controllers.yaml": _CONTROLLERS % "«position», velocity"},
    ],
    good=[
        {"robot.urdf": _IN_MUJOCO, "controllers.yaml": _CONTROLLERS % "velocity, position"},
        {"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "position"},
        {
            "robot.urdf": _ROBOT.replace("gz_ros2_control/GazeboSimSystem", "mock_components/GenericSystem").partition(
                "<gazebo>"
            )[0],
            "controllers.yaml": _CONTROLLERS % "position, velocity",
        },
    ],
)
def command_overridden_in_simulator(project: Project) -> Iterator[Finding]:
    """Simulator never applies a command.

    Of the command interfaces of a joint that controllers have claimed together, gz applies one: velocity before
    position before effort. A trajectory controller with position and velocity leaves the loop to the hardware, so the
    arm runs open loop, drifts, and does not hold its pose. Claim position alone.
    """

    def judge(session: Session, controller: Configured) -> Iterator[Finding]:
        writing = _writing(project, session.distro)
        claimed: dict[str, dict[str, Claim]] = {}
        for claim in controller.claims.command:
            step = writing.get(claim.component)
            if step is not None and (step.last or claim.interface in step.first):
                claimed.setdefault(claim.component, {}).setdefault(claim.interface, claim)
        told: set[Place] = set()
        for joint, by_interface in claimed.items():
            applied, *others = _in_order(list(by_interface), writing[joint])
            for other in others if applied != _HOLDS else ():
                at = place_of(controller, by_interface[other], of_interface=True)
                if at is not None and at not in told:
                    told.add(at)
                    first = place_of(controller, by_interface[applied], of_interface=True)
                    notes = (Note("the simulator applies this one", first),) if first and first != at else ()
                    message = (
                        f"controller '{controller.name}' claims {other} and {applied} of joint '{joint}'; the simulator"
                    )
                    yield Finding(at, f"{message} applies only the {applied}, never the {other}", notes)

    return of_each_candidate(project, judge)


def _in_order(interfaces: list[str], writing: Behaviour) -> list[str]:
    """The command interfaces of a joint, the one that is applied first."""
    return interfaces[::-1] if writing.last else sorted(interfaces, key=writing.first.index)


def _writing(project: Project, distro: str) -> dict[str, Behaviour]:
    """What the simulator does with the commands of a joint, by joint."""
    found: dict[str, Behaviour] = {}
    for control in project.robot.ros2_controls if project.robot else ():
        step = behaviour_of(project.catalog, control.plugin, distro, "write")
        if step is not None and (step.first or step.last):
            found |= {(part.name or "").strip(): step for part in control.parts if part.kind == "joint"}
    return found
