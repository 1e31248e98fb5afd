"""Robots that the generators are tried on."""

from __future__ import annotations


def solid(name: str, mass: float, shape: str, at: str = "0 0 0", size: float = 0.1) -> str:
    """A link with a shape; its inertia is that of a ball of some size."""
    moment = 0.4 * mass * size * size
    place = f'<origin xyz="{at}"/>'
    body = f"<geometry>{shape}</geometry>" if shape else ""
    seen = "".join(f"<{role}>{place}{body}</{role}>" for role in ("visual", "collision")) if shape else ""
    return (
        f'<link name="{name}"><inertial>{place}<mass value="{mass}"/><inertia ixx="{moment}" ixy="0" ixz="0" '
        f'iyy="{moment}" iyz="0" izz="{moment}"/></inertial>{seen}</link>'
    )


def joint(
    name: str, parent: str, child: str, at: str, axis: str = "0 1 0", kind: str = "revolute", more: str = ""
) -> str:
    """A joint with limits."""
    limit = {
        "revolute": '<limit lower="-1.5" upper="1.5" effort="60" velocity="3"/>',
        "continuous": '<limit effort="20" velocity="12"/>',
        "prismatic": '<limit lower="0" upper="0.04" effort="20" velocity="0.2"/>',
        "fixed": "",
    }[kind]
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{at}"/>'
        f'<axis xyz="{axis}"/>{limit}{more}</joint>'
    )


def arm(base: str, at: str) -> str:
    """Three joints."""
    return (
        joint("shoulder_pan", base, "shoulder", at, "0 0 1")
        + solid("shoulder", 2, "", "0 0 0.1")
        + joint("shoulder_lift", "shoulder", "upper_arm", "0 0 0.2")
        + solid("upper_arm", 2, "", "0 0 0.15")
        + joint("elbow", "upper_arm", "forearm", "0 0 0.3")
        + solid("forearm", 1, "", "0 0 0.15")
    )


def hand() -> str:
    """Two fingers, of which one mimics the other."""
    mimic = '<mimic joint="finger_joint"/>'
    return (
        joint("finger_joint", "forearm", "finger", "0 0.01 0.3", kind="prismatic")
        + solid("finger", 0.05, "", size=0.02)
        + joint("finger_2_joint", "forearm", "finger_2", "0 -0.01 0.3", "0 -1 0", "prismatic", mimic)
        + solid("finger_2", 0.05, "", size=0.02)
    )


def chassis(length: float = 0.5, mass: float = 12) -> str:
    """A base link without mass, and a box."""
    box = f'<box size="{length} 0.3 0.1"/>'
    link = '<link name="base_link"/>' + joint("base_joint", "base_link", "chassis", "0 0 0", kind="fixed")
    return link + solid("chassis", mass, box, size=0.3)


def wheel(name: str, x: float, y: float, parent: str = "chassis", z: float = -0.05) -> str:
    """A wheel with a radius of 0.1 m."""
    shape = '<sphere radius="0.1"/>'
    return joint(f"{name}_joint", parent, name, f"{x} {y} {z}", kind="continuous") + solid(name, 1, shape)


def ball(name: str, x: float) -> str:
    """A ball that slides, for balance."""
    shape = '<sphere radius="0.05"/>'
    slides = f'<gazebo reference="{name}"><mu1>0.0</mu1><mu2>0.0</mu2></gazebo>'
    return joint(f"{name}_joint", "chassis", name, f"{x} 0 -0.1", kind="fixed") + solid(name, 0.1, shape) + slides


FOUR = tuple(
    (f"{end}_{side}_wheel", x, y)
    for end, x in (("front", 0.2), ("rear", -0.2))
    for side, y in (("left", 0.2), ("right", -0.2))
)
LEGS = tuple((f"{end}{side}", x, y) for end, x in (("f", 0.2), ("h", -0.2)) for side, y in (("l", 0.15), ("r", -0.15)))
DIFF = chassis() + wheel("left_wheel", 0, 0.2) + wheel("right_wheel", 0, -0.2) + ball("front", 0.2) + ball("rear", -0.2)


def car() -> str:
    """Two driven wheels, and two that are steered."""
    text = chassis() + wheel("rear_left_wheel", -0.2, 0.2) + wheel("rear_right_wheel", -0.2, -0.2)
    for side, y in (("left", 0.2), ("right", -0.2)):
        text += joint(f"{side}_steering_joint", "chassis", f"{side}_knuckle", f"0.2 {y} -0.05", "0 0 1")
        text += solid(f"{side}_knuckle", 0.5, "", size=0.05) + wheel(f"front_{side}_wheel", 0, 0, f"{side}_knuckle", 0)
    return text


def legs() -> str:
    """Four legs with three joints each."""
    text = chassis(mass=5)
    for name, x, y in LEGS:
        text += joint(f"{name}_hip", "chassis", f"{name}_hip_link", f"{x} {y} 0", "1 0 0")
        text += solid(f"{name}_hip_link", 0.4, "", size=0.05)
        text += joint(f"{name}_thigh", f"{name}_hip_link", f"{name}_thigh_link", "0 0 0")
        text += solid(f"{name}_thigh_link", 0.4, "", "0 0 -0.1", size=0.05)
        text += joint(f"{name}_calf", f"{name}_thigh_link", f"{name}_calf_link", "0 0 -0.2")
        text += solid(f"{name}_calf_link", 0.2, '<sphere radius="0.02"/>', "0 0 -0.2", size=0.05)
    return text


POST = (
    '<link name="base_link"/>' + joint("base_joint", "base_link", "post", "0 0 0", kind="fixed") + solid("post", 5, "")
)
ROBOTS = {
    "arm": POST + arm("post", "0 0 0.1"),
    "arm and gripper": POST + arm("post", "0 0 0.1") + hand(),
    "diff": DIFF,
    "skid": chassis() + "".join(wheel(*one) for one in FOUR),
    "ackermann": car(),
    "mecanum": chassis() + "".join(wheel(*one) for one in FOUR).replace("_wheel", "_mecanum"),
    "quadruped": legs(),
    "mobile manipulator": DIFF + arm("chassis", "0 0 0.05"),
    "sensors": POST + joint("mount", "post", "imu_link", "0 0 0.1", kind="fixed") + solid("imu_link", 0.1, ""),
}
