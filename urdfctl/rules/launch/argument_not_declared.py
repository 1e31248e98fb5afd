"""UC630."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.model.launch import Launch, Word
from urdfctl.names import did_you_mean
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.file_names import file_name
from urdfctl.rules.launch.common import ROS_2
from urdfctl.rules.launch_samples import ARM, BROADCASTER, MANAGER, PUBLISHER, launched

_INCLUDED = """
    <include file="$(find arm)/inner.xml">
      <arg name="gui" value="{}"/>
    </include>
"""
_GUI = '<arg name="gui" default="true"/>'
_PYTHON = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    spawner = Node(package="controller_manager", executable="spawner", arguments=["joint_state_broadcaster"], namespace={})
    return LaunchDescription([{}spawner])
"""


def _files(*elements: str, inner: str = '<arg name="gui"/>') -> dict[str, str]:
    return {
        "arm.launch": f"<launch>{''.join(elements)}</launch>",
        "inner.xml": f"<launch>{inner}</launch>",
        "package.xml": "<package><name>arm</name></package>",
    }


def _group(condition: str) -> str:
    return f'<group if="{condition}"><param name="rate" value="1"/></group>'


def _xml(prefix: str, *, before: str = "", after: str = "") -> dict[str, str]:
    publisher = PUBLISHER.replace("</node>", f'<param name="frame_prefix" value="{prefix}"/></node>')
    started = (before, publisher, MANAGER, BROADCASTER, ARM, after)
    return launched(*started)


def _python(namespace: str, before: str = "") -> dict[str, str]:
    return {"arm.launch.py": _PYTHON.format(namespace, before), "package.xml": launched()["package.xml"]}


@rule(
    "UC630",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="roslaunch substitution_args.py _eval_arg(): ArgException for a name that no <arg> of the file defines; "
    "xmlloader.py: \"arg 'gui' is not defined. Arg xml is\"; launch substitutions/launch_configuration.py perform(): "
    "SubstitutionFailure \"launch configuration 'gui' does not exist\" if nothing has set it and it has no default",
    bad=[
        _files(_INCLUDED.format("«$(arg gui)»")),
        _files(_GUI, _group("«$(arg gvi)»")),
        _files(_GUI, _INCLUDED.format("true"), inner='<arg name="gui"/><param name="rate" value="«$(arg rate)»"/>'),
        _xml("«$(var gui)»"),
        _xml("«$(var gui)»", after=_GUI),
        _xml("«$(var gvi)»", before=_GUI),
        _python('LaunchConfiguration("«ns»")'),
    ],
    good=[
        _files(_GUI, _INCLUDED.format("$(arg gui)")),
        _files(_GUI, _group("$(arg gui)")),
        _files('<arg name="gui" default="false"/>', _group("$(arg gui)").replace('"1"', '"$(arg rate)"')),
        _files(_INCLUDED.format("$(arg gui)")) | {"README.md": "roslaunch arm arm.launch gui:=true"},
        _xml("$(var gui)", before=_GUI),
        _xml("$(var gui)") | {"README.md": "ros2 launch arm arm.launch.xml gui:=left"},
        _python('LaunchConfiguration("ns")', 'DeclareLaunchArgument("ns"), '),
        _python('LaunchConfiguration("ns")', 'SetLaunchConfiguration("ns", "left"), '),
        _python('LaunchConfiguration("ns", default="left")'),
        _python('LaunchConfiguration("ns")') | {"all.launch.py": "INCLUDED = ['arm.launch.py']\n"},
    ],
)
def argument_not_declared(project: Project) -> Iterator[Finding]:
    """Argument of a launch file is used, but not declared.

    roslaunch in ROS 1 then rejects the whole launch file, unless the command line gives the argument. It is known only in
    the file with its `<arg>`: an included file declares it again. launch in ROS 2 ends at the use, unless the command line or an including file gives
    the argument. Its actions run in their order: what is declared further down does not exist yet. What only runs with
    other arguments is not told.
    """
    launch = project.launch
    if launch is None:
        return
    file = re.escape(file_name(launch.path))
    for word in launch.undeclared:
        if launch.ros != ROS_2:
            if word.at.source.path == launch.path and project.may_mention(rf"\b{re.escape(word.text)}:="):
                continue
            names = [name for name, _ in launch.arguments] if word.at.source.path == launch.path else []
            hint = did_you_mean(word.text, names) or f'; add <arg name="{word.text}"/>'
            yield Finding(word.at, f"argument '{word.text}' is not declared in this launch file{hint}")
        elif not project.may_mention(rf"\b{re.escape(word.text)}:=|[\"'/]{file}[\"']"):
            yield _not_set(word, launch)


def _not_set(word: Word, launch: Launch) -> Finding:
    """What is wrong with an argument in ROS 2 that nobody has set where it is used."""
    names = [name for name, _ in launch.arguments]
    if word.text in names:
        return Finding(word.at, f"argument '{word.text}' is used before it is declared; declare it further up")
    is_python = word.at.source.path.endswith(".py")
    declaration = f'DeclareLaunchArgument("{word.text}", …)' if is_python else f'<arg name="{word.text}" default="…"/>'
    hint = did_you_mean(word.text, names) or f"; add {declaration} before it"
    return Finding(word.at, f"argument '{word.text}' is not declared, and has no default{hint}")
