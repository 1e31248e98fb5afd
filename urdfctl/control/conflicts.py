"""Controllers that cannot run together because they claim the same resource.

ROS 2, controller_manager.cpp: a command interface belongs to one active controller; states are shared. ROS 1,
hardware_interface/robot_hw.h, checkForConflict: a controller claims a joint by its name, whatever the interface. A
controller that claims a joint in two interfaces is in conflict with itself.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.claims import Claim
from urdfctl.control.session import Configured, Session
from urdfctl.startup.records import NamedTuple


class Conflict(NamedTuple):
    """Two started controllers that claim one interface, or in ROS 1 one joint."""

    first: Configured
    second: Configured
    """The controller that is started later."""
    claim: Claim
    """The claim of the second controller."""
    earlier: Claim
    """The claim of the first controller."""


def resource(claim: Claim, distro: str) -> str:
    """Return the name of what only one controller can claim: the interface, in ROS 1 the joint."""
    return claim.component if generation(distro) == 1 else claim.name


def conflicts(session: Session) -> Iterator[Conflict]:
    """Yield the conflicts between started controllers; for two controllers each resource once."""
    taken: dict[tuple[str | None, str], tuple[Configured, Claim]] = {}
    for controller in session.started or ():
        for claim in _once(controller, session.distro):
            key = controller.controller.namespace, resource(claim, session.distro)
            if key in taken:
                first, earlier = taken[key]
                yield Conflict(first, controller, claim, earlier)
            else:
                taken[key] = controller, claim


def _once(controller: Configured, distro: str) -> list[Claim]:
    first: dict[str, Claim] = {}
    for claim in controller.claims.command:
        first.setdefault(resource(claim, distro), claim)
    return list(first.values())


def claimed_twice(controller: Configured, distro: str) -> Iterator[tuple[Claim, Claim]]:
    """Yield the repeated claims of a controller as pairs of the first claim and the repeated one.

    A claim is repeated if it is for the same interface, in ROS 1 for the same joint in another interface.
    """
    first: dict[str, Claim] = {}
    for claim in controller.claims.command:
        earlier = first.setdefault(resource(claim, distro), claim)
        if earlier is claim or (generation(distro) == 1 and earlier.interface == claim.interface):
            continue
        yield earlier, claim
