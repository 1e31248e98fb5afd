"""UC038."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind

_NODE = '<node name="joy" pkg="joy" type="joy_node"{}/>'


def _launch(*elements: str) -> dict[str, str]:
    return {
        "arm.launch": f"<launch><param name='robot_description' textfile='$(find arm)/arm.urdf'/>{''.join(elements)}</launch>",
        "arm.urdf": "",
        "package.xml": "<package><name>arm</name><run_depend>joy</run_depend></package>",
    }


@rule(
    "UC038",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="roslaunch xmlloader.py: '<node> tag is missing required attribute', '<param> tag must have one and only one of "
    "value/textfile/binfile', \"arg 'x' has already been declared\", \"unknown <node> attribute 'x'\" (printed only)",
    bad=[
        _launch('«<node name="joy" type="joy_node"/>»'),
        _launch('<node name="joy" pkg="joy" typ="«joy_node»"/>'),
        _launch('<node name="joy" pkg="joy" type="«»"/>'),
        _launch(_NODE.format(' respwan="«true»"')),
        _launch('«<nod name="joy" pkg="joy" type="joy_node"/>»'),
        _launch('«<param name="rate"/>»'),
        _launch('<arg name="x" default="1"/>', '«<arg name="x" default="2"/>»'),
        _launch('«<arg name="x" default="1" value="2"/>»'),
    ],
    good=[
        _launch(_NODE.format(' respawn="true" if="true"')),
        _launch('<arg name="x" default="1" doc="of the base"/>'),
        _launch('<arg name="x" default="1" if="true"/>', '<arg name="x" default="2" unless="true"/>'),
    ],
)
def launch_element_malformed(project: Project) -> Iterator[Finding]:
    """Element of a launch file that roslaunch refuses or ignores.

    Without an attribute that an element requires, or with two values for one parameter, roslaunch rejects the whole file. An
    attribute or element that it does not know is only printed, and has no effect: a node, parameter or included file with a
    misspelt name is missing.
    """
    yield from findings_of(project, ProblemKind.LAUNCH_FORM)
