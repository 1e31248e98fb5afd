"""UC125."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.limited_joints import held_by
from urdfctl.model.robot import Number
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.written import at_value


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

    urdfdom accepts it. Gazebo swaps the two limits. Elsewhere, no position is within them and the joint does not move. This
    is an error if gazebo_ros_control runs the joint, which takes each commanded position for the upper limit.
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
        edits = _swapped(limit.lower, limit.upper, project)
        default = "" if limit.lower and limit.upper else " (a missing limit is 0)"
        message = f"'lower' of {label('joint', joint.name)} is {lower:g}, but 'upper' is {upper:g}{default}"
        fix = Fix("swap 'lower' and 'upper'", edits) if edits else None
        severity = Severity.ERROR if held_by(project, joint.name, "reversed") else None
        finding = at_value(project, limit.lower.at, message, fix=fix, severity=severity) if limit.lower else None
        yield finding if finding and finding.notes else Finding(limit.at, message, fix=fix, severity=severity)


def _swapped(lower: Number | None, upper: Number | None, project: Project) -> tuple[Edit, ...]:
    """Swap two limits where they are written; nothing where one is calculated."""
    if lower is None or upper is None:
        return ()
    low, high = project.origin(lower.at).span, project.origin(upper.at).span
    if (low.text, high.text) != (lower.text, upper.text):
        return ()
    return Edit(low, upper.text), Edit(high, lower.text)
