"""UC121."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import enumerated, nearest
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
    bad={
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
    good={
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
            fix = replaced(joint.at["type"], written, meant, safe=written.strip().lower() == meant)
        yield Finding(joint.at["type"], f"{label('joint', joint.name)} has unknown type '{written}'; {hint}", fix=fix)
