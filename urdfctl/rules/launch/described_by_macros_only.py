"""UC631."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule

_LAUNCH = """
    <launch>
      <param name="robot_description" command="$(find xacro)/xacro {}"/>
      <node pkg="robot_state_publisher" type="robot_state_publisher" name="publisher"/>
    </launch>
"""
_MANIFEST = """
    <package format="2">
      <name>arm</name>
      <exec_depend>robot_state_publisher</exec_depend>
      <exec_depend>xacro</exec_depend>
    </package>
"""
_MACRO = """
    <robot name="camera" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:macro name="camera" params="parent">
        <link name="${parent}_camera"/>
      </xacro:macro>%s
    </robot>
"""

_NOT_EXPANDED = rb"(?s)<!--.*?-->|<(?:xacro:)?macro\b.*?</(?:xacro:)?macro>"
_ADDS_PARTS = rb"<(?:xacro:(?!arg\b|property\b)|link\b|joint\b|include\b)"


@rule(
    "UC631",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): 'No link elements found in urdf file'",
    bad=[
        {
            "arm.launch": _LAUNCH.format("«$(find arm)/camera.urdf.xacro»").replace(
                'command="$(find xacro)/xacro «$(find arm)/camera.urdf.xacro»"',
                'command="«$(find xacro)/xacro $(find arm)/camera.urdf.xacro»"',
            ),
            "camera.urdf.xacro": _MACRO % "",
            "package.xml": _MANIFEST,
        },
    ],
    good=[
        {
            "arm.launch": _LAUNCH.format("$(find arm)/camera.urdf.xacro"),
            "camera.urdf.xacro": _MACRO % '\n      <xacro:camera parent="arm"/>',
            "package.xml": _MANIFEST,
        },
    ],
)
def described_by_macros_only(project: Project) -> Iterator[Finding]:
    """Launched robot description only defines macros.

    A file that defines macros and calls none expands to a robot without links. robot_state_publisher and Gazebo reject
    it. Launch the file that calls the macro, or call the macro in this one.
    """
    launch = project.launch
    if launch is None or project.robot is None or not project.library:
        return
    if re.search(_ADDS_PARTS, re.sub(_NOT_EXPANDED, b"", project.robot.at.source.data)):
        return
    for described in launch.descriptions:
        file = described.file
        if described.sure and file.path == project.path:
            name = file.path.replace("\\", "/").rpartition("/")[2]
            message = f"'{name}' only defines macros and calls none, so the robot has no link; call a macro in it"
            yield Finding(file.at, message)
            return
