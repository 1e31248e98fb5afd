"""Which controllers a generator writes: those of the options, of the joint list, or proposed from the robot."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.errors import UserError
from urdfctl.generate.controllers.proposals import proposed, shown, with_interfaces
from urdfctl.generate.controllers.recipes import kind_of
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.request.requests import of_list, requested
from urdfctl.generate.robot.facts import JointFacts, RobotFacts

_OF_CONTROLLERS = ("gen-controllers", "gen-launch", "gen-all", "gen-moveit")
_OF_INTERFACES = ("gen-ros2-control", "gen-transmissions")
"""The commands that write the interfaces which the controllers need, unless the user names interfaces."""


def with_requests(
    options: GeneratorOptions,
    command: str,
    texts: Sequence[str],
    joints: Sequence[JointFacts],
    robot: RobotFacts | None,
) -> tuple[GeneratorOptions, str]:
    """Return the options with the requested controllers, and a line about those that were proposed, or an empty one.

    UserError if the requests are malformed or unclear.
    """
    if options.own:
        return options, ""
    asked = requested(texts)
    if not asked and any(joint.controller or joint.controller_type for joint in joints):
        default = options.types[0] if len(options.types) == 1 else None
        return options._replace(requests=of_list(joints, default), types=()), ""
    is_open = command in _OF_INTERFACES and not (options.interface or any(joint.interface for joint in joints))
    if asked or options.types or robot is None or not (is_open or command in _OF_CONTROLLERS):
        return options._replace(requests=asked), ""
    try:
        found = proposed(robot, joints, options)
    except UserError:
        if not is_open:
            raise
        found = ()  # the interfaces of the joints can be written without their controllers
    line = f"controllers proposed from the robot: {shown(found)}" if found else ""
    line = f"interfaces for the {line}" if line and is_open else line
    return options._replace(requests=found), line


def way_out(options: GeneratorOptions, proposal: str) -> str:
    """Return how to ask for the same if the proposed controllers cannot all command several interfaces of a joint."""
    if not proposal or len(options.interfaces) < 2:  # noqa: PLR2004 (each controller commands one)
        return ""
    return (
        f"; in place of --interface, name them where they fit: {with_interfaces(options.requests, options.interfaces)}"
    )


def needs_joints(options: GeneratorOptions, catalog: Catalog) -> bool:
    """Return whether one of the requested controllers commands joints, or none is requested."""
    types = (*options.types, *(request.type for request in options.requests))
    kinds = [kind_of(name, catalog, options) for name in types]
    return not kinds or any(kind.interface and kind.short != "gpio" for kind in kinds)
