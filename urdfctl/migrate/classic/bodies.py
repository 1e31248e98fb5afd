"""The link whose pose a plugin of Gazebo Classic publishes: gz publishes that of the model only."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.migrate.edits.places import key_of, key_of_element
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.model.robot import Joint, Robot
from urdfctl.source.xml.dom import Element

OF_MODEL = "gz-sim OdometryPublisher.cc: worldPose(this->model.Entity(), _ecm)"
_NAMES = ("bodyName", "body_name")


def moving_body(packages: MigratedPackages, element: Element) -> str:
    """Return the link that a plugin names if it moves against the base of a robot; empty if it does not."""
    key = key_of_element(element)
    for loaded in packages.loaded():
        robot = loaded.project.robot
        for plugin in robot.plugins if robot else ():
            tags = [plugin.setting(name) for name in _NAMES] if key_of(plugin.at) == key else []
            for body in (tag.text.strip() for tag in tags if tag is not None and tag.text):
                if robot is not None and any(joint.moves for joint in _above(robot, body)):
                    return body
    return ""


def _above(robot: Robot, link: str) -> Iterator[Joint]:
    """The joints between a link and the root of its robot."""
    by_child = {joint.child.name: joint for joint in robot.joints if joint.child is not None}
    seen: set[str | None] = set()
    name: str | None = link
    while name is not None and name not in seen and (joint := by_child.get(name)) is not None:
        seen.add(name)
        yield joint
        name = joint.parent.name if joint.parent is not None else None
