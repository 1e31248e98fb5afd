"""UC038."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind

_NODE = '<node name="joy" pkg="joy" type="joy_node"{}/>'
_JOY = '<node pkg="joy" exec="joy_node"{}/>'


def _launch(*elements: str) -> dict[str, str]:
    return {
        "arm.launch": f"<launch><param name='robot_description' textfile='$(find arm)/arm.urdf'/>{''.join(elements)}</launch>",
        "arm.urdf": "",
        "package.xml": "<package><name>arm</name><run_depend>joy</run_depend></package>",
    }


def _launch_of_ros2(element: str) -> dict[str, str]:
    return {
        "arm.launch.xml": f"<launch>{element}{_JOY.format('')}</launch>",
        "package.xml": "<package><name>arm</name><exec_depend>joy</exec_depend></package>",
    }


@rule(
    "UC038",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="roslaunch xmlloader.py: '<node> tag is missing required attribute', '<param> tag must have one and only one of "
    "value/textfile/binfile', \"arg 'x' has already been declared\", \"unknown <node> attribute 'x'\" (printed only); launch "
    "launch_xml/entity.py assert_entity_completely_parsed(): 'Unexpected attribute(s) found in `node`', 'Unexpected nested "
    "tag(s)'; launch frontend/expose.py: 'Unrecognized entity of the type'",
    bad=[
        _launch('«<node name="joy" type="joy_node"/>»'),
        _launch('<node name="joy" pkg="joy" typ="«joy_node»"/>'),
        _launch('<node name="joy" pkg="joy" type="«»"/>'),
        _launch(_NODE.format(' respwan="«true»"')),
        _launch('«<nod name="joy" pkg="joy" type="joy_node"/>»'),
        _launch('«<param name="rate"/>»'),
        _launch('<arg name="x" default="1"/>', '«<arg name="x" default="2"/>»'),
        _launch('«<arg name="x" default="1" value="2"/>»'),
        _launch_of_ros2(_JOY.format(' respwan="«true»"')),
        _launch_of_ros2('<node exec="joy_node" pkgs="«joy»"/>'),
        _launch_of_ros2('«<node pkg="joy"/>»'),
        _launch_of_ros2(_JOY.format(' if="true" unless="false"').join("«»")),
        _launch_of_ros2('<arg name="rate" value="«50»"/>'),
        _launch_of_ros2('«<inclde file="other.launch.xml"/>»'),
        _launch_of_ros2('«<param name="rate" value="50"/>»'),
        _launch_of_ros2('<node pkg="joy" exec="joy_node">«<rosparam file="joy.yaml"/>»</node>'),
        _launch_of_ros2('<node pkg="joy" exec="joy_node">«<param value="1"/>»</node>'),
        {
            "arm.launch.yaml": "launch:\n- node: {pkg: joy, exec: joy_node, nmae: «joy»}\n",
            "package.xml": "<package><name>arm</name><exec_depend>joy</exec_depend></package>",
        },
    ],
    good=[
        _launch(_NODE.format(' respawn="true" if="true"')),
        _launch('<arg name="x" default="1" doc="of the base"/>'),
        _launch('<arg name="x" default="1" if="true"/>', '<arg name="x" default="2" unless="true"/>'),
        _launch_of_ros2(_JOY.format(' respawn="true" if="true"')),
        _launch_of_ros2(
            '<group><push_ros_namespace namespace="a"/><arg name="x" default="1"><choice value="1"/></arg></group>'
        ),
        _launch_of_ros2(
            '<node pkg="joy" exec="joy_node"><param name="a"><param name="b" value="1,2" value-sep=","/></param></node>'
        ),
        _launch_of_ros2('<start_cameras number="3"/>'),
        {
            "arm.launch.yaml": "launch:\n- node: {pkg: joy, exec: joy_node, param: [{name: rates, value: [1, 2]}]}\n",
            "package.xml": "<package><name>arm</name><exec_depend>joy</exec_depend></package>",
        },
    ],
)
def launch_element_malformed(project: Project) -> Iterator[Finding]:
    """Element of a launch file that launch or roslaunch does not take.

    Without an attribute that an element requires, or with two values for one parameter, the whole file is refused. launch of
    ROS 2 also refuses an attribute or element that it does not know, wherever it stands; roslaunch only prints it: a node,
    parameter or included file with a misspelt name is missing.
    """
    yield from findings_of(project, ProblemKind.LAUNCH_FORM)
