"""UC420."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import controllers_in
from urdfctl.control.parameters.spawner_options import DISTROS
from urdfctl.model.controllers import Controller, Controllers, ValueKind
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.sections import meant_for
from urdfctl.source.span import Place

_TYPE = "--controller-type"


@rule(
    "UC420",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'The 'type' param was not defined for 'arm'.'; "
    "ros_control controller_manager.cpp: 'Could not load controller 'arm' because the type was not specified.'",
    options=["--distro=jazzy"],
    bad=[
        {
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
    ],
    good=[
        {
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
    ],
)
def controller_type_missing(project: Project) -> Iterator[Finding]:
    """Controller without a type.

    The controller manager cannot load a controller without its type. In ROS 2 it reads `<name>.type` below the manager,
    or `type` in the controller's own section if the spawner gets that file. In ROS 1 it reads `type` directly below the
    controller's name.
    """
    controllers = controllers_in(project)
    if not controllers.complete:
        return
    for controller in controllers.controllers:
        if controller.type is None and _gets_type(project, controller):
            continue
        if controller.type is None:
            if controller.declared_at is not None or project.launch is None:  # else launch file rules report it
                yield from _untyped(controllers, controller)
        elif controller.type.kind is ValueKind.STRING and not controller.type.text.strip():
            yield Finding(
                controller.type.at, f"controller '{controller.name}' has an empty type; write 'package/Class'"
            )
        elif controller.type.kind is not ValueKind.STRING and controller.type.is_known and controller.manager is None:
            yield Finding(
                controller.type.at, f"type of controller '{controller.name}' is not a string; write 'package/Class'"
            )


def _gets_type(project: Project, controller: Controller) -> bool:
    """Whether a spawner of a controller gives it a type, in a distro that it may be started in."""
    spawns = project.launch.spawns if project.launch else ()
    own = [spawn for spawn in spawns if controller.name in [name for name, _ in spawn.names]]
    typed = any(spawn.option("-t", _TYPE) is not None for spawn in own)
    return typed and not {*DISTROS[_TYPE]}.isdisjoint(project.distros)


def _untyped(controllers: Controllers, controller: Controller) -> Iterator[Finding]:
    name = controller.name
    if controller.declared_at is not None:
        yield Finding(controller.declared_at, f"controller '{name}' has no type; add 'type: package/Class'")
        return
    at = _where(controllers, controller)
    if at is None:
        return
    meant = meant_for(controllers, controller)
    if meant is None:
        yield Finding(at, f"controller '{name}' is started, but no file read here gives its type")
        return
    note = Note(f"section '{meant.path}' is here; it has another name or namespace", meant.at)
    yield Finding(at, f"controller '{name}' is started, but has no type", (note,))


def _where(controllers: Controllers, controller: Controller) -> Place | None:
    """The manager's section, else the start of the first file."""
    manager = controller.manager or next(iter(controllers.managers), None)
    if manager is not None:
        return manager.at
    return controllers.files[0].at if controllers.files else None
