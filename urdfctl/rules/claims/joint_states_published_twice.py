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
    authority="ros_controllers joint_state_controller and ros2_controllers joint_state_broadcaster publish on the topic "
    "joint_states of their manager",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic", "--start=states,more_states"],
    bad={
        "robot.urdf": _ROBOT,
        "controllers.yaml": """
            states: {type: joint_state_controller/JointStateController, publish_rate: 50}
            more_states: {type: «joint_state_controller/JointStateController», publish_rate: 10}
        """,
    },
    good={
        "robot.urdf": _ROBOT,
        "controllers.yaml": """
            states: {type: joint_state_controller/JointStateController, publish_rate: 50}
            more_states: {type: position_controllers/JointPositionController, joint: elbow}
        """,
    },
)
def joint_states_published_twice(project: Project) -> Iterator[Finding]:
    """Two controllers that are started publish the states of the same joints on one topic.

    Whoever reads joint_states gets each joint twice, at two rates: transforms come in bursts, and in velocities the two
    mix.
    """
    return of_each_candidate(project, _again)


def _again(session: Session, one: Configured) -> Iterator[Finding]:
    at, joints = home(one.controller), _joints(one)
    for other in session.started or ():
        if other is one:
            return
        first = home(other.controller)
        same = other.controller.namespace == one.controller.namespace
        if same and joints & _joints(other) and at is not None and first is not None:
            message = (
                f"'{one.name}' publishes the joint states that '{other.name}' publishes already: start one of them"
            )
            yield Finding(at, message, (Note(f"'{other.name}' is declared here", first),))


def _joints(one: Configured) -> set[str]:
    """The joints that a controller publishes on the common topic."""
    if one.type is None or not one.type.publishes_joint_states or one.values.get(_LOCAL):
        return set()
    return {claim.component for claim in one.claims.state}
