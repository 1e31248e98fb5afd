"""UC416."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.parameters import is_lacking
from urdfctl.rules.controllers.sections import meant_for


@rule(
    "UC416",
    stage=StageDependsOn.PARAMETER_CHECKS,
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="rclcpp rclcpp/src/rclcpp/parameter_map.cpp: a section is read by the node whose full name it matches; "
    "controller_manager's spawner: 'Controller : /arm parameters not found in parameter files'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm_controller: {type: forward_command_controller/ForwardCommandController}
                «arm_controler»:
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
                    arm_controller: {type: forward_command_controller/ForwardCommandController}
                arm_controller:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
            """
        },
    ],
)
def section_not_read(project: Project) -> Iterator[Finding]:
    """Controller section with a wrong name or namespace.

    A controller reads the section with its full name, i.e. its manager's namespace and its own name, and sections with
    matching wildcards. ROS ignores a section that matches no node silently.
    """
    controllers = controllers_in(project)
    for controller in controllers.controllers:
        section = meant_for(controllers, controller)
        if section is None:
            continue
        fix = None
        full_name = f"{controller.namespace or ''}/{controller.name}"
        message = f"section '{section.path}' matches no node; the controller is '{full_name}'"
        if section.name != controller.name:
            message = f"section '{section.path}' matches no node; did you mean controller '{controller.name}'?"
            fix = replaced(section.at, section.name, controller.name)
        at = controller.declared_at
        notes = (Note(f"controller '{controller.name}' is declared here", at),) if at else ()
        severity = Severity.ERROR if is_lacking(project, controller) else None
        yield Finding(section.at, message, notes, fix, severity)
