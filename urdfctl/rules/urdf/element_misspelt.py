"""UC154."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Tag
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import respelt, robot_in
from urdfctl.rules.urdf.grammar import ELEMENTS, read_tags

OF_OTHERS = frozenset({"joints", "links"})
"""Elements of other readers of URDF that resemble one of urdfdom's in spelling only."""


@rule(
    "UC154",
    severity=Severity.WARNING,
    runtime="ignores",
    authority='urdfdom urdf_parser: FirstChildElement("...") by exact name; unknown elements are silently ignored',
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  «<colision>»<geometry><sphere radius="0.1"/></geometry></colision>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": '«<linkk name="tool"/>»',
        },
        {
            "robot.urdf": """
                «<joimt name="wrist"/>»
                «<mateiral name="grey"/>»
                «<transmision name="drive"/>»
                «<gazbo/>»
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": '«<ros2_controll name="arm" type="system"/>»',
        },
        {
            "robot.urdf": """
                <material name="grey">«<colour rgba="0.5 0.5 0.5 1"/>»«<textur filename="grey.png"/>»</material>
                <link name="tool">
                  «<inertail/>»
                  <inertial>
                    «<orgin xyz="0 0 0"/>»
                    «<mas value="1"/>»
                    «<inerta ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>»
                  </inertial>
                  «<visaul/>»
                  <visual>
                    «<orgin xyz="0 0 0"/>»
                    «<geometri>»<sphere radius="0.1"/></geometri>
                    «<materiel name="grey"/>»
                  </visual>
                  <collision>
                    «<orgin xyz="0 0 0"/>»
                    «<geometri>»<sphere radius="0.1"/></geometri>
                  </collision>
                </link>
                <joint name="wrist" type="revolute">
                  «<orgin xyz="0 0 1"/>»
                  «<parnet link="fore"/>»
                  «<chlid link="tool"/>»
                  «<axiss xyz="0 0 1"/>»
                  «<limits lower="-1" upper="1" effort="10" velocity="2"/>»
                  «<safety_controler k_velocity="1"/>»
                  «<calibraton rising="0"/>»
                  «<mimick joint="elbow"/>»
                  «<dynamic damping="1"/>»
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <collision><geometry><sphere radius="0.1"/></geometry></collision>
                  <contact><friction_anchor/></contact>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <sensor name="camera"/>
                <joints/>
                <links/>
                <linkage/>
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <collision><geometry><sphere radius="0.1"/></geometry></collision>
                  <self_collision_checking/>
                  <contact_coefficients/>
                  <contacts/>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def element_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt element.

    urdfdom silently ignores unknown elements, so the part is missing. If the only `<ros2_control>` is misspelt, ROS 2's
    controller manager rejects the description.
    """
    robot = robot_in(project)
    if robot is None:
        return
    for tag in robot.others:
        for meant in _meant(tag, "robot"):
            lost = meant == "ros2_control" and not robot.ros2_controls and set(project.distros) <= set(ROS2)
            severity = Severity.ERROR if lost else Severity.WARNING
            message = f"<{tag.name}> of the robot is ignored; did you mean <{meant}>?"
            yield Finding(tag.at, message, fix=respelt(tag, meant), severity=severity)
    for tag, children, owner in read_tags(robot):
        for child in children if tag.name != "geometry" else ():
            for meant in _meant(child, tag.name):
                message = f"<{child.name}> of {owner} is ignored; did you mean <{meant}>?"
                yield Finding(child.at, message, fix=respelt(child, meant))


def _meant(tag: Tag, parent: str) -> tuple[str, ...]:
    """The element that an unknown one most likely misspells; empty if it may be intended."""
    known = ELEMENTS.get(parent, ())
    if tag.name in known or tag.name in OF_OTHERS or ":" in tag.name:
        return ()
    meant = nearest(tag.name, known)
    return (meant,) if meant else ()
