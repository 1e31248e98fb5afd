"""UC420."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Controller, Controllers
from urdfctl.model.parameters import Kind
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.controllers.sections import meant_for
from urdfctl.source.span import Place


@rule(
    "UC420",
    severity=Severity.ERROR,
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'The 'type' param was not defined for 'arm'.'; "
    "ros_control controller_manager.cpp: 'Could not load controller 'arm' because the type was not specified.'",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                «arm»:
                  kind: forward_command_controller/ForwardCommandController
            arm:
              ros__parameters:
                joints: [shoulder, elbow]
                interface_name: position
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm:
                  type: forward_command_controller/ForwardCommandController
            arm:
              ros__parameters:
                joints: [shoulder, elbow]
                interface_name: position
        """
    },
)
def controller_type_missing(project: Project) -> Iterator[Finding]:
    """A controller has no type.

    The controller manager loads a controller by `<name>.type`, which stands below the manager in ROS 2, or in the
    controller's own section that its spawner is given, and directly below the controller's name in ROS 1.
    """
    controllers = controllers_in(project)
    if not controllers.complete:
        return
    for controller in controllers.controllers:
        if controller.type is None:
            if controller.declared_at is not None or project.launch is None:  # else the rules on launch files tell it
                yield from _untyped(controllers, controller)
        elif controller.type.kind is Kind.STRING and not controller.type.text.strip():
            yield Finding(controller.type.at, f"the type of '{controller.name}' is empty; no controller can be loaded")
        elif controller.type.kind is not Kind.STRING and controller.type.is_known and controller.manager is None:
            yield Finding(controller.type.at, f"the type of '{controller.name}' is no text of the form 'package/Class'")


def _untyped(controllers: Controllers, controller: Controller) -> Iterator[Finding]:
    name = controller.name
    if controller.declared_at is not None:
        yield Finding(controller.declared_at, f"'{name}' has no type; give it one: 'type: package/Class'")
        return
    at = _where(controllers, controller)
    if at is None:
        return
    meant = meant_for(controllers, controller)
    notes = (Note(f"'{meant.path}' stands here, which is another one", meant.at),) if meant else ()
    tail = "; no file that is read here gives its type" if meant is None else ""
    yield Finding(at, f"'{name}' is started, and has no type{tail}", notes)


def _where(controllers: Controllers, controller: Controller) -> Place | None:
    """The manager's section, else the beginning of the first file."""
    manager = controller.manager or next(iter(controllers.managers), None)
    if manager is not None:
        return manager.at
    return controllers.files[0].at if controllers.files else None
