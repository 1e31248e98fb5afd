"""UC113."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in
from urdfctl.rules.urdf.common import severity_in_gazebo
from urdfctl.rules.urdf.tree import WORLD, parent_of


@rule(
    "UC113",
    runtime="refuses",
    because="only Gazebo does, and the robot may not run there",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="sdformat 12 src/Model.cc: 'Joint with non-unique name [...] detected in model with name [...].'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="«tool»" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="tool_joint" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def name_of_link_and_joint(project: Project) -> Iterator[Finding]:
    """Joint has the same name as a link.

    urdfdom accepts it. In Gazebo's sdformat, links and joints share one set of names. gz rejects the model, unless the
    joint is fixed and disappears: an error with `--simulator gz`, and only worth knowing if nothing of the robot is
    for Gazebo.
    """
    robot = robot_in(project)
    if robot is None or not project.may_be_simulated:
        return
    links = {link.name: link for link in robot.links}
    severity = severity_in_gazebo(project, refused_by=("gz",))
    for joint in robot.joints:
        link = links.get(joint.name)
        if joint.type == "fixed" and parent_of(joint) != WORLD:
            continue  # sdformat lumps its links, and its name disappears
        if link is not None and joint.name and is_known(joint.name):
            message = f"joint '{joint.name}' has the same name as a link, which Gazebo rejects; rename one of them"
            yield Finding(joint.at["name"], message, (Note("the link is here", link.at["name"]),), None, severity)
