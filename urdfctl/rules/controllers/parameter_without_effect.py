"""UC438."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import Reader, controllers_in, in_each_distro, readers_of
from urdfctl.model.controllers import Value
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.parameters import known_as


@rule(
    "UC438",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="ros2_control jazzy: controllers' nodes do not declare async_parameters; ros_controllers: controllers for "
    "position joints read no gains",
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
                    async_parameters:
                      «thread_priority»: 40
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
            """
        },
    ],
)
def parameter_without_effect(project: Project) -> Iterator[Finding]:
    """Parameter without effect.

    The parameter is documented or looks plausible, but the node does not read it. The value is ignored silently.
    """
    yield from in_each_distro(project, _ignored)
    yield from _overridden(project)


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


def _overridden(project: Project) -> Iterator[Finding]:
    """The parameters of sections with a wildcard that each controller which reads them sets to another value itself."""
    controllers = controllers_in(project)
    readers = [each[-1] for each in readers_of(project) if each[-1].controller is not None]
    if controllers.others or len(readers) < len(controllers.controllers):
        return  # another node may read them
    for section in controllers.shared:
        for leaf in section.parameters.leaves:
            reading = [reader for reader in readers if known_as(reader, leaf.name)]
            setting = [each for reader in reading if (each := reader.own.get(leaf.name)) and each is not leaf]
            if not reading or len(setting) < len(reading) or any(_same(each.value, leaf.value) for each in setting):
                continue
            if any(reader.located.value(leaf.name) is leaf.value for reader in reading):
                continue  # it wins: UC417
            message = f"'{leaf.name}' has no effect: each controller that reads it sets it in its own section"
            yield Finding(leaf.key, message, (Note("this value is used", setting[0].value.at),))


def _same(value: Value, other: Value) -> bool:
    return value.text == other.text and [item.text for item in value.items] == [item.text for item in other.items]
