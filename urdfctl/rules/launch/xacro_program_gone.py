"""UC620."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.launch.common import launch_of
from urdfctl.source.span import Place, SourceSpan

_LOADED = "<launch><param name=\"robot_description\" command={}$(find xacro)/{} '$(find arm)/arm.urdf'{}/></launch>"


@rule(
    "UC620",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=("noetic",),
    options=("--distro=noetic",),
    authority="ros/xacro pull request 239, released as 1.14.2 for noetic: xacro.py is removed; roslaunch: "
    "'Invalid <param> tag: Cannot load command parameter [robot_description]: no such command'",
    bad=[{"robot.urdf": "", "arm.launch": _LOADED.format('"«', "xacro.py", '»"')}],
    good=[{"robot.urdf": "", "arm.launch": _LOADED.format('"', "xacro", '"')}],
)
def xacro_program_gone(project: Project) -> Iterator[Finding]:
    """Launch file calls xacro by its old name, xacro.py.

    noetic does not have this program, so roslaunch stops before it starts anything. From indigo to melodic both names
    work.
    """
    launch = launch_of(project, 1)
    for described in launch.descriptions if launch else ():
        at = described.file.at
        if described.sure and re.match(r"\s*(?:xacro/|rosrun\s+xacro\s+)xacro\.py\s", described.command or ""):
            severity = Severity.ERROR if project.distro else Severity.INFO
            yield Finding(at, "'xacro.py' does not exist in noetic; use 'xacro'", (), _fix(at), severity)


def _fix(at: Place) -> Fix:
    start, _, _ = at.span.text.partition("xacro.py")
    begin = at.start + len(start.encode())
    return Fix("write 'xacro'", (Edit(SourceSpan(at.source, begin, begin + len("xacro.py")), "xacro"),))
