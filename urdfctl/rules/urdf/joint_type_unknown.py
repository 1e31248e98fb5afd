"""UC121."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import enumerated, is_only_slip, nearest
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known, label, replaced, robot_in

TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
OTHER_WORDS = {
    "rotational": "revolute",
    "rotary": "revolute",
    "hinge": "revolute",
    "linear": "prismatic",
    "slider": "prismatic",
}


@rule(
    "UC121",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJoint(): 'Joint [...] has no known type [...]'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="«Revolute»">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1" upper="1" effort="10" velocity="2"/>
                </joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="a"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="a_joint" type="«rotational»"><parent link="fore"/><child link="a"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="b"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="b_joint" type="«rotary»"><parent link="fore"/><child link="b"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="c"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="c_joint" type="«hinge»"><parent link="fore"/><child link="c"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="d"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="d_joint" type="«linear»"><parent link="fore"/><child link="d"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="e"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="e_joint" type="«Slider»"><parent link="fore"/><child link="e"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="f"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="f_joint" type="«continous»"><parent link="fore"/><child link="f"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="g"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="g_joint" type="«ball»"><parent link="fore"/><child link="g"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="h"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="h_joint" type="«prismtic»"><parent link="fore"/><child link="h"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="i"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="i_joint" type="«floatng»"><parent link="fore"/><child link="i"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="j"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="j_joint" type="«plannar»"><parent link="fore"/><child link="j"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="k"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="k_joint" type="«fixd»"><parent link="fore"/><child link="k"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
                <link name="l"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                <joint name="l_joint" type="«»"><parent link="fore"/><child link="l"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1" upper="1" effort="10" velocity="2"/>
                </joint>
            """,
        },
    ],
)
def joint_type_unknown(project: Project) -> Iterator[Finding]:
    """Unknown joint type.

    urdfdom knows revolute, continuous, prismatic, fixed, floating and planar, in lower case. It rejects the whole robot
    for any other type.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        written = joint.type
        if written is None or written in TYPES or not is_known(written):
            continue
        meant = OTHER_WORDS.get(written.strip().lower()) or nearest(written.strip(), (*TYPES, ""))
        if written.strip().lower() in TYPES:
            meant = written.strip().lower()
        hint = f"did you mean '{meant}'?" if meant else f"use {enumerated(TYPES, 'or')}"
        fix: Fix | None = None
        if meant:
            fix = replaced(
                joint.at["type"],
                written,
                meant,
                safe=written.strip().lower() == meant or is_only_slip(written.strip(), meant, TYPES),
            )
        yield Finding(joint.at["type"], f"{label('joint', joint.name)} has unknown type '{written}'; {hint}", fix=fix)
