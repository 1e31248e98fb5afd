"""UC114."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in


@rule(
    "UC114",
    runtime="refuses",
    because="only Gazebo does, and the robot may not run there",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="sdformat 12 src/Link.cc: 'The supplied link name [__x__] is reserved.'",
    bad=[
        {
            "robot.urdf": """
                <link name="«__tool__»"/>
                <joint name="flange" type="fixed"><parent link="fore"/><child link="__tool__"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="__tool"/>
                <joint name="flange" type="fixed"><parent link="fore"/><child link="__tool"/></joint>
            """,
        },
    ],
)
def reserved_name(project: Project) -> Iterator[Finding]:
    """Reserved link or joint name.

    sdformat reserves names that begin and end with two underscores, and Gazebo rejects the model.
    """
    robot = robot_in(project)
    if robot is None or not project.may_be_simulated:
        return
    parts = [("link", link.name or "", link.at) for link in robot.links]
    parts += [("joint", joint.name or "", joint.at) for joint in robot.joints]
    for kind, name, at in parts:
        if len(name) > 4 and name.startswith("__") and name.endswith("__") and is_known(name):  # noqa: PLR2004
            yield Finding(at["name"], f"{kind} '{name}' has a name that Gazebo reserves; remove an underscore")
