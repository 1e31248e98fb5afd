"""UC443."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.joints import Named, named
from urdfctl.rules.controllers.parameters import is_ros1
from urdfctl.rules.controllers.readers import Reader, in_each_distro


@rule(
    "UC443",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="ros_controllers forward_command_controller/forward_joint_group_command_controller.h: a handle is taken for "
    "each name in the list, and commands are as long as it is",
    options=["--distro=noetic"],
    bad={
        "controllers.yaml": """
            arm:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow, «elbow»]
        """
    },
    good={
        "controllers.yaml": """
            arm:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow]
        """
    },
)
def joint_named_twice(project: Project) -> Iterator[Finding]:
    """A controller of ROS 1 names a joint twice.

    It is loaded, expects a command for each name, and writes the joint's twice: the last one counts.
    """
    return in_each_distro(project, _twice)


def _twice(reader: Reader) -> Iterator[Finding]:
    if not is_ros1(reader):
        return
    first: dict[tuple[str | None, str], Named] = {}
    for one in named(reader):
        earlier = first.setdefault((one.claim.parameter, one.name), one)
        if earlier is not one:
            notes = (Note("the first time", earlier.at),)
            message = f"controller '{reader.name}' names the joint '{one.name}' twice"
            yield Finding(one.at, message, notes, severity=Severity.WARNING)
