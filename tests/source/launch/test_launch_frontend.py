"""Launch files of ROS 2 in XML and YAML build the same as those in Python."""

from __future__ import annotations

import pytest

from urdfctl.model.launch import Launch
from urdfctl.model.launch.ros2 import Ros2Sources, launch_of_ros2
from urdfctl.source.launch.frontend import description, of_xml, of_yaml, words_of
from urdfctl.source.launch.terms import Constant, Items, Term
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xml.parsing import parse
from urdfctl.source.yaml.tree import read_yaml


def launch(text: str, **others: str) -> Launch:
    """The facts of a file in XML, or in YAML; p is the only package, and may have others by name."""
    files = {f"/p/{name}": content for name, content in {"main": text, **others}.items()}

    def read(path: str) -> Term | None:
        if path not in files:
            return None
        source = SourceText(path, files[path].encode())
        root = of_xml(parse(source).documentElement) if files[path].startswith("<") else of_yaml(read_yaml(source))
        return description(root) if root else None

    def find(name: str, _: Place) -> str | None:
        return "/p" if name == "p" else None

    found = launch_of_ros2("/p/main", {}, Ros2Sources(read, lambda path: (path, True), find, {"HERE": "x"}))
    assert found is not None
    return found


def spawned(args: str) -> list[str]:
    made = launch(
        '<launch><let name="a" value="arm"/><let name="yes" value="true"/>'
        f'<node pkg="controller_manager" exec="spawner" args="{args}"/></launch>'
    )
    return [name for spawn in made.spawns for name, _ in spawn.names]


@pytest.mark.parametrize(
    ("args", "names"),
    [
        ("a  b", ["a", "b"]),
        ("$(var a)", ["arm"]),
        ("$(var unset fallback)", ["fallback"]),
        ("left_$(var a)", ["left_arm"]),
        ("$(env HERE) $(env NOWHERE 'y z')", ["x", "y z"]),
        ("$(eval '&quot;$(var a)&quot; == &quot;arm&quot;')", ["True"]),
        (r"$(eval '\'$(var a)\' == \'arm\'')", ["True"]),
        ("$(env NOWHERE) b", ["b"]),
        ("$(not $(var yes))", ["false"]),
        ("$(equals $(var a) arm)", ["true"]),
        ("$(anon n) $(var a", []),
        ("'a'", ["a"]),
        ("'a b' --controller-ros-args '-r ~/x:=/z' c", ["a b", "c"]),
    ],
)
def test_substitutions_give_what_they_give_in_python(args: str, names: list[str]) -> None:
    assert spawned(args) == names


def test_a_word_stands_where_it_is_written() -> None:
    text = b'<node args="arm  --inactive"/>'
    words = words_of(Constant("arm  --inactive", Place(SourceText("x", text), 12, end=27)))
    assert isinstance(words, Items)
    assert [word.at.span.text for word in words.values] == ["arm", "--inactive"]


CONDITIONS = {
    '<node pkg="controller_manager" exec="spawner" args="arm" if="$(var sim)"/>': True,
    '<node pkg="controller_manager" exec="spawner" args="arm" unless="$(var sim)"/>': False,
    '<group if="$(env NOWHERE)"><node pkg="controller_manager" exec="spawner" args="arm"/></group>': None,
}


@pytest.mark.parametrize(("inside", "held"), CONDITIONS.items())
def test_conditions_hold_or_not(inside: str, held: bool | None) -> None:
    made = launch(f'<launch><arg name="sim" default="true"/>{inside}</launch>')
    assert [spawn.sure for spawn in made.spawns] == ([] if held is False else [held is True])
    assert [name for spawn in made.elsewhere for name, _ in spawn.names] == (["arm"] if held is False else [])


def test_a_description_is_read_from_a_command() -> None:
    made = launch(
        '<launch><arg name="a" default="1"/><node pkg="robot_state_publisher" exec="robot_state_publisher">'
        '<param name="robot_description" value="$(command \'xacro $(find-pkg-share p)/r.xacro a:=$(var a)\' warn)"/>'
        "</node></launch>"
    )
    assert [(d.file.path, d.arguments) for d in made.descriptions] == [("/p/r.xacro", (("a", "1"),))]


def test_what_is_no_element_of_ros_2_may_do_anything() -> None:
    assert not launch("<launch><rosparam file='x'/></launch>").complete
    assert launch("<launch><log message='x'/></launch>").complete


def test_yaml_without_a_list_of_actions_is_no_launch_file() -> None:
    source = SourceText("x", b"launch: {a: 1}")
    assert of_yaml(read_yaml(source)) is None


def test_an_argument_that_is_declared_after_an_include_is_the_files_own_and_one_in_it_is_not() -> None:
    inner = '<launch><arg name="speed" default="1"/></launch>'
    include = '<include file="$(find-pkg-share p)/inner"/>'
    made = launch(f'<launch><arg name="a"/>{include}<arg name="b" default="2"/></launch>', inner=inner)
    assert made.arguments == (("a", None), ("b", "2"))


def test_deep_files_come_to_an_end() -> None:
    launch("<launch>" + "<group>" * 150 + "</group>" * 150 + "</launch>")
    spawned("$(var " * 400 + ")" * 400)
    spawned("$(not " * 100 + ")" * 100)
