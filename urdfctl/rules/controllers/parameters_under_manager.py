"""UC415."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.controllers.parameters import OF_THE_SPAWNER, is_lacking


@rule(
    "UC415",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control controller_manager/src/controller_manager.cpp: of a controller the manager's own node reads "
    "type, params_file and fallback_controllers only",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm:
                  type: forward_command_controller/ForwardCommandController
                  «joints»: [shoulder, elbow]
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
def parameters_under_manager(project: Project) -> Iterator[Finding]:
    """A controller's parameters stand below the controller manager, where the controller does not look.

    Each controller is a node of its own and reads the section of its own name. Below the manager belong its type and
    little else; what else stands there is ignored, and a controller that needs it is not loaded.
    """
    for controller in controllers_in(project).controllers:
        lost = [p for p in controller.under_manager.below() if p.name not in OF_THE_SPAWNER]
        if not lost:
            continue
        names = [parameter.name for parameter in lost]
        message = (
            f"{in_words(names, 3)} of '{controller.name}' cannot stand below the controller manager; "
            f"a section '{controller.name}:' of its own, with 'ros__parameters:', is where the controller reads"
        )
        fix = Fix(f"move it into '{controller.name}: ros__parameters:'")
        severity = Severity.ERROR if is_lacking(project, controller, names) else None
        yield Finding(lost[0].key, message, fix=fix, severity=severity)
