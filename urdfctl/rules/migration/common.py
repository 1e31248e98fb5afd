"""Helpers for the rules on migration: what is deprecated in this distro, and what later distros lack."""

from __future__ import annotations

import re
from collections.abc import Collection

from urdfctl.catalog.distros import MAINTAINED, ROS2, coming
from urdfctl.rule import Project, Severity
from urdfctl.source.span import Place

_COMMENT = rb"(?s)<!--.*?-->"
_CONDITION = rb"<xacro:(?:if|unless)\b"


def severity_of_old(project: Project, old_in: Collection[str]) -> Severity | None:
    """Return the severity for a use of something that is deprecated in the distros `old_in`.

    A warning if the project's distro is one of them. Info if the distro is unknown and all maintained distros are among
    them. None otherwise.
    """
    if project.distro is not None:
        return Severity.WARNING if project.distro in old_in else None
    judged = set(MAINTAINED) & set(project.distros)
    return Severity.INFO if judged and judged <= set(old_in) else None


def lacking(project: Project, there: tuple[str, ...]) -> str | None:
    """Return the first later distro that lacks something. None if the project's distro is unknown or lacks it too."""
    if project.distro not in ROS2 or project.distro not in there:
        return None
    return next((distro for distro in coming(project.distro) if distro not in there), None)


def is_chosen(at: Place, right: str) -> bool:
    """Return whether conditions choose between an old name and the right one: its file has both."""
    data = re.sub(_COMMENT, b"", at.source.data)
    there = re.search(rb"[>\"']\s*%b\s*[<\"']" % re.escape(right.encode()), data)
    return at.source.is_xacro and there is not None and re.search(_CONDITION, data) is not None
