"""What launch refuses in the elements of launch files in XML and YAML."""

from __future__ import annotations

import pytest

from urdfctl.model.launch.ros2.forms import malformed
from urdfctl.source.launch.frontend import of_xml, of_yaml
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse
from urdfctl.source.yaml.tree import read_yaml

COMPONENT = '<composable_node pkg="a" plugin="b" if="true"><extra_arg name="c" value="1"/></composable_node>'
CAMERA = '<node pkg="camera" exec="driver">{}</node>'


def refused_in_xml(text: str) -> list[str]:
    source = SourceText("/bringup.launch.xml", f"<launch>{text}</launch>".encode())
    return [part.message for part in malformed(of_xml(parse(source).documentElement))]


def refused_in_yaml(text: str) -> list[str]:
    root = of_yaml(read_yaml(SourceText("/bringup.launch.yaml", f"launch:\n{text}".encode())))
    assert root is not None
    return [part.message for part in malformed(root)]


@pytest.mark.parametrize(
    ("written", "told", "hint"),
    [
        ('<node pkg="a" exec="b" ns="left"/>', "<node> has no attribute 'ns'", "did you mean 'namespace'?"),
        ('<node pkg="a" type="b"/>', "<node> has no attribute 'type'", "did you mean 'exec'?"),
        ('<group ns="left"/>', "<group> has no attribute 'ns'", 'put <push_ros_namespace namespace="..."/> into it'),
        ('<timer perod="2"/>', "<timer> has no attribute 'perod'", "did you mean 'period'?"),
        ('<arg name="b"><choise value="1"/></arg>', "<arg> takes no <choise>", "did you mean <choice>?"),
        ("<group><gruop/></group>", "launch has no <gruop> here", "did you mean <group>?"),
        (CAMERA.format('<remap from="a" too="b"/>'), "<remap> has no attribute 'too'", "did you mean 'to'?"),
        (
            '<include file="a.xml"><arg name="b" default="1"/></include>',
            "<arg> has no attribute 'default'",
            "did you mean 'value'?",
        ),
    ],
)
def test_what_launch_does_not_know_is_told_once_with_what_is_meant(written: str, told: str, hint: str) -> None:
    (message,) = refused_in_xml(written)
    assert message.startswith(told)
    assert message.endswith(f" the file; {hint}")


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("<timer/>", "<timer> has no 'period', which launch requires"),
        ('<let name="a"/>', "<let> has no 'value', which launch requires"),
        ('<remap from="a" to="b"/>', "launch has no <remap> here, and refuses the file"),
        (
            CAMERA.format('<param name="a"><param value="1"/></param>'),
            "<param> has neither 'name' nor 'from'; launch requires one of them",
        ),
    ],
)
def test_what_launch_requires_and_does_not_find_is_told(written: str, told: str) -> None:
    assert refused_in_xml(written) == [told]


@pytest.mark.parametrize(
    "written",
    [
        CAMERA.format('<param from="a.yaml" allow_substs="true"/><env name="A" value="1"/>'),
        CAMERA.format('<param name="gains"><param name="p" value="1;2" value-sep=";"/></param>'),
        '<node pkg="a" exec="b" if="$(var real)" launch-prefix="gdb" respawn="true" respawn_delay="1.0"/>',
        f'<load_composable_node target="a">{COMPONENT}</load_composable_node>',
        '<group scoped="true"><keep name="a" value="1"/><push-ros-namespace namespace="left"/></group>',
        '<executable cmd="gz sim" cwd="/tmp" shell="true"><env name="A" value="1"/></executable>',
        '<reset_env/><set_use_sim_time value="true"/><company_action speed="1"><part/></company_action>',
    ],
)
def test_what_launch_takes_is_no_fault(written: str) -> None:
    assert refused_in_xml(written) == []


def test_keys_of_yaml_are_attributes_and_lists_of_values_are_no_elements() -> None:
    node = "{pkg: a, exec: b, remap: [{from: c, to: d}], param: [{name: e, value: [1, 2]}]}"
    assert refused_in_yaml(f"- node: {node}") == []


def test_what_stands_in_an_action_of_yaml_is_looked_at_too() -> None:
    (message,) = refused_in_yaml("- group:\n    children:\n    - node: {pkg: a, exec: b, parm: [{name: e, value: 1}]}")
    assert message == "<node> takes no <parm>, and launch refuses the file; did you mean <param>?"
