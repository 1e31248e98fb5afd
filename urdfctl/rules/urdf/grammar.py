"""The elements and attributes of URDF that urdfdom reads, and the further ones that others read."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.memory import once_for_the_last
from urdfctl.model.parts import Tag
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.rules.common import label

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


class ReadTag(NamedTuple):
    """An element that is read, the elements in it, and the link, joint or material that it is of."""

    tag: Tag
    children: tuple[Tag, ...]
    owner: str


@once_for_the_last
def read_tags(robot: Robot) -> tuple[ReadTag, ...]:
    """The elements of links, joints and materials that are read."""
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
            children = tag.children if known else ()
            yield ReadTag(tag, children, owner)
            pending += [child for child in reversed(children) if child.name in known]
