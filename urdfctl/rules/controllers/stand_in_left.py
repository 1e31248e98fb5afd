"""UC449."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import Parameter
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.source.span import SourceText
from urdfctl.startup.per_object import once_per_object

_MARK = b"TODO"
_MAKER = b"made by urdfctl "


@rule(
    "UC449",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="urdfctl gen-controllers: a value that the robot does not give is written as a placeholder and marked TODO",
    options=["--distro=noetic"],
    bad=[
        {
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
    ],
    good=[
        {
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
    ],
)
def stand_in_left(project: Project) -> Iterator[Finding]:
    """Placeholder value left in a generated file.

    The generator could not determine the value. The placeholder makes the file valid, but is not the robot's value: a
    drive with a wrong wheel radius does not go where it should. Set the value, and remove the TODO from its comment.
    """
    for controller in controllers_in(project).controllers:
        for parameter in controller.parameters.leaves:
            todo = _todo(parameter)
            if todo is not None:
                message = f"'{parameter.name}' of controller '{controller.name}' is still a placeholder{todo}"
                yield Finding(parameter.value.at, message)


@once_per_object
def _may_have_stand_ins(source: SourceText) -> bool:
    return _MARK in source.data and source.data.startswith(b"# " + _MAKER)


def _todo(parameter: Parameter) -> str | None:
    """The text after TODO in the comment of a generated parameter; None without a TODO."""
    span = parameter.key.span
    source = span.source
    if not _may_have_stand_ins(source):
        return None
    comment = source.line(source.position(span.start).line).partition("# ")[2]
    _, mark, rest = comment.partition(_MARK.decode())
    return rest.rstrip() if mark else None
