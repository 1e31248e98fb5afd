"""Which controllers a generator writes: those of the options, of the joint list, or proposed from the robot."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.errors import UserError
from urdfctl.generate.controllers.proposals import numbered, proposed, shown, with_interfaces
from urdfctl.generate.controllers.recipes import kind_of
from urdfctl.generate.options import GeneratorOptions, Request
from urdfctl.generate.request.planning_group import LinkTree, asked_group
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
        options = _parted(proposed(robot, joints, options), options, robot)
    except UserError:
        if not is_open:
            raise
        options = options._replace(requests=())  # the interfaces of the joints can be written without their controllers
    line = f"controllers proposed from the robot: {shown(options.requests)}" if options.requests else ""
    line = f"interfaces for the {line}" if line and is_open else line
    return options, line


def _parted(requests: Sequence[Request], options: GeneratorOptions, robot: RobotFacts) -> GeneratorOptions:
    """The options with these requests, those for more joints than a group in two: for the group, and for the rest.

    A trajectory controller takes only goals for all of its joints. Together they move the whole chain, which is a group
    as well.
    """
    groups = options.planning_groups
    tree = LinkTree(robot.linkage.links) if robot.linkage and groups else None
    for group in [asked_group(text, tree) for text in groups] if tree else ():
        moved = {*group.joints}
        whole = next((one for one in requests if one.type == "trajectory" and moved < {*one.patterns}), None)
        if tree is None or whole is None:
            continue
        rest = tuple(name for name in whole.patterns if name not in moved)
        part = whole._replace(name=f"{group.name}_controller", patterns=group.joints)
        parts = [part, whole._replace(patterns=rest)]
        requests = [other for one in requests for other in (parts if one is whole else (one,))]
        first, last = tree.of_joint[whole.patterns[0]], tree.of_joint[whole.patterns[-1]]
        stem = whole.name.removesuffix("_controller")
        name = f"whole_{stem}" if stem == group.name else f"{stem}_with_{group.name}"
        groups = (*groups, f"{name}={first.parent}:{last.name}")
    return options._replace(requests=tuple(numbered(requests)), planning_groups=groups)


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
