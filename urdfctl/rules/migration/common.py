"""What the rules on moving on share: what is old in the distro at hand, and what the next ones lack."""

from __future__ import annotations

from collections.abc import Collection

from urdfctl.catalog.distros import MAINTAINED, ROS2, coming
from urdfctl.rule import Project, Severity


def severity_of_old(project: Project, old_in: Collection[str]) -> Severity | None:
    """How much it matters that something is old in some distros: a warning where one of them is named, information
    where none is named and it is so in all that are maintained; None where it does not matter."""
    if project.distro is not None:
        return Severity.WARNING if project.distro in old_in else None
    judged = set(MAINTAINED) & set(project.distros)
    return Severity.INFO if judged and judged <= set(old_in) else None


def lacking(project: Project, there: tuple[str, ...]) -> str | None:
    """The first of the coming distros that lacks what is in some others, and in the one that is named."""
    if project.distro not in ROS2 or project.distro not in there:
        return None
    return next((distro for distro in coming(project.distro) if distro not in there), None)
