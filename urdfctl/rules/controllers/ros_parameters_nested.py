"""UC404."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in, sections


@rule(
    "UC404",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: below the first ros__parameters each key is part of a name",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def ros_parameters_nested(project: Project) -> Iterator[Finding]:
    """`ros__parameters` stands once more below itself.

    Only the first one counts. The second is taken for a part of the parameters' names, and nobody reads them: a
    controller's parameters, for one, belong into a section of its own, beside that of the controller manager.
    """
    names = {controller.name for controller in controllers_in(project).controllers}
    for section in sections(project):
        for parameter in section.parameters:
            if parameter.last != "ros__parameters":
                continue
            around = parameter.name.partition(".")[0]
            where = f"a section '{around}:' of its own" if parameter.name.count(".") else "the outer one"
            if around in names or where == "the outer one":
                message = f"'ros__parameters' stands below another one, where it is part of a name; its contents belong into {where}"
            else:
                message = "'ros__parameters' stands below another one, where it is part of a name that nobody reads"
            yield Finding(parameter.key, message)
