"""UC118."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Mimic
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, robot_in


@rule(
    "UC118",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/joint.cpp parseJointMimic() takes any name, the joint's own too",
    whole_robot=True,
    bad={
        "robot.urdf": """
            <link name="finger"/>
            <joint name="finger_joint" type="prismatic">
              <parent link="fore"/><child link="finger"/>
              <limit lower="0" upper="0.1" effort="1" velocity="1"/>
              <mimic joint="«finger_joint»"/>
            </joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="finger">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
            </link>
            <joint name="finger_joint" type="prismatic">
              <parent link="fore"/><child link="finger"/>
              <limit lower="0" upper="0.1" effort="1" velocity="1"/>
              <mimic joint="elbow"/>
            </joint>
        """,
    },
)
def mimics_in_a_circle(project: Project) -> Iterator[Finding]:
    """A joint mimics itself, directly or by way of others.

    Nothing leads such joints: joint_state_publisher and controllers find no value for them.
    """
    robot = robot_in(project)
    if robot is None:
        return
    leaders = {joint.name: joint.mimic for joint in robot.joints if joint.name and joint.mimic}
    done: set[str] = set()
    for name in leaders:
        way: dict[str, Mimic] = {}
        step = name
        while step in leaders and step not in way and step not in done:
            way[step] = leaders[step]
            step = way[step].joint or ""
        if step in way:
            circle = list(way)[list(way).index(step) :]
            told = "itself" if len(circle) == 1 else f"itself by way of {in_words(circle[1:])}"
            yield Finding(way[step].at["joint"], f"joint '{step}' mimics {told}")
        done.update(way)
