"""UC166."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in

_FINGERS = """
    <link name="palm">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <link name="finger">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="flange" type="fixed"><parent link="fore"/><child link="palm"/></joint>
    <joint name="finger_joint" type="revolute">
      <parent link="palm"/><child link="finger"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/>
      %s
    </joint>
"""


@rule(
    "UC166",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointMimic() accepts any joint and any multiplier; the position is "
    "multiplier * position of the other joint + offset",
    bad=[
        {"robot.urdf": _FINGERS % '<mimic joint="«flange»"/>'},
        {"robot.urdf": _FINGERS % '<mimic joint="elbow" multiplier="«0»"/>'},
    ],
    good=[
        {"robot.urdf": _FINGERS % '<mimic joint="elbow" multiplier="-1"/>'},
    ],
)
def mimic_joint_stands_still(project: Project) -> Iterator[Finding]:
    """Joint mimics a fixed joint, or with a multiplier of 0.

    Nothing rejects it. But a mimic joint has no command of its own: if the joint that it follows is fixed, or if that
    position is multiplied by 0, it never moves.
    """
    robot = robot_in(project)
    fixed = {joint.name for joint in robot.joints if joint.name and joint.type == "fixed"} if robot else set()
    for joint in robot.joints if robot else ():
        mimic = joint.mimic
        if mimic is None or not joint.moves:
            continue
        name = label("joint", joint.name)
        if mimic.joint in fixed:
            yield Finding(mimic.at["joint"], f"{name} mimics joint '{mimic.joint}', which is fixed: it never moves")
        elif mimic.multiplier is not None and mimic.multiplier.value == 0:
            message = f"multiplier of the <mimic> of {name} is 0: it never moves"
            yield Finding(mimic.multiplier.at, message)
