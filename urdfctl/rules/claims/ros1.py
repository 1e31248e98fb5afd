"""Helpers shared by the rules on ROS 1: whether Gazebo's default simulation is the hardware, and what it lacks."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.control.hardware.gazebo_ros1 import GAZEBO_INTERFACES, in_gazebo
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.hardware.ros1 import PREFIX
from urdfctl.control.session import Configured, MissingInterface, Session
from urdfctl.rule import Project, Severity
from urdfctl.rules.claims.common import missing_of, severity_of

_EFFORT = "EffortJointInterface"


def mended_severity(project: Project, session: Session, controller: Configured) -> Severity | None:
    """Return the severity of an interface that Gazebo's default simulation lacks; None if Gazebo is not used.

    Info for efforts on real hardware, whose driver usually offers what the transmissions name.
    """
    gazebo = in_gazebo(project)
    if gazebo is None:
        return Severity.INFO if _lacks_efforts(project, session, controller) else None
    return min(gazebo, severity_of(session, controller, ()), key=lambda severity: severity.weight)


def _lacks_efforts(project: Project, session: Session, controller: Configured) -> bool:
    """Whether a controller on real hardware needs efforts, and every transmission of the robot offers something else."""
    if project.simulator != "none":
        return False
    offered = {offer.interface for offers in session.hardware.command.values() for offer in offers}
    wanted = {each.claim.interface for each in unregistered(session, controller)}
    return bool(offered) and wanted == {f"{PREFIX}{_EFFORT}"} and not offered & wanted


def unregistered(session: Session, controller: Configured) -> Iterable[MissingInterface]:
    """Return a controller's claims to joints that are not registered with the claimed interface of Gazebo."""
    missing = (*missing_of(session, controller, ClaimKind.COMMAND), *missing_of(session, controller, ClaimKind.STATE))
    return (each for each in missing if _is_of_gazebo(each.claim.interface))


def _is_of_gazebo(interface: str) -> bool:
    return interface.startswith(PREFIX) and interface.removeprefix(PREFIX) in (
        *GAZEBO_INTERFACES,
        "JointStateInterface",
    )


def bare(interface: str) -> str:
    """Return the name of a hardware interface without its package."""
    return interface.rpartition("/")[2]
