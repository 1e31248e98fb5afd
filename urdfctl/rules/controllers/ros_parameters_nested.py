"""UC404."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import sections


@rule(
    "UC404",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: below the first ros__parameters each key is part of a name",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
                    «ros__parameters»:
                      use_sim_time: true
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
                    use_sim_time: true
            """
        },
    ],
)
def ros_parameters_nested(project: Project) -> Iterator[Finding]:
    """`ros__parameters` nested in another `ros__parameters`.

    Only the outer one counts. The inner one becomes part of the parameter names, and no node reads them. For example, a
    controller's parameters belong in a section of its own, beside that of the controller manager.
    """
    names = {controller.name for controller in controllers_in(project).controllers}
    for section in sections(project):
        for parameter in section.parameters:
            if parameter.last != "ros__parameters":
                continue
            outer = parameter.name.partition(".")[0]
            target = f"a separate section '{outer}:'" if parameter.name.count(".") else "the outer one"
            if outer in names or target == "the outer one":
                message = f"nested 'ros__parameters' becomes part of a parameter name; move its contents to {target}"
            else:
                message = "nested 'ros__parameters' becomes part of a parameter name that no node reads"
            yield Finding(parameter.key, message)
