"""UC443."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.joints import Named, named
from urdfctl.rules.controllers.parameters import is_ros1


@rule(
    "UC443",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="ros_controllers forward_command_controller/forward_joint_group_command_controller.h: one handle for "
    "each name in the list, and as many commands as names",
    options=["--distro=noetic"],
    bad=[
        {
            "controllers.yaml": """
                arm:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow, «elbow»]
            """
        },
        {
            "controllers.yaml": """
                states: {type: joint_state_controller/JointStateController, publish_rate: 50}
                base:
                  type: diff_drive_controller/DiffDriveController
                  left_wheel: shoulder
                  right_wheel: «shoulder»
                  pose_covariance_diagonal: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]
                  twist_covariance_diagonal: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                arm:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
            """
        },
    ],
)
def joint_named_twice(project: Project) -> Iterator[Finding]:
    """Joint named twice in a ROS 1 controller.

    The controller is loaded and expects one command per name. It writes both commands to the joint; the last one wins.
    A wheel that is on both sides of a drive moves the robot in no way that its odometry says.
    """
    return in_each_distro(project, _twice)


def _twice(reader: Reader) -> Iterator[Finding]:
    if not is_ros1(reader):
        return
    first: dict[str, Named] = {}
    for joint in named(reader):
        earlier = first.setdefault(joint.name, joint)
        if earlier is not joint:
            notes = (Note("first named here", earlier.at),)
            message = f"controller '{reader.name}' names joint '{joint.name}' twice"
            yield Finding(joint.at, message, notes, severity=Severity.WARNING)
