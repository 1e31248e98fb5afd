"""UC415."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Fix, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.controllers.parameters import OF_THE_SPAWNER, is_lacking


@rule(
    "UC415",
    stage=StageDependsOn.PARAMETER_CHECKS,
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="ros2_control controller_manager/src/controller_manager.cpp: for a controller the manager's node reads only "
    "type, params_file and fallback_controllers",
    options=["--distro=jazzy"],
    bad=[
        {
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
def parameters_under_manager(project: Project) -> Iterator[Finding]:
    """Controller parameters below the controller manager.

    Each controller is a node of its own and reads the section with its name. The manager's section holds only its type
    and a few other keys. Other parameters there are ignored, and a controller that requires them is not loaded.
    """
    for controller in controllers_in(project).controllers:
        ignored = [p for p in controller.under_manager.below() if p.name not in OF_THE_SPAWNER]
        if not ignored:
            continue
        names = [parameter.name for parameter in ignored]
        message = (
            f"controller '{controller.name}' does not read {in_words(names, 3)} below the controller manager; "
            f"it reads only its own section '{controller.name}:' with 'ros__parameters:'"
        )
        fix = Fix(f"move to '{controller.name}: ros__parameters:'")
        severity = Severity.ERROR if is_lacking(project, controller, names) else None
        yield Finding(ignored[0].key, message, fix=fix, severity=severity)
