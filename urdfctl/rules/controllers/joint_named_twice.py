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
    """
    return in_each_distro(project, _twice)


def _twice(reader: Reader) -> Iterator[Finding]:
    if not is_ros1(reader):
        return
    first: dict[tuple[str | None, str], Named] = {}
    for joint in named(reader):
        earlier = first.setdefault((joint.claim.parameter, joint.name), joint)
        if earlier is not joint:
            notes = (Note("first named here", earlier.at),)
            message = f"controller '{reader.name}' names joint '{joint.name}' twice"
            yield Finding(joint.at, message, notes, severity=Severity.WARNING)
