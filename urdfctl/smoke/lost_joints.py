"""The joints that Gazebo drops with a link of the robot, and the controllers that stop without them.

gz_ros2_control and gazebo_ros2_control skip a joint that is not in the model; gazebo_ros_control does not start if a
joint of a transmission is not there (default_robot_hw_sim.cpp).
"""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.control.session import Configured
from urdfctl.diagnostic import Diagnostic
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.rules.urdf.bodies import vanishing
from urdfctl.rules.urdf.tree import Tree
from urdfctl.smoke.stages import loses_joints


def lost_joints(error: Diagnostic, project: Project) -> frozenset[str]:
    """Return the names of the joints that Gazebo drops because of an error of lint.

    None are returned if the error is about something else, or if no moving joint is left: the robot is lost then.
    """
    robot = project.robot
    if robot is None or not loses_joints(error):
        return frozenset()
    lost = _dropped(error, robot)
    left = (joint.name for joint in robot.joints if joint.moves)
    return lost if any(name not in lost for name in left) else frozenset()


def _dropped(error: Diagnostic, robot: Robot) -> frozenset[str]:
    """The joints of the links that an error names, and of all links below them."""
    tree = Tree(robot)
    named = (body for body in vanishing(robot) if any(f"'{link.name}'" in error.message for link in body.links))
    links = {name for body in named for name in tree.below(body.head.name or "")}
    joints = (tree.parents[name] for name in links if name in tree.parents)
    return frozenset(joint.name for joint in joints if joint.name)


def stops_every_controller(error: Diagnostic, project: Project) -> bool:
    """Return whether gazebo_ros_control does not start, because a transmission has a joint that is dropped."""
    lost, robot = lost_joints(error, project), project.robot
    transmissions = robot.transmissions if robot else ()
    return any(joint.name in lost for transmission in transmissions for joint in transmission.kept_joints)


def without_their_joints(error: Diagnostic, project: Project, everyone: Sequence[Configured]) -> list[Configured]:
    """Return the controllers that claim a joint which is dropped."""
    lost = lost_joints(error, project)

    def needs_one(each: Configured) -> bool:
        claims = (*each.claims.command, *each.claims.state)
        return any(claim.component in lost and not claim.best_effort for claim in claims)

    return [each for each in everyone if needs_one(each)]
