"""UC617."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, SOUND, launched

_BAD = "«$(command 'xacro$(find-pkg-share arm)/arm.urdf')»"
_GLUED = r"\.(?:xacro|urdf)(?=\w+:=)"


def _ros1(mark: str, command: str) -> dict[str, str]:
    parameter = mark.format(f'<param name="robot_description" command="$(find xacro)/{command}"/>')
    manifest = "<package><name>arm</name><exec_depend>xacro</exec_depend></package>"
    return {"arm.launch": f"<launch>{parameter}</launch>", "arm.urdf": "", "package.xml": manifest}


@rule(
    "UC617",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="launch substitutions/command.py: the parts are put together as they are, and split like a shell does: "
    "'executed command failed' or 'file not found'; roslaunch loader.py param_value(): 'Cannot load command parameter'",
    bad=[
        launched(
            PUBLISHER.replace("$(command 'xacro $(find-pkg-share arm)/arm.urdf')", _BAD), MANAGER, BROADCASTER, ARM
        ),
        _ros1("«{}»", "xacro'$(find arm)/arm.urdf'"),
        _ros1("«{}»", "xacro--inorder $(find arm)/arm.urdf"),
    ],
    good=[SOUND, _ros1("{}", "xacro --inorder $(find arm)/arm.urdf")],
)
def xacro_command_malformed(project: Project) -> Iterator[Finding]:
    """Missing space in the command that creates the robot description.

    `Command([...])` joins its parts without a separator. `xacro` and the file become one word, or the file and the
    argument after it. In a launch file for ROS 1 it is `$(find xacro)/xacro` and what comes after it.
    """
    launch = project.launch
    for described in launch.descriptions if launch else ():
        command = described.command or ""
        if launch is not None and launch.ros != ROS_2:
            if re.match(r"\s*xacro/xacro(?:\.py)?[^\s.]", command):
                yield Finding(described.at, "the command has no space after '$(find xacro)/xacro'")
        elif re.match(r"xacro[^\s.]*/", command):
            yield Finding(described.at, "the command has no space between 'xacro' and the file")
        elif glued := re.search(_GLUED + r"(\w+:=)", command):
            yield Finding(described.at, f"the command has no space before '{glued.group(1)}'")
