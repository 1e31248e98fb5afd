"""UC466."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.claims.common import home, of_each_candidate

_LOCAL = "use_local_topics"
_ROBOT = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
"""


@rule(
    "UC466",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="ros_controllers joint_state_controller and ros2_controllers joint_state_broadcaster publish on the topic "
    "joint_states of their manager",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic", "--start=states,more_states"],
    bad=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                more_states: {type: «joint_state_controller/JointStateController», publish_rate: 10}
            """,
        },
    ],
    good=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                more_states: {type: position_controllers/JointPositionController, joint: elbow}
            """,
        },
    ],
)
def joint_states_published_twice(project: Project) -> Iterator[Finding]:
    """Joint states are published twice.

    Two started controllers publish the same joints on one topic. Subscribers of joint_states get each joint twice, at
    two rates: transforms arrive in bursts, and the velocities of both mix.
    """
    return of_each_candidate(project, _again)


def _again(session: Session, controller: Configured) -> Iterator[Finding]:
    at, joints = home(controller.controller), _joints(controller)
    for other in session.started or ():
        if other is controller:
            return
        first = home(other.controller)
        same = other.controller.namespace == controller.controller.namespace
        if same and joints & _joints(other) and at is not None and first is not None:
            message = (
                f"controller '{controller.name}' publishes the same joint states as controller '{other.name}'; "
                "start only one of them"
            )
            yield Finding(at, message, (Note(f"controller '{other.name}' is declared here", first),))


def _joints(controller: Configured) -> set[str]:
    """The joints that a controller publishes on the shared topic."""
    kind = controller.type
    if kind is None or not kind.publishes_joint_states or controller.values.get(_LOCAL):
        return set()
    return {claim.component for claim in controller.claims.state}
