"""UC103."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced, robot_in, severity_where

READING = since("galactic")


@rule(
    "UC103",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=READING,
    authority="urdfdom 3.0 urdf_parser/src/model.cpp: \"Invalid 'version' specified; only version 1.0 is currently supported\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <robot name="arm" version="«2.0»">
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <robot name="arm" version="1.0">
                  <link name="base"/>
                </robot>
            """,
        },
    ],
)
def robot_version_unsupported(project: Project) -> Iterator[Finding]:
    """Unsupported URDF version.

    The attribute `version` is the version of the format, not of the robot. From galactic on, urdfdom rejects the robot
    for any value but 1.0. Without the attribute it assumes 1.0.
    """
    robot = robot_in(project)
    if robot is None:
        return
    version = robot.version
    if version is not None and version != "1.0" and is_known(version):
        message = f"'version' of <robot> must be '1.0', not '{version}'; it is the version of the URDF format"
        fix = replaced(robot.at["version"], version, "1.0")
        yield Finding(robot.at["version"], message, fix=fix, severity=severity_where(project, READING))
