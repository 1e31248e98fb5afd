"""UC125."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC125",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/joint.cpp parseJointLimits() does not compare them; sdformat src/parser_urdf.cc: "
    "'revolute joint [...] with limits: lowStop[..] > highStop[..], switching the two.'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  «<limit lower="1" upper="-1" effort="10" velocity="2"/>»
                </joint>
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
def limits_reversed(project: Project) -> Iterator[Finding]:
    """Lower joint limit above upper limit.

    urdfdom accepts it. Gazebo swaps the two limits. Elsewhere, no position is within them and the joint does not move.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        limit = joint.limit
        if limit is None or joint.type not in ("revolute", "prismatic"):
            continue
        lower = 0.0 if limit.lower is None else limit.lower.value
        upper = 0.0 if limit.upper is None else limit.upper.value
        if lower is None or upper is None or lower <= upper:
            continue
        edits: tuple[Edit, ...] = ()
        if (
            limit.lower
            and limit.upper
            and (limit.lower.at.span.text, limit.upper.at.span.text)
            == (
                limit.lower.text,
                limit.upper.text,
            )
        ):
            edits = Edit(limit.lower.at.span, limit.upper.text), Edit(limit.upper.at.span, limit.lower.text)
        default = "" if limit.lower and limit.upper else " (a missing limit is 0)"
        message = f"'lower' of {label('joint', joint.name)} is {lower:g}, but 'upper' is {upper:g}{default}"
        yield Finding(limit.at, message, fix=Fix("swap 'lower' and 'upper'", edits) if edits else None)
