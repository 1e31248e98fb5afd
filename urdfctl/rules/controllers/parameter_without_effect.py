"""UC438."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.readers import Reader, in_each_distro
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.parameters import known_as


@rule(
    "UC438",
    severity=Severity.WARNING,
    authority="ros2_control jazzy: controllers' nodes do not declare async_parameters; ros_controllers: controllers for "
    "position joints read no gains",
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
                async_parameters:
                  «thread_priority»: 40
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
        """
    },
)
def parameter_without_effect(project: Project) -> Iterator[Finding]:
    """Parameter without effect.

    The parameter is documented or looks plausible, but the node does not read it. The value is ignored silently.
    """
    return in_each_distro(project, _ignored)


def _ignored(reader: Reader) -> Iterator[Finding]:
    for leaf in reader.own.leaves:
        matched = known_as(reader, leaf.name)
        if matched is not None and reader.known[matched[0]].ignored:
            message = f"'{leaf.name}' has no effect in {reader.distro}; controllers do not read it"
            yield Finding(leaf.key, message, severity=Severity.WARNING)
    for name in reader.type.ignored if reader.type else ():
        given = None if name in reader.known else reader.own.get(name)
        if given is not None and reader.type is not None:
            message = f"'{name}' has no effect; controller type '{reader.type.type}' does not read it"
            yield Finding(given.key, message, severity=Severity.WARNING)
