"""UC153."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Tag
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.urdf.grammar import ONCE, read_tags


@rule(
    "UC153",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfdom urdf_parser/src/joint.cpp, link.cpp: only FirstChildElement(...) is read",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  «<inertial>»<mass value="2"/></inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <material name="grey"><color rgba="0 0 0 1"/>«<color rgba="1 1 1 1"/>»<texture filename="a.png"/>«<texture filename="b.png"/>»</material>
                <link name="tool">
                  <inertial>
                    <origin xyz="0 0 0"/>«<origin xyz="0 0 1"/>»
                    <mass value="1"/>«<mass value="2"/>»
                    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>«<inertia ixx="1"/>»
                  </inertial>
                  <visual>
                    <origin xyz="0 0 0"/>«<origin xyz="0 0 1"/>»
                    <geometry><sphere radius="0.1"/>«<box size="1 1 1"/>»</geometry>
                    «<geometry>»<sphere radius="0.2"/></geometry>
                    <material name="grey"/>«<material name="blue"/>»
                  </visual>
                  <collision>
                    <origin xyz="0 0 0"/>«<origin xyz="0 0 1"/>»
                    <geometry><sphere radius="0.1"/></geometry>
                    «<geometry>»<sphere radius="0.2"/></geometry>
                  </collision>
                </link>
                <joint name="wrist" type="revolute">
                  <origin xyz="0 0 1"/>«<origin xyz="0 0 2"/>»
                  <parent link="fore"/>«<parent link="upper"/>»
                  <child link="tool"/>«<child link="fore"/>»
                  <axis xyz="0 0 1"/>«<axis xyz="0 1 0"/>»
                  <limit lower="-1" upper="1" effort="10" velocity="2"/>«<limit effort="5"/>»
                  <safety_controller k_velocity="1"/>«<safety_controller k_velocity="2"/>»
                  <calibration rising="0"/>«<calibration rising="1"/>»
                  <mimic joint="elbow"/>«<mimic joint="shoulder"/>»
                  <dynamics damping="1"/>«<dynamics damping="2"/>»
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual><geometry><sphere radius="0.1"/></geometry></visual>
                  <visual><geometry><sphere radius="0.2"/></geometry></visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def element_given_twice(project: Project) -> Iterator[Finding]:
    """Repeated element is ignored.

    urdfdom reads the first <inertial> of a link, the first <limit> of a joint, the first shape of a <geometry>, and so
    on. It silently ignores the others. A link may have several visuals and collisions.
    """
    robot = robot_in(project)
    for tag, children, owner in read_tags(robot) if robot else ():
        if tag.name == "geometry":
            for shape in children[1:]:
                message = f"<{shape.name}> in a <geometry> of {owner} is ignored; a <geometry> has one shape"
                yield Finding(shape.at, message, (Note(f"<{children[0].name}> is used", children[0].at),))
            continue
        once = ONCE.get(tag.name, ())
        first: dict[str, Tag] = {}
        for child in children if once else ():
            before = first.setdefault(child.name, child)
            if child.name in once and before is not child:
                message = f"<{child.name}> of {owner} is defined twice; the second one is ignored"
                yield Finding(child.at, message, (Note("this one is used", before.at),))
