"""roslaunch's XML is read for what it surely does; what cannot be known is unknown."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from urdfctl.model.launch import Launch, Spawn, joined
from urdfctl.model.launch.ros1 import launch_of
from urdfctl.model.launch.scope import Sources
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Document
from urdfctl.source.xml.parsing import parse


def launch(inside: str, arguments: Mapping[str, str] | None = None, **files: str) -> Launch:
    """The facts of a launch file; other files lie at /p/<name>.launch, and p is the only package."""
    texts = {f"/p/{name}.launch": f"<launch>{text}</launch>" for name, text in {**files, "main": inside}.items()}

    def read(path: str) -> Document | None:
        return parse(SourceText(path, texts[path].encode())) if path in texts else None

    sources = Sources(read, lambda path: (path, True), {"p": "/p"}.get, {"HERE": "x"})
    found = launch_of("/p/main.launch", arguments or {}, sources)
    assert found is not None
    return found


def spawner(attributes: str) -> Spawn:
    (spawn,) = launch(f'<node name="s" pkg="controller_manager" {attributes}/>').spawns
    return spawn


def names(spawn: Spawn) -> list[str]:
    return [name for name, _ in spawn.names]


@pytest.mark.parametrize(
    ("outer", "inner", "whole"),
    [
        ("", "", ""),
        ("", "/", ""),
        ("", "a", "/a"),
        ("/a", "", "/a"),
        ("/a", "b/c/", "/a/b/c"),
        ("/a", "/b", "/b"),
        ("/a", UNKNOWN, UNKNOWN),
        (UNKNOWN, "b", UNKNOWN),
        (UNKNOWN, "/b", "/b"),
    ],
)
def test_namespaces_are_joined_as_roslaunch_joins_them(outer: str, inner: str, whole: str) -> None:
    assert joined(outer, inner) == whole


@pytest.mark.parametrize(
    ("args", "found", "namespace", "active", "complete"),
    [
        ("a b", ["a", "b"], "/r", True, True),
        ("--stopped a", ["a"], "/r", False, True),
        ("--namespace=/x a", ["a"], "/x", True, True),
        ("--namespace y --timeout 60 a", ["a"], "/r/y", True, True),
        ("--no-timeout --wait-for /go a", ["a"], "/r", True, True),
        ("--shutdown-time 1 --names=/x --stop a", ["a"], "/x", False, True),
        ("--no-time 1", ["1"], "/r", True, True),
        ("a $(env B)", ["a"], "/r", True, False),
        ("$(find p)/c.yaml", [], "/r", True, False),
        ("\n      a\n      b", ["a", "b"], "/r", True, True),
    ],
)
def test_a_spawner_tells_names_and_namespace(
    args: str, found: list[str], namespace: str, active: bool, complete: bool
) -> None:
    spawn = spawner(f'ns="/r" type="spawner" args="{args}"')
    assert (names(spawn), spawn.namespace, spawn.active, spawn.complete) == (found, namespace, active, complete)


@pytest.mark.parametrize(("verb", "active"), [("spawn", True), ("load", False)])
def test_the_old_script_spawns_too(verb: str, active: bool) -> None:
    spawn = spawner(f'type="controller_manager" args="{verb} a b"')
    assert (names(spawn), spawn.namespace, spawn.active) == (["a", "b"], "", active)


def test_each_name_has_its_place() -> None:
    ((_, place), (_, other)) = spawner('type="spawner" args="arm_2 arm"').names
    assert (place.span.text, other.span.text) == ("arm_2", "arm")
    assert other.start == place.start + 6


@pytest.mark.parametrize(
    ("param", "path", "arguments"),
    [
        ('textfile="$(find p)/r.urdf"', "/p/r.urdf", ()),
        (
            "command=\"$(find xacro)/xacro --inorder '$(find p)/r.xacro' a:=1 b:='x'\"",
            "/p/r.xacro",
            (("a", "1"), ("b", "x")),
        ),
        ('command="xacro $(find p)/r.xacro"', "/p/r.xacro", ()),
        ("command=\"xacro '$(find p)/r.xacro' at:='0 0 1'\"", "/p/r.xacro", (("at", "0 0 1"),)),
        ('command="$(find xacro)/xacro.py $(find p)/r.xacro"', "/p/r.xacro", ()),
        ('command="rosrun xacro xacro $(find p)/r.xacro"', "/p/r.xacro", ()),
        ('command="cat $(find p)/r.urdf"', "/p/r.urdf", ()),
        ('command="xacro $(find p)/r.xacro a:=$(env A)"', "/p/r.xacro", (("a", UNKNOWN),)),
        ('command="$(find p)/scripts/env_run $(find p)/base xacro $(find p)/r.xacro --inorder"', "/p/r.xacro", ()),
        ("command=\"bash -c '$(find xacro)/xacro $(find p)/r.xacro a:=1'\"", "/p/r.xacro", (("a", "1"),)),
        ('command="xacro $(find q)/r.xacro"', None, ()),
        ('command="make_robot $(find p)/r.xacro"', None, None),
    ],
)
def test_a_description_names_a_file_and_arguments(
    param: str, path: str | None, arguments: tuple[tuple[str, str], ...] | None
) -> None:
    (description,) = launch(f'<param name="robot_description" {param}/>').descriptions
    assert (description.file.path, description.arguments, description.namespace) == (path, arguments, "")


def test_a_description_of_another_name_counts_where_none_has_the_usual_one() -> None:
    usual = '<param name="robot_description" textfile="$(find p)/r.urdf"/>'
    box = '<param name="box_description" textfile="$(find p)/box.urdf"/>'
    found = launch(box + '<param name="long_description" value="x"/>').descriptions
    assert [one.file.path for one in found] == ["/p/box.urdf"]
    assert [one.file.path for one in launch(box + usual).descriptions] == ["/p/r.urdf"]


def described(name: str) -> str:
    return f'<param name="robot_description" textfile="$(find p)/{name}.urdf"/>'


def robots(inside: str) -> list[tuple[str | None, str | None]]:
    """The file and the namespace of each robot."""
    return [(robot.file.path, robot.namespace) for robot in launch(inside).robots]


@pytest.mark.parametrize(
    "private",
    [
        f'<node name="n" pkg="p" type="t">{described("r")}</node>',
        f'<group ns="b">{described("r")}</group>',
        described("r"),
    ],
)
def test_the_same_description_in_a_namespace_below_is_no_other_robot(private: str) -> None:
    assert robots(described("r") + private) == [("/p/r.urdf", "")]


def test_a_private_description_belongs_to_the_namespace_of_its_node() -> None:
    node = f'<node name="n" pkg="p" type="t">{described("r")}</node>'
    assert robots(f'<group ns="a">{node}</group>') == [("/p/r.urdf", "/a")]
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="c"/>'
    assert robots(f'{node}<group ns="n">{spawner}</group>') == [("/p/r.urdf", "/n")]


def test_of_two_robots_each_has_what_is_in_its_namespace() -> None:
    arm = '<rosparam file="$(find p)/c.yaml"/><node name="s" pkg="controller_manager" type="spawner" args="c"/>'
    both = "".join(f'<group ns="{name}">{described(name)}{arm}</group>' for name in ("left", "right"))
    made = launch(both)
    assert robots(both) == [("/p/left.urdf", "/left"), ("/p/right.urdf", "/right")]
    for robot in made.robots:
        mine = made.among(robot)
        assert [spawn.namespace for spawn in mine.spawns] == [robot.namespace]
        assert [load.namespace for load in mine.loads] == [robot.namespace]
    assert len(launch(described("r") + arm).among(made.robots[0]).loads) == 1


def test_of_two_descriptions_of_one_namespace_the_one_that_is_set_last_is_the_robot() -> None:
    assert robots(described("r") + described("s")) == [("/p/s.urdf", "")]


def test_what_may_be_included_is_worth_checking_on_its_own() -> None:
    one, other = (f'<include {when} file="$(find p)/inner.launch"/>' for when in ("", 'if="$(env X)"'))
    assert launch(described("r") + one, inner="").unfollowed == ()
    assert launch(described("r") + other, inner="").unfollowed == ("/p/inner.launch",)
    assert launch(one, inner="").unfollowed == ("/p/inner.launch",)


def test_an_argument_under_a_false_condition_is_not_declared() -> None:
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="$(arg a)"/>'
    first = '<arg name="a" default="x" if="false"/>'
    assert launch(f'{first}<arg name="a" default="y" unless="false"/>{spawner}').started == ("/y",)
    assert launch(first + spawner).started is None


@pytest.mark.parametrize(
    ("attributes", "namespace"),
    [("", "/g"), ('ns="n"', "/g/n"), ('param="q"', "/g/q"), ('ns="/n" param="q"', "/n/q"), ('ns="$(env N)"', None)],
)
def test_parameters_are_loaded_below_a_namespace(attributes: str, namespace: str | None) -> None:
    (load,) = launch(f'<group ns="g"><rosparam file="$(find p)/c.yaml" {attributes}/></group>').loads
    assert (load.file.path, load.namespace, load.in_node) == ("/p/c.yaml", namespace, False)


def test_parameters_in_a_node_are_its_own() -> None:
    (load,) = launch('<node name="n" ns="g" pkg="p" type="t"><rosparam file="/c.yaml"/></node>').loads
    assert (load.namespace, load.in_node) == ("/g/n", True)


@pytest.mark.parametrize(
    ("condition", "counts"),
    [
        ('if="true"', True),
        ('if="$(arg yes)"', True),
        ('unless="$(arg yes)"', False),
        ("if=\"$(eval arg('kind') == 'sim')\"", True),
        ("if=\"$(eval kind != 'sim')\"", False),
        ('if="$(eval not yes)"', False),
        ('if="$(eval yes and kind)"', None),
        ("if=\"$(eval not arg('empty'))\"", True),
        ("if=\"$(eval arg('dof') == 6)\"", True),
        ("if=\"$(eval arg('dof') == '6')\"", False),
        ('if="$(eval dof > 6 or dof &lt; 3)"', False),
        ("if=\"$(eval kind == 'sim' and not empty)\"", True),
        ("if=\"$(eval kind == 'sim' and open)\"", None),
        ("if=\"$(eval not optenv('OS', 'unknown').lower().startswith('windows'))\"", True),
        ("if=\"$(eval find('p') == '/p')\"", True),
        ('if="$(eval __import__)"', None),
        ('if="$(env X)"', None),
        ('if="$(optenv X 1)"', True),
        ('if="$(arg open)"', None),
    ],
)
def test_a_condition_counts_does_not_count_or_is_not_known(condition: str, counts: bool | None) -> None:
    arguments = '<arg name="yes" default="1"/><arg name="kind" value="sim"/><arg name="open"/>'
    arguments += '<arg name="dof" default="6"/><arg name="empty" default=""/>'
    loads = launch(f'{arguments}<rosparam file="/c.yaml" {condition}/>').loads
    assert [load.sure for load in loads] == ([] if counts is False else [counts is True])


def test_included_files_get_arguments_and_namespace() -> None:
    outer = '<include file="$(find p)/inner.launch" ns="o"><arg name="name" value="a"/></include>'
    inner = '<arg name="name" default="b"/><node name="s" pkg="controller_manager" type="spawner" args="$(arg name)"/>'
    made = launch(outer, inner=inner)
    assert made.started == ("/o/a",)
    assert launch(inner, {"name": "c"}).started == ("/c",)
    assert launch(
        '<arg name="name" value="d"/><include file="/p/inner.launch" pass_all_args="true"/>', inner=inner
    ).started == ("/d",)


@pytest.mark.parametrize(
    "extra",
    [
        '<include file="$(find p)/missing.launch"/>',
        '<include file="$(find q)/x.launch"/>',
        '<node name="t" pkg="controller_manager" type="spawner" args="$(env X)"/>',
        '<node if="$(env X)" name="t" pkg="controller_manager" type="spawner" args="b"/>',
    ],
)
def test_what_is_started_is_known_only_where_all_of_it_is(extra: str) -> None:
    known = '<node name="s" pkg="controller_manager" type="spawner" args="a"/>'
    assert launch(known + '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>').started == ("/a",)
    assert launch(known + extra).started is None


def test_files_that_include_each_other_come_to_an_end() -> None:
    again = '<include file="/p/main.launch"/>' * 3
    assert not launch(again).complete
