"""UC118."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Mimic
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, robot_in


@rule(
    "UC118",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/joint.cpp parseJointMimic() accepts any name, even the joint's own",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="finger"/>
                <joint name="finger_joint" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="-1" upper="1" effort="1" velocity="1"/>
                  <mimic joint="«finger_joint»"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="finger">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="finger_joint" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="-1" upper="1" effort="1" velocity="1"/>
                  <mimic joint="elbow"/>
                </joint>
            """,
        },
    ],
)
def mimics_in_a_circle(project: Project) -> Iterator[Finding]:
    """Joint mimics itself, directly or through others.

    No joint leads the others, so joint_state_publisher and controllers find no value for them.
    """
    robot = robot_in(project)
    if robot is None:
        return
    leaders = {joint.name: joint.mimic for joint in robot.joints if joint.name and joint.mimic}
    done: set[str] = set()
    for name in leaders:
        path: dict[str, Mimic] = {}
        step = name
        while step in leaders and step not in path and step not in done:
            path[step] = leaders[step]
            step = path[step].joint or ""
        if step in path:
            loop = list(path)[list(path).index(step) :]
            through = "" if len(loop) == 1 else f" through {in_words(loop[1:])}"
            yield Finding(path[step].at["joint"], f"joint '{step}' mimics itself{through}")
        done.update(path)
