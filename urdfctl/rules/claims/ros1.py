"""What the rules on ROS 1 share: how sure it is that Gazebo's default simulation makes the hardware, and of what."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.control.hardware import Kind
from urdfctl.control.hardware_ros1 import PREFIX
from urdfctl.control.session import Configured, Missing, Session
from urdfctl.rule import Project, Severity
from urdfctl.rules.claims.common import missing_of, severity_of
from urdfctl.rules.transmissions.common import in_gazebo
from urdfctl.rules.transmissions.facts import GAZEBO_INTERFACES


def mended_severity(project: Project, session: Session, one: Configured) -> Severity | None:
    """How bad it is what Gazebo's default simulation does not offer; None where it does not run the robot."""
    gazebo = in_gazebo(project)
    if gazebo is None:
        return None
    return min(gazebo, severity_of(session, one, ()), key=lambda severity: severity.weight)


def unregistered(session: Session, one: Configured) -> Iterable[Missing]:
    """The joints that a controller asks for in an interface of Gazebo's simulation that they are not in."""
    found = (*missing_of(session, one, Kind.COMMAND), *missing_of(session, one, Kind.STATE))
    return (each for each in found if _is_of_gazebo(each.claim.interface))


def _is_of_gazebo(interface: str) -> bool:
    return interface.startswith(PREFIX) and interface.removeprefix(PREFIX) in (
        *GAZEBO_INTERFACES,
        "JointStateInterface",
    )


def bare(interface: str) -> str:
    """The name of a hardware interface without its package."""
    return interface.rpartition("/")[2]
