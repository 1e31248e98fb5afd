"""What a migration must not change of a robot: links, joints, origins, axes, limits and inertials."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.model.robot import Robot, Tag

_OF_LINK = ("inertial", "collision")
_OF_JOINT = ("origin", "axis", "limit", "parent", "child")


def kinematics(robot: Robot) -> dict[str, object]:
    """Return the kinematic content of each link and joint, by `link NAME` and `joint NAME`, comparable by equality."""
    links = {
        f"link {link.name}": [_content(tag) for name in _OF_LINK for tag in link.tag.named(name)]
        for link in robot.links
    }
    joints = {
        f"joint {joint.name}": (joint.type, [_content(tag) for name in _OF_JOINT for tag in joint.tag.named(name)])
        for joint in robot.joints
    }
    return {**links, **joints}


def differences(before: Mapping[str, object], after: Mapping[str, object]) -> Iterator[str]:
    """Yield the names of links and joints that were added, removed or changed, with their kind."""
    for name in {**before, **after}:
        if before.get(name) != after.get(name):
            yield name


def _content(tag: Tag) -> tuple[str, object, object]:
    return tag.name, sorted(tag.attributes.items()), [_content(child) for child in tag.children]
