"""UC416."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.controllers.parameters import is_lacking
from urdfctl.rules.controllers.sections import meant_for


@rule(
    "UC416",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="rclcpp rclcpp/src/rclcpp/parameter_map.cpp: a section is read by the node whose full name it matches; "
    "controller_manager's spawner: 'Controller : /arm parameters not found in parameter files'",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def section_not_read(project: Project) -> Iterator[Finding]:
    """A section was meant for a controller, and has another name or namespace.

    A controller reads the section of its full name, which is its manager's namespace and its own name, and those with
    wildcards that match it. Nobody tells that a section is read by no node.
    """
    controllers = controllers_in(project)
    for controller in controllers.controllers:
        section = meant_for(controllers, controller)
        if section is None:
            continue
        fix = None
        message = f"no node reads '{section.path}': the controller is '{controller.namespace or ''}/{controller.name}'"
        if section.name != controller.name:
            message = f"no node reads '{section.path}'; did you mean the controller '{controller.name}'?"
            fix = replaced(section.at, section.name, controller.name)
        at = controller.declared_at
        notes = (Note(f"'{controller.name}' is declared here", at),) if at else ()
        severity = Severity.ERROR if is_lacking(project, controller) else None
        yield Finding(section.at, message, notes, fix, severity)
