"""Helpers for the rules on MoveIt's configuration: the planning groups of the whole robot, and the names in an SRDF."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.groups import Groups
from urdfctl.model.controllers import Key, MoveItController
from urdfctl.model.moveit import Semantic
from urdfctl.rule import Project
from urdfctl.rules.common import is_known, whole_robot_in
from urdfctl.startup.per_object import once_for_the_last


@once_for_the_last
def planning(project: Project) -> Groups | None:
    """Return the planning groups of a robot; None if the robot or its SRDF is not completely known."""
    robot, semantic = whole_robot_in(project), project.moveit.semantic if project.moveit else None
    if robot is None or semantic is None or not project.complete or project.library or not semantic.complete:
        return None
    return Groups(robot, semantic)


@once_for_the_last
def is_of_other_robot(project: Project) -> bool:
    """Return whether most links and joints that the SRDF names are unknown: it is for another robot."""
    groups = planning(project)
    if groups is None:
        return False
    named = {key.text for _, key in (*links_in(groups.semantic), *joints_in(groups.semantic)) if is_known(key.text)}
    known = groups.links | set(groups.joints) | set(groups.virtual)
    return len(named - known) * 2 > len(named)


def real_controllers(project: Project) -> tuple[MoveItController, ...]:
    """Return the controllers that MoveIt sends trajectories to, without those of ROS 1's fake controller manager."""
    controllers = project.moveit.controllers if project.moveit else ()
    return tuple(one for one in controllers if not one.name.text.startswith("fake_") and not _is_in_fake_file(one))


def _is_in_fake_file(controller: MoveItController) -> bool:
    return "fake" in controller.name.at.source.path.replace("\\", "/").rpartition("/")[2]


def links_in(semantic: Semantic) -> Iterator[tuple[str, Key]]:
    """Yield the links that MoveIt needs, each with what names it; not those of allowed collisions."""
    for group in semantic.groups:
        for link in group.links:
            yield f"group '{group.name.text}'", link
        for chain in group.chains:
            for end in (chain.base, chain.tip):
                if end is not None:
                    yield f"the chain of group '{group.name.text}'", end
    for effector in semantic.effectors:
        if effector.parent_link is not None:
            yield f"end effector '{effector.name}'", effector.parent_link
    for virtual in semantic.virtual:
        if virtual.child is not None:
            yield f"virtual joint '{virtual.name.text if virtual.name else ''}'", virtual.child


def joints_in(semantic: Semantic) -> Iterator[tuple[str, Key]]:
    """Yield the joints that MoveIt needs, each with what names it."""
    for group in semantic.groups:
        for joint in group.joints:
            yield f"group '{group.name.text}'", joint
    for state in semantic.states:
        for joint in state.joints:
            yield f"state '{state.name}'", joint
    for joint in semantic.passive:
        yield "<passive_joint>", joint
