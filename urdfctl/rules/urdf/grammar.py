"""The URDF elements and attributes that urdfdom reads, and those that other tools read."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Robot, Tag
from urdfctl.rules.common import label
from urdfctl.startup.per_object import once_for_the_last
from urdfctl.startup.records import NamedTuple

ELEMENTS = {
    "robot": ("link", "joint", "material", "transmission", "gazebo", "ros2_control"),
    "link": ("inertial", "visual", "collision"),
    "inertial": ("origin", "mass", "inertia"),
    "visual": ("origin", "geometry", "material"),
    "collision": ("origin", "geometry"),
    "geometry": ("box", "cylinder", "sphere", "mesh"),
    "material": ("color", "texture"),
    "joint": (
        "origin",
        "parent",
        "child",
        "axis",
        "limit",
        "safety_controller",
        "calibration",
        "mimic",
        "dynamics",
    ),
}
"""Known child elements, by parent element."""

ATTRIBUTES = {
    "link": ("name",),
    "joint": ("name", "type"),
    "origin": ("xyz", "rpy"),
    "axis": ("xyz",),
    "parent": ("link",),
    "child": ("link",),
    "mass": ("value",),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "box": ("size",),
    "cylinder": ("length", "radius"),
    "sphere": ("radius",),
    "mesh": ("filename", "scale"),
    "color": ("rgba",),
    "texture": ("filename",),
    "material": ("name",),
    "limit": ("lower", "upper", "effort", "velocity"),
    "safety_controller": ("k_velocity", "k_position", "soft_lower_limit", "soft_upper_limit"),
    "calibration": ("rising", "falling", "reference_position"),
    "mimic": ("joint", "multiplier", "offset"),
    "dynamics": ("damping", "friction"),
}
"""Known attributes, by element."""

ONCE = {
    name: children
    for name, children in ELEMENTS.items()
    if name in ("inertial", "visual", "collision", "joint", "material")
} | {"link": ("inertial",)}
"""Children of which only the first is read, by parent element. Of <geometry>, only the first child is read."""


class ReadTag(NamedTuple):
    """An element that is read."""

    tag: Tag
    """The element."""
    children: tuple[Tag, ...]
    """Its child elements, known or not."""
    owner: str
    """The link, joint or material it belongs to, as messages name it."""


@once_for_the_last
def read_tags(robot: Robot) -> tuple[ReadTag, ...]:
    """Return the elements that are read in links, joints and materials."""
    return tuple(_walk(robot))


def _walk(robot: Robot) -> Iterator[ReadTag]:
    tops = [link.tag for link in robot.links] + [joint.tag for joint in robot.joints]
    tops += [tag for tag in robot.others if tag.name == "material"]
    for top in tops:
        owner = label(top.name, top.attributes.get("name"))
        pending = [top]
        while pending:
            tag = pending.pop()
            known = ELEMENTS.get(tag.name, ())
            yield ReadTag(tag, tag.children, owner)
            pending += [child for child in reversed(tag.children) if child.name in known]
