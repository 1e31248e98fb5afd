"""What a migration must not change of a robot: links, joints, origins, axes, limits and inertials."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from urdfctl.model.robot import Robot, Tag
from urdfctl.source.opaque import UNKNOWN

_OF_LINK = ("inertial", "collision")
_OF_JOINT = ("origin", "axis", "limit", "parent", "child")


def kinematics(robot: Robot) -> dict[str, object]:
    """Return the kinematic content of each link and joint, by `link NAME` and `joint NAME`, comparable by equality:
    one for each element with the name."""
    found: dict[str, list[object]] = {}
    for link in robot.links:
        content = [_content(tag) for name in _OF_LINK for tag in link.tag.named(name)]
        found.setdefault(f"link {link.name}", []).append(content)
    for joint in robot.joints:
        content = [_content(tag) for name in _OF_JOINT for tag in joint.tag.named(name)]
        found.setdefault(f"joint {joint.name}", []).append((joint.type, content))
    return dict(found)


def commanded_twice(robot: Robot) -> frozenset[str]:
    """Return the joints that have commands in several places of `<ros2_control>`: a resource manager rejects these.

    Names that are not known, in macros that nothing calls, may be those of different joints.
    """
    joints = (part for component in robot.ros2_controls for part in component.of_kind("joint"))
    counts = Counter(part.name for part in joints if part.commands and part.name and UNKNOWN not in part.name)
    return frozenset(name for name, count in counts.items() if count > 1)


def differences(before: Mapping[str, object], after: Mapping[str, object]) -> Iterator[str]:
    """Yield the names of links and joints that were added, removed or changed, with their kind."""
    for name in {**before, **after}:
        if before.get(name) != after.get(name):
            yield name


def _content(tag: Tag) -> tuple[str, object, object]:
    return tag.name, sorted(tag.attributes.items()), [_content(child) for child in tag.children]
