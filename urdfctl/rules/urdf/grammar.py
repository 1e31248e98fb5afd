"""The elements and attributes of URDF that urdfdom reads, and the further ones that others read."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.parts import Tag
from urdfctl.model.robot import Robot
from urdfctl.rules.urdf.common import label

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
"""By the element that they stand in."""

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
"""By the element that they belong to."""

ONCE = {
    name: children
    for name, children in ELEMENTS.items()
    if name in ("inertial", "visual", "collision", "joint", "material")
} | {"link": ("inertial",)}
"""Children of which only the first is read, by their parent; of <geometry> only the first child whatsoever."""


def read_tags(robot: Robot) -> Iterator[tuple[Tag, str]]:
    """The elements of links, joints and materials that are read, each with the name of the link or joint it is of."""
    for top in (*(link.tag for link in robot.links), *(joint.tag for joint in robot.joints)):
        owner = label(top.name, top.attributes.get("name"))
        for tag in _below(top):
            yield tag, owner
    for tag in robot.others:
        if tag.name == "material":
            for inner in _below(tag):
                yield inner, f"material '{tag.attributes.get('name', '')}'"


def _below(tag: Tag) -> Iterator[Tag]:
    yield tag
    known = ELEMENTS.get(tag.name, ())
    for child in tag.children if known else ():
        if child.name in known:
            yield from _below(child)
