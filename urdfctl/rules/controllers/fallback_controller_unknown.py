"""UC418."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import Controller, Controllers, Value
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.common import replaced
from urdfctl.source.opaque import UNKNOWN

_FILE = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        hold: {type: forward_command_controller/ForwardCommandController}
        arm:
          type: forward_command_controller/ForwardCommandController
          fallback_controllers: [%s]
    hold:
      ros__parameters:
        joints: [shoulder, elbow]
        interface_name: position
    arm:
      ros__parameters:
        joints: [shoulder, elbow]
        interface_name: position
"""


@rule(
    "UC418",
    stage=Stage.ACTIVATE,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("jazzy"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'Unable to find the fallback controller : "
    "'hld' of the controller : 'arm' within the controller list', 'Controller 'arm' cannot be a fallback controller for "
    "itself.'",
    options=["--distro=jazzy"],
    bad=[{"controllers.yaml": _FILE % "«hld»"}],
    good=[{"controllers.yaml": _FILE % "hold"}],
)
def fallback_controller_unknown(project: Project) -> Iterator[Finding]:
    """Unknown fallback controller.

    A fallback controller must be another controller of the same manager. A controller that names itself is not loaded;
    one that names an unknown controller cannot be activated.
    """
    controllers = controllers_in(project)
    names = [controller.name for controller in controllers.controllers]
    for controller in controllers.controllers:
        given = _given(controller)
        for name, at in given.strings if given else ():
            if name == controller.name:
                yield Finding(at, f"controller '{name}' cannot be its own fallback controller")
            elif _is_absent(controllers, name, names):
                right = nearest(name, names)
                hint = f"; did you mean '{right}'?" if right else ""
                message = f"fallback controller '{name}' of controller '{controller.name}' does not exist{hint}"
                yield Finding(at, message, fix=replaced(at, name, right) if right else None)


def _given(controller: Controller) -> Value | None:
    below = (
        controller.manager.parameters.value(f"{controller.name}.fallback_controllers") if controller.manager else None
    )
    return below or controller.own.value("fallback_controllers")


def _is_absent(controllers: Controllers, name: str, names: list[str]) -> bool:
    return controllers.complete and name not in names and "$" not in name and UNKNOWN not in name
