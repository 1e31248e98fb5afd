"""UC618."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Project, Severity, rule

_INNER = '<launch><arg name="gui" default="true"/></launch>'


def _files(name: str) -> dict[str, str]:
    return {
        "arm.launch": f"""
            <launch>
              <include file="$(find arm)/inner.xml">
                <arg name="{name}" value="false"/>
              </include>
            </launch>
        """,
        "inner.xml": _INNER,
        "package.xml": "<package><name>arm</name></package>",
    }


@rule(
    "UC618",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="roslaunch loader.py post_process_include_args(): 'unused args [gui] for include of [/arm/inner.launch]'",
    bad=[_files("«gvi»")],
    good=[_files("gui")],
)
def include_argument_unknown(project: Project) -> Iterator[Finding]:
    """Unknown argument for an included launch file.

    roslaunch in ROS 1 then rejects the whole launch file. ROS 2 accepts such arguments.
    """
    for word in project.launch.strays if project.launch else ():
        yield Finding(word.at, f"included launch file has no argument '{word.text}'")
