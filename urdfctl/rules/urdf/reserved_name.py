"""UC114."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in


@rule(
    "UC114",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="sdformat 12 src/Link.cc: 'The supplied link name [__x__] is reserved.'",
    bad={
        "robot.urdf": """
            <link name="«__tool__»"/>
            <joint name="flange" type="fixed"><parent link="fore"/><child link="__tool__"/></joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="__tool"/>
            <joint name="flange" type="fixed"><parent link="fore"/><child link="__tool"/></joint>
        """,
    },
)
def reserved_name(project: Project) -> Iterator[Finding]:
    """A link or joint has a name that begins and ends with two underscores.

    sdformat keeps such names for itself, and Gazebo refuses the model.
    """
    robot = robot_in(project)
    if robot is None or not project.may_be_simulated:
        return
    parts = [(part.name or "", part.at) for part in robot.links] + [(part.name or "", part.at) for part in robot.joints]
    for name, at in parts:
        if len(name) > 4 and name.startswith("__") and name.endswith("__") and is_known(name):  # noqa: PLR2004
            yield Finding(at["name"], f"'{name}' is a name that Gazebo keeps for itself; take an underscore away")
