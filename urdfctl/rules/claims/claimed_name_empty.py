"""UC477."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import of_each_candidate

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: forward_command_controller/ForwardCommandController}
    arm:
      ros__parameters:
        joints: [%s]
        interface_name: position
"""


@rule(
    "UC477",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager.cpp: \"Unable to activate controller 'arm' since the command interface "
    "'/position' is not available.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow, «''»"},
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
                  <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
                </transmission>
            """,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                arm:
                  type: position_controllers/JointPositionController
                  joint: «""»
            """,
        },
    ],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"}],
)
def claimed_name_empty(project: Project) -> Iterator[Finding]:
    """Controller claims an interface of a joint without name.

    An empty text among the joints makes the controller claim '/position'. No hardware has that, so the controller is
    not activated. ROS 1 does not load it.
    """
    return of_each_candidate(project, _empty)


def _empty(session: Session, controller: Configured) -> Iterator[Finding]:
    claimed = controller.type.claims if controller.type else None
    for each in (*claimed.command, *claimed.state) if claimed else ():
        name = each.for_each if not each.best_effort else None
        given = controller.controller.parameters.value(name) if name else None
        parts = given.items or (given,) if given else ()
        empty = next((part for part in parts if part.value == ""), None)
        if name and empty is not None and (empty is not given or _reads_text(session, controller, name)):
            yield Finding(empty.at, f"'{name}' of controller '{controller.name}' has an empty name")
            return


def _reads_text(session: Session, controller: Configured, name: str) -> bool:
    """Whether a controller of ROS 1 takes an empty text for the name of a joint; no other rule reports that."""
    parameter = controller.type.parameters.get(name) if controller.type else None
    is_refused = parameter is None or "string" not in parameter.types or "not_empty" in parameter.validators
    return generation(session.distro) == 1 and not is_refused
