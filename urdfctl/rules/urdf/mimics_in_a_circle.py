"""UC118."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.urdf.common import in_words, robot_in


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
    joints = {joint.name: joint for joint in robot.joints if joint.name}
    leaders = {name: joint.mimic.joint for name, joint in joints.items() if joint.mimic and joint.mimic.joint}
    done: set[str] = set()
    for name in leaders:
        way: dict[str, None] = {}
        step: str | None = name
        while step is not None and step not in way and step not in done:
            way[step] = None
            step = leaders.get(step)
        if step in way:
            circle = list(way)[list(way).index(step or "") :]
            mimic = joints[circle[0]].mimic
            if mimic is not None:
                told = "itself" if len(circle) == 1 else f"itself by way of {in_words(circle[1:])}"
                yield Finding(mimic.at["joint"], f"joint '{circle[0]}' mimics {told}")
        done.update(way)
