"""UC707."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.controller_types import typed_upstream
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.migration.common import lacking


@rule(
    "UC707",
    severity=Severity.INFO,
    runtime="works",
    distros=ROS2,
    authority="ros2_controllers#2016: position_controllers, velocity_controllers and effort_controllers are removed; "
    "doc/migration.rst of each distro",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    wheels:
                      type: «velocity_controllers/JointGroupVelocityController»
                wheels:
                  ros__parameters:
                    joints: [shoulder, elbow]
            """,
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    wheels:
                      type: forward_command_controller/ForwardCommandController
                wheels:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: velocity
            """,
        },
    ],
)
def controller_gone_soon(project: Project) -> Iterator[Finding]:
    """Controller type is missing in a later distro.

    The rule checks the distros up to the next one with long-term support.
    """
    for use in typed_upstream(project):
        gone = lacking(project, tuple(distro for distro in use.known_in if distro in ROS2))
        kind = project.catalog.controller(use.type, project.distro) if gone and project.distro else None
        if gone is None or kind is None or kind.deprecated or kind.external:
            continue
        instead = project.catalog.replacement(use.type, gone)
        message = f"controller type '{use.type}' exists in {project.distro} but not in {gone}"
        fix, notes = None, []
        if instead:
            fix = Fix(f"in {gone} use '{instead.type}'")
            notes = [Note(f"set {name}: {value}") for name, value in instead.parameters.items()]
        yield Finding(use.at.at, message, tuple(notes), fix)
