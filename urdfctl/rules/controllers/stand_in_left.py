"""UC449."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.parameters import Parameter
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in

_MARK = b"TODO"
_MAKER = b"made by urdfctl "


@rule(
    "UC449",
    severity=Severity.WARNING,
    authority="urdfctl gen-controllers: what the robot does not tell is written as a stand-in, and marked TODO",
    options=["--distro=noetic"],
    bad={
        "controllers.yaml": """
            # made by urdfctl gen-controllers --joint elbow --type gripper --distro noetic
            gripper_controller:
              type: effort_controllers/GripperActionController
              joint: elbow
              max_effort: «10.0»  # N or Nm, TODO: the joint has no limit
              gains:
                elbow: {p: 10.0, i: 0.0, d: 0.1}
        """
    },
    good={
        "controllers.yaml": """
            # made by urdfctl gen-controllers --joint elbow --type gripper --distro noetic
            gripper_controller:
              type: effort_controllers/GripperActionController
              joint: elbow
              max_effort: 4.5  # N or Nm
              gains:
                elbow: {p: 10.0, i: 0.0, d: 0.1}
        """
    },
)
def stand_in_left(project: Project) -> Iterator[Finding]:
    """A value that a generator could not know is still the stand-in that it wrote.

    It keeps the file in order, and it is not the robot's: a drive with another wheel radius goes another way than it
    is told. Set the value, and take the TODO out of its comment.
    """
    for controller in controllers_in(project).controllers:
        for parameter in controller.parameters.leaves:
            told = _told(parameter)
            if told is not None:
                message = f"'{parameter.name}' of '{controller.name}' is a stand-in that waits for its value{told}"
                yield Finding(parameter.value.at, message)


def _told(parameter: Parameter) -> str | None:
    """What the comment behind a generated parameter says that is to be done; None where it has no TODO."""
    span = parameter.key.span
    source = span.source
    if _MARK not in source.data or not source.data.startswith(b"# " + _MAKER):
        return None
    comment = source.line(source.position(span.start).line).partition("# ")[2]
    _, mark, rest = comment.partition(_MARK.decode())
    return rest.rstrip() if mark else None
