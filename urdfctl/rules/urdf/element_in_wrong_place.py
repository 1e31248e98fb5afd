"""UC162."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.urdf.grammar import ATTRIBUTES, ELEMENTS, read_tags

_NAMES = frozenset(name for children in ELEMENTS.values() for name in children) - {
    "ros2_control",
    "transmission",
}
"""The elements that urdfdom or Gazebo reads somewhere. The last two have rules of their own."""
_UNUSED = frozenset({("collision", "material")})
"""What is often there, and whose loss changes nothing."""
_TOOL = """
    <link name="tool">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
      %s
    </link>
    <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/>%s</joint>
    %s
"""


@rule(
    "UC162",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfdom urdf_parser/src/link.cpp, joint.cpp, model.cpp: FirstChildElement() of the parent by exact name; all "
    "others are silently ignored",
    bad=[
        {"robot.urdf": _TOOL % ('«<joint name="x" type="fixed">»<parent link="tool"/></joint>', "", "")},
        {"robot.urdf": _TOOL % ("«<axis/>»<transmission/><ros2_control/>", "", "")},
        {
            "robot.urdf": _TOOL
            % (
                '«<mass value="2"/>»«<inertia ixx="1"/>»«<geometry>»<box size="1 1 1"/></geometry>«<limit effort="1"/>»',
                "«<visual>»<geometry/></visual>«<inertial/>»«<link/>»",
                '«<origin xyz="0 0 1"/>»«<visual/>»«<collision/>»«<limit effort="2"/>»«<axis xyz="0 0 1"/>»',
            )
        },
        {
            "robot.urdf": _TOOL
            % (
                "",
                '<axis xyz="0 0 1">«<origin xyz="0 0 1"/>»</axis><dynamics damping="1">«<limit effort="1"/>»</dynamics>',
                "",
            )
        },
        {"robot.urdf": _TOOL % ("«<gazebo>»<mu1>1</mu1></gazebo>", "«<gazebo>»<mu1>1</mu1></gazebo>", "")},
        {"robot.urdf": _TOOL % ("", '«<damping value="1"/>»«<effort>»5</effort>«<velocity>»5</velocity>', "")},
    ],
    good=[
        {
            "robot.urdf": _TOOL
            % (
                (
                    '<collision><geometry><sphere radius="0.1"/></geometry><material name="grey"/></collision>'
                    "<contact><lateral_friction/></contact>"
                ),
                '<dynamics damping="1"/>',
                "<sensor/>",
            )
        },
    ],
)
def element_in_wrong_place(project: Project) -> Iterator[Finding]:
    """Element stands where nothing reads it.

    urdfdom reads each element only as the child of certain others, and silently ignores it elsewhere: a <mass> outside
    of <inertial> gives no mass, a <joint> inside a <link> does not exist, an attribute written as an element has no
    effect.
    """
    robot = robot_in(project)
    if robot is None:
        return
    for tag in robot.others:
        if tag.name in _NAMES and tag.name not in ELEMENTS["robot"]:
            yield Finding(tag.at, f"<{tag.name}> directly in the robot is ignored{_belongs(tag.name)}")
    for tag, children, owner in read_tags(robot):
        if tag.name == "geometry":
            continue
        known = ELEMENTS.get(tag.name, ())
        for child in children:
            if child.name in known or (tag.name, child.name) in _UNUSED:
                continue
            where = f"in {owner}" if tag.name in ("link", "joint") else f"in <{tag.name}> of {owner}"
            if child.name in _NAMES:
                yield Finding(child.at, f"<{child.name}> {where} is ignored{_belongs(child.name)}")
            elif tag.name == "joint" and (holder := _holder(child.name)):
                message = f"<{child.name}> {where} is ignored; write it as an attribute of <{holder}>"
                yield Finding(child.at, message)


def _belongs(name: str) -> str:
    """Where an element belongs, in words."""
    parents = [parent for parent, children in ELEMENTS.items() if name in children]
    if parents == ["robot"]:
        return "; it belongs directly into the robot"
    return f"; it belongs into <{'> or <'.join(parents)}>" if parents and len(parents) <= 2 else ""  # noqa: PLR2004


def _holder(name: str) -> str:
    """The child of a joint that has an attribute of a name; empty if there is none, or several have it."""
    holders = [
        child for child in ELEMENTS["joint"] if name in ATTRIBUTES.get(child, ()) and child not in ("mimic", "origin")
    ]
    return holders[0] if len(holders) == 1 else ""
