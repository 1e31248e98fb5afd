"""UC021."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import Word
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.source.problem import ProblemKind


@rule(
    "UC021",
    severity=Severity.WARNING,
    runtime="ignores",
    options=("prefx:=left_",),
    authority="xacro/cli.py load_mappings(): every name:=value is kept; nothing compares them with <xacro:arg>",
    bad=[
        {
            "robot.xacro": """
                «<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">»
                  <xacro:arg name="prefix" default=""/>
                  <link name="$(arg prefix)base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="prefx" default=""/>
                  <link name="$(arg prefx)base"/>
                </robot>
            """,
        },
    ],
)
def argument_unknown(project: Project) -> Iterator[Finding]:
    """Argument that the description does not declare.

    xacro accepts any `name:=value` and does not report one that no `$(arg name)` uses: it is ignored, and the robot is
    expanded with the default value.
    """
    given = _in_launch_file(project)
    for problem in project.of_kind(ProblemKind.UNKNOWN_ARGUMENT):
        word = given.get(problem.subject)
        notes = (Note("the description is here", problem.at),) if word else ()
        yield Finding(word.at if word else problem.at, problem.message, notes)


def _in_launch_file(project: Project) -> dict[str, Word]:
    """The arguments that the launch file gives, each with its place."""
    launch, robot = project.launch, project.robot
    if launch is None or robot is None:
        return {}
    path = robot.at.source.path
    descriptions = [one for one in launch.descriptions if one.file.path == path]
    return {word.text: word for description in descriptions for word in description.names}
