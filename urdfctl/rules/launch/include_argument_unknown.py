"""UC618."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, launched

_DECIDES_WHAT_RUNS = ("gz_args", "ign_args")
"""What the simulator starts with: without it there is no world, or it stands still."""
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


def _passing_all(name: str) -> dict[str, str]:
    files = _files(name)
    passing = files["arm.launch"].replace("<include", '<include pass_all_args="true"')
    return {**files, "arm.launch": passing, "inner.xml": _INNER.replace("gui", "height")}


_MANIFEST = "<package><name>arm</name><run_depend>gazebo_ros</run_depend></package>"
_WORLD = """
    <launch><include file="$(find gazebo_ros)/launch/empty_world.launch"><arg name="{}" value="false"/></include></launch>
"""
_GZ = """
      <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"><arg name="{}" value="-r empty.sdf"/></include>"""
_PART = """
      <include file="$(find-pkg-share arm)/part.launch.xml"><arg name="{}" value="0.1"/></include>"""


def _included(name: str) -> dict[str, str]:
    part = '<launch><arg name="height" default="0"/><let name="z" value="$(var height)"/></launch>'
    return {**launched(PUBLISHER, MANAGER, BROADCASTER, ARM, _PART.format(name)), "part.launch.xml": part}


@rule(
    "UC618",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="roslaunch loader.py post_process_include_args(): 'unused args [gui] for include of [/arm/inner.launch]', not "
    "with pass_all_args (ros_comm #1520, melodic); launch "
    "include_launch_description.py sets every argument, also one that nothing declares; ros_gz_sim gz_sim.launch.py",
    bad=[
        _files("«gvi»"),
        _passing_all("«heigth»"),
        _included("«heigth»"),
        launched(PUBLISHER, _GZ.format("«gz_arg»")),
        launched(PUBLISHER, _GZ.format("«ign_arg»")),
    ],
    good=[
        _files("gui"),
        {**_files("gui"), "arm.launch": _WORLD.format("gui"), "package.xml": _MANIFEST},
        _passing_all("color"),
        _included("height"),
        _included("color"),
    ],
)
def include_argument_unknown(project: Project) -> Iterator[Finding]:
    """Unknown argument for an included launch file.

    roslaunch in ROS 1 then rejects the whole launch file. With `pass_all_args="true"`, and in ROS 2, such arguments are
    accepted without a word: only one with nearly the name of an argument that the file declares, and that is not given,
    is told. What was meant keeps its default. A simulator without its arguments has no world, or stands still.
    """
    launch = project.launch
    for word in launch.strays if launch else ():
        yield Finding(word.at, f"included launch file has no argument '{word.text}'")
    for word, meant in launch.slips if launch else ():
        message = f"included launch file has no argument '{word.text}', and ignores it; did you mean '{meant}'?"
        severity = None if meant in _DECIDES_WHAT_RUNS else Severity.WARNING
        yield Finding(word.at, message, fix=replaced(word.at, word.text, meant), severity=severity)
