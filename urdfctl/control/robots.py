"""Return the robot that a project describes, and whether it is complete."""

from __future__ import annotations

import re

from urdfctl.model.project import Project
from urdfctl.model.robot import Robot, Tag
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_CUT_OUT = rb"<xacro:(?!if\b|unless\b|property\b|arg\b)"


def robot_in(project: Project) -> Robot | None:
    """Return the robot if the root element is <robot>, else None."""
    robot = project.robot
    return robot if robot is not None and robot.element == "robot" else None


def whole_robot_in(project: Project) -> Robot | None:
    """Return the robot if the file describes a whole one. None for a part that other xacro files include."""
    robot = robot_in(project)
    return None if robot is None or is_fragment(robot) else robot


def is_xacro(robot: Robot) -> bool:
    """Return whether the description was expanded by xacro."""
    return robot.at.source.is_xacro


def is_fragment(robot: Robot) -> bool:
    """Return whether a xacro file is only a part of a robot: fewer than two links, or attached to another one's."""
    if not is_xacro(robot):
        return False
    if len(robot.links) < 2:  # noqa: PLR2004
        return True
    return _leads_outward(robot) and (_is_rootless(robot) or robot.name is None)


def hangs_on_others(robot: Robot) -> bool:
    """Return whether a plain URDF has no root link of its own, and joints that lead to links of others."""
    return bool(robot.links) and not is_xacro(robot) and _is_rootless(robot) and _leads_outward(robot)


def _leads_outward(robot: Robot) -> bool:
    links = {link.name for link in robot.links}
    return any(joint.parent and joint.parent.name not in links for joint in robot.joints)


def _is_rootless(robot: Robot) -> bool:
    return {link.name for link in robot.links} <= {joint.child.name for joint in robot.joints if joint.child}


def is_whole(project: Project, at: Place) -> bool:
    """Return whether parts that an element lacks are really absent.

    They may exist if a failed expansion removed something from it, or if it calls a macro of another file.
    """
    if at.closing is None or (project.complete and not project.library):
        return True
    return not re.search(_CUT_OUT if project.library else b"<xacro:", at.source.data[at.start : at.closing])


def is_all_there(project: Project, tag: Tag) -> bool:
    """Return whether all children of an element are known, so that a missing one is really absent."""
    return is_whole(project, tag.at) and not any(child.name == UNKNOWN for child in tag.children)
