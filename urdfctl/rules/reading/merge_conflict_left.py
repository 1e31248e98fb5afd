"""UC034."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind

_CONFLICT = """{first}<<<<<<< HEAD{last}
{ours}
=======
{theirs}
>>>>>>> other
"""


def _conflict(text: str, ours: str, theirs: str) -> str:
    return text % _CONFLICT.format(first="«", last="»", ours=ours, theirs=theirs)


@rule(
    "UC034",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="git-merge(1): a conflict is left between <<<<<<<, ======= and >>>>>>>; xacro: 'XML parsing error'; "
    "rcl_yaml_param_parser: 'Error parsing a event near line %d'; launch: SyntaxError",
    bad=[
        {"robot.urdf": _conflict('<robot name="r">\n%s</robot>\n', '<link name="base"/>', '<link name="base_link"/>')},
        {
            "controllers.yaml": _conflict(
                "controller_manager:\n  ros__parameters:\n%s", "    update_rate: 100", "    update_rate: 500"
            )
        },
        {
            "arm.launch.py": _conflict(
                "from launch import LaunchDescription\n%s\ndef generate_launch_description():\n"
                "    return LaunchDescription([])\n",
                "import os",
                "import sys",
            )
        },
    ],
    good=[
        {"controllers.yaml": "# <<<<<<< not a conflict\ncontroller_manager:\n  ros__parameters: {update_rate: 100}\n"}
    ],
)
def merge_conflict_left(project: Project) -> Iterator[Finding]:
    """Merge conflict was left in a file.

    git marks it with lines of <<<<<<<, ======= and >>>>>>>. No parser reads them, so nothing in the file is used.
    """
    yield from findings_of(project, ProblemKind.MERGE_CONFLICT)
