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
    distros=READING,
    authority="urdfdom 3.0 urdf_parser/src/model.cpp: \"Invalid 'version' specified; only version 1.0 is currently supported\"",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": """
            <robot name="arm" version="«2.0»">
              <link name="base"/>
            </robot>
        """,
    },
    good={
        "robot.urdf": """
            <robot name="arm" version="1.0">
              <link name="base"/>
            </robot>
        """,
    },
)
def robot_version_unsupported(project: Project) -> Iterator[Finding]:
    """A robot's `version` is not 1.0.

    From galactic on urdfdom reads the attribute, which is the version of the format and not of the robot, and gives no
    model for any other. Without the attribute it takes 1.0.
    """
    robot = robot_in(project)
    if robot is None:
        return
    version = robot.version
    if version is not None and version != "1.0" and is_known(version):
        message = f"'version' of <robot> is '{version}'; it is that of the format, and only '1.0' is supported"
        fix = replaced(robot.at["version"], version, "1.0")
        yield Finding(robot.at["version"], message, fix=fix, severity=severity_where(project, READING))
