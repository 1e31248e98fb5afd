"""UC630."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.names import did_you_mean
from urdfctl.rule import Finding, Project, Severity, rule

_INCLUDED = """
    <include file="$(find arm)/inner.xml">
      <arg name="gui" value="{}"/>
    </include>
"""


def _files(*elements: str, inner: str = '<arg name="gui"/>') -> dict[str, str]:
    return {
        "arm.launch": f"<launch>{''.join(elements)}</launch>",
        "inner.xml": f"<launch>{inner}</launch>",
        "package.xml": "<package><name>arm</name></package>",
    }


def _group(condition: str) -> str:
    return f'<group if="{condition}"><param name="rate" value="1"/></group>'


_GUI = '<arg name="gui" default="true"/>'


@rule(
    "UC630",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="roslaunch substitution_args.py _eval_arg(): ArgException for a name that no <arg> of the file defines; "
    "xmlloader.py: \"arg 'gui' is not defined. Arg xml is\"; wiki.ros.org/roslaunch/XML/arg: an argument is local to its file",
    bad=[
        _files(_INCLUDED.format("«$(arg gui)»")),
        _files(_GUI, _group("«$(arg gvi)»")),
        _files(_GUI, _INCLUDED.format("true"), inner='<arg name="gui"/><param name="rate" value="«$(arg rate)»"/>'),
    ],
    good=[
        _files(_GUI, _INCLUDED.format("$(arg gui)")),
        _files(_GUI, _group("$(arg gui)")),
        _files('<arg name="gui" default="false"/>', _group("$(arg gui)").replace('"1"', '"$(arg rate)"')),
    ],
)
def argument_not_declared(project: Project) -> Iterator[Finding]:
    """Argument of a launch file is used, but not declared.

    roslaunch in ROS 1 then rejects the whole launch file. An argument is known only in the file with its `<arg>`: an
    included file declares it again. What only runs with other arguments is not told.
    """
    launch = project.launch
    if launch is None:
        return
    for word in launch.undeclared:
        names = [name for name, _ in launch.arguments] if word.at.source.path == launch.path else []
        hint = did_you_mean(word.text, names) or f'; add <arg name="{word.text}"/>'
        yield Finding(word.at, f"argument '{word.text}' is not declared in this launch file{hint}")
