"""Claims of a joint that does not exist or is fixed: the name is wrong, not the interface."""

from __future__ import annotations

from urdfctl.control.claims import Claim
from urdfctl.control.hardware.interfaces import OfferedHardware

_OF_JOINTS = ("position", "velocity", "acceleration", "effort")
_OF_JOINTS_IN_ROS1 = ("JointInterface", "JointStateInterface")


def is_of_joint(claim: Claim) -> bool:
    """Return whether a claim is for a joint, judged by its interface."""
    return claim.interface in _OF_JOINTS or claim.interface.endswith(_OF_JOINTS_IN_ROS1)


def is_misnamed(claim: Claim, hardware: OfferedHardware) -> bool:
    """Return whether a parameter names a joint that neither robot nor hardware has, or that is fixed.

    Names with a slash are interfaces of other controllers, and not misnamed.
    """
    component = claim.component
    if claim.parameter is None or "/" in component or hardware.has(component) or not is_of_joint(claim):
        return False
    return component not in hardware.joints or component in hardware.fixed
