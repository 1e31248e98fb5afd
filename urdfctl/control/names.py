"""What a claim names that is no joint of the robot, or none that moves: a fault of the name, not of the interface."""

from __future__ import annotations

from urdfctl.control.claims import Claim
from urdfctl.control.hardware import Hardware

_OF_JOINTS = ("position", "velocity", "acceleration", "effort")
_OF_JOINTS_IN_ROS1 = ("JointInterface", "JointStateInterface")


def is_of_joint(claim: Claim) -> bool:
    """Whether a claim is one of a joint, by its interface."""
    return claim.interface in _OF_JOINTS or claim.interface.endswith(_OF_JOINTS_IN_ROS1)


def is_misnamed(claim: Claim, hardware: Hardware) -> bool:
    """Whether a parameter names a joint that neither the robot nor its hardware has, or one that does not move. Names
    with a slash are those of other controllers' interfaces."""
    component = claim.component
    if claim.parameter is None or "/" in component or hardware.has(component) or not is_of_joint(claim):
        return False
    return component not in hardware.joints or component in hardware.fixed
