"""UC644."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch.common import launch_of

_LAUNCH = """
            <launch>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="states" pkg="robot_state_publisher" type="{}"/>
            </launch>
"""
_MANIFEST = "<package><name>arm</name><exec_depend>robot_state_publisher</exec_depend></package>"


@rule(
    "UC644",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=("noetic",),
    options=["--distro=noetic"],
    authority="robot_state_publisher CHANGELOG 1.15.0 (noetic): 'Remove state_publisher'; joint_state_publisher 1.12.14: "
    "'This backwards compatibility option will be removed in Noetic.'",
    bad=[{"robot.urdf": "", "arm.launch": _LAUNCH.format("«state_publisher»"), "package.xml": _MANIFEST}],
    good=[{"robot.urdf": "", "arm.launch": _LAUNCH.format("robot_state_publisher"), "package.xml": _MANIFEST}],
)
def publisher_of_older_distro(project: Project) -> Iterator[Finding]:
    """State publisher with a name or an option that noetic removed.

    The program `state_publisher` is `robot_state_publisher` now, and roslaunch cannot start the old one. The parameter
    `use_gui` of joint_state_publisher is ignored: the window is in joint_state_publisher_gui.
    """
    launch = launch_of(project, 1) if set(project.distros) == {"noetic"} else None
    for node in launch.nodes if launch else ():
        if node.runs("robot_state_publisher", "state_publisher") and node.sure:
            at = node.executable.at
            message = "'state_publisher' does not exist in noetic; use 'robot_state_publisher'"
            fix = replaced(at, "state_publisher", "robot_state_publisher", safe=True)
            yield Finding(at, message, fix=fix)
    gui = "joint_state_publisher_gui"
    publishers = (
        [node for node in launch.nodes if node.runs("joint_state_publisher", "joint_state_publisher")] if launch else []
    )
    given = [word.at for node in publishers for word in node.parameters if word.text == "use_gui"]
    given += [inline.at for inline in launch.inline if inline.name == "use_gui"] if launch and publishers else []
    for at in given[:1]:
        fix = Fix(f'write pkg="{gui}" type="{gui}"')
        yield Finding(at, f"'use_gui' is ignored in noetic; start {gui} instead", fix=fix, severity=Severity.WARNING)
