"""UC617."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2, launch_of
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, SOUND, launched

_BAD = "«$(command 'xacro$(find-pkg-share arm)/arm.urdf')»"
_GLUED = r"\.(?:xacro|urdf)(?=\w+:=)"


@rule(
    "UC617",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="launch substitutions/command.py: the parts are put together as they are, and split like a shell does: "
    "'executed command failed' or 'file not found'",
    bad=[
        launched(
            PUBLISHER.replace("$(command 'xacro $(find-pkg-share arm)/arm.urdf')", _BAD), MANAGER, BROADCASTER, ARM
        ),
    ],
    good=[SOUND],
)
def xacro_command_malformed(project: Project) -> Iterator[Finding]:
    """Missing space in the command that creates the robot description.

    `Command([...])` joins its parts without a separator. `xacro` and the file become one word, or the file and the
    argument after it.
    """
    launch = launch_of(project, ROS_2)
    for described in launch.descriptions if launch else ():
        command = described.command or ""
        if re.match(r"xacro[^\s.]*/", command):
            yield Finding(described.at, "the command has no space between 'xacro' and the file")
        elif glued := re.search(_GLUED + r"(\w+:=)", command):
            yield Finding(described.at, f"the command has no space before '{glued.group(1)}'")
