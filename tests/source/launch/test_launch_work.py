"""Launch files whose values grow without end: their work and their memory are bounded, and it is said once."""

from __future__ import annotations

from pathlib import Path

import pytest
from work import work

from urdfctl.config.settings import Settings
from urdfctl.load.launch_files import LaunchFile, read_launch
from urdfctl.load.loader import Loader
from urdfctl.source.lengths import MOST_CHARACTERS, TOO_LONG

PYTHON = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, SetLaunchConfiguration
from launch.conditions import IfCondition
from launch.substitutions import *
from launch_ros.actions import Node

def generate_launch_description():
    here = LaunchDescription()
    a0 = 'xxxxxxxx'
    v0 = [TextSubstitution(text='xxxxxxxx')]
    here.add_action(DeclareLaunchArgument('a0', default_value='xxxxxxxx'))
{}    return here
"""
OLD = '<node pkg="controller_manager" type="spawner" name="s" args="c $(arg a39)"/>'
NEW = '<node pkg="controller_manager" exec="spawner" args="c $(var a39)"/>'
MOST_CALLS = 400_000
"""A file of forty arguments, read once or twice, takes a tenth of this."""


def doubling(line: str) -> str:
    """The line for the numbers from 1 to 39: `@` is the number, `#` the one before it."""
    return "".join(line.replace("@", str(n)).replace("#", str(n - 1)) for n in range(1, 40))


def in_python(line: str, last: str) -> str:
    return PYTHON.format(doubling(f"    {line}\n") + f"    {last}\n")


SPAWNED = "here.add_action(Node(package='controller_manager', executable='spawner', arguments=['c', @]))"
OF_ARGUMENT = SPAWNED.replace("@", "LaunchConfiguration('a39')")
DECLARED = "here.add_action(DeclareLaunchArgument('a@', default_value={}))"
DOUBLING = {
    "a.launch": '<launch><arg name="a0" default="xxxxxxxx"/>'
    + doubling("""<arg name="a@" default="$(arg a#)$(arg a#)"/>""")
    + f"{OLD}</launch>",
    "eval.launch": '<launch><arg name="a0" default="xxxxxxxx"/>'
    + doubling("""<arg name="a@" default="$(eval arg('a#') + arg('a#'))"/>""")
    + f"{OLD}</launch>",
    "include.launch": '<launch><arg name="a0" default="xxxxxxxx"/><arg name="b" default="$(arg a0)$(arg a0)"/>'
    '<include file="$(dirname)/include.launch"><arg name="a0" value="$(arg b)"/></include></launch>',
    "long.launch": '<launch><arg name="a0" default="' + "x" * MOST_CHARACTERS + '"/>'
    '<arg name="a39" default="' + "$(arg a0)" * 20_000 + f'"/>{OLD}</launch>',
    "a.launch.xml": '<launch><arg name="a0" default="xxxxxxxx"/>'
    + doubling("""<let name="a@" value="$(var a#)$(var a#)"/>""")
    + f"{NEW}</launch>",
    "a.launch.yaml": "launch:\n- arg: {name: a0, default: xxxxxxxx}\n"
    + doubling("- let: {name: a@, value: $(var a#)$(var a#)}\n")
    + "- node: {pkg: controller_manager, exec: spawner, args: c $(var a39)}\n",
    "configurations.launch.py": in_python(
        DECLARED.format("[LaunchConfiguration('a#'), LaunchConfiguration('a#')]"), OF_ARGUMENT
    ),
    "paths.launch.py": in_python(
        DECLARED.format("PathJoinSubstitution([LaunchConfiguration('a#'), LaunchConfiguration('a#')])"), OF_ARGUMENT
    ),
    "expressions.launch.py": in_python(
        DECLARED.format(
            """PythonExpression(["'", LaunchConfiguration('a#'), "' + '", LaunchConfiguration('a#'), "'"])"""
        ),
        OF_ARGUMENT,
    ),
    "texts.launch.py": in_python("v@ = [TextSubstitution(text=''), *v#, *v#]", SPAWNED.replace("@", "v39")),
    "lists.launch.py": in_python("v@ = [v#, v#]", SPAWNED.replace("@", "v39")),
    "added.launch.py": in_python("a@ = a# + a#", SPAWNED.replace("@", "a39")),
    "f.launch.py": in_python("a@ = f'{a#}{a#}'", SPAWNED.replace("@", "a39")),
    "percent.launch.py": in_python("a@ = '%s%s' % (a#, a#)", SPAWNED.replace("@", "a39")),
    "format.launch.py": in_python("a@ = '{}{}'.format(a#, a#)", SPAWNED.replace("@", "a39")),
    "join.launch.py": in_python("a@ = ''.join([a#, a#])", SPAWNED.replace("@", "a39")),
    "os.launch.py": "import os\n" + in_python("a@ = os.path.join(a#, a#)", SPAWNED.replace("@", "a39")),
    "pathlib.launch.py": "from pathlib import Path\n"
    + in_python("a@ = Path(a#).joinpath(a#)", SPAWNED.replace("@", "str(a39)")),
    "wide.launch.py": in_python(
        "a@ = a# + a#[:1000]", "a39 = f'" + "{a10}" * 9000 + "'; " + SPAWNED.replace("@", "a39")
    ),
}
SILENT = {"lists.launch.py", "texts.launch.py"}
"""Those whose texts are short: only their lists are endless."""


def read(folder: Path, name: str, text: str) -> LaunchFile:
    (folder / name).write_text(text)
    path = str(folder / name)
    return read_launch(path, {}, *Loader(Settings()).reading(path), {})


@pytest.mark.parametrize("name", DOUBLING)
def test_values_that_double_take_little_work_and_are_told_once(name: str, tmp_path: Path) -> None:
    found: list[LaunchFile] = []
    assert work(lambda: found.append(read(tmp_path, name, DOUBLING[name]))) < MOST_CALLS
    told = [problem.message for problem in found[0].problems]
    assert told == ([] if name in SILENT else [TOO_LONG])
    assert found[0].launch is not None
    for spawn in found[0].launch.spawns:
        assert spawn.names[0][0] == "c"
        assert spawn.complete is (name == "texts.launch.py")


@pytest.mark.parametrize("opened", ["<group ns='$(arg a)'>"])
def test_a_namespace_in_a_namespace_is_not_endless(opened: str, tmp_path: Path) -> None:
    nested = opened * 150 + OLD.replace(" $(arg a39)", "") + "</group>" * 150
    text = f'<launch><arg name="a" default="{"x" * 9000}"/>{nested}</launch>'
    launch = read(tmp_path, "a.launch", text).launch
    assert launch is not None
    assert launch.spawns[0].namespace is None
    assert sum(len(node.namespace or "") for node in launch.nodes) <= MOST_CHARACTERS


def test_a_condition_on_a_list_in_a_list_takes_little_work(tmp_path: Path) -> None:
    text = in_python("v@ = [v#, v#]", "here.add_action(Node(package='p', executable='e', condition=IfCondition(v39)))")
    assert work(lambda: read(tmp_path, "a.launch.py", text)) < MOST_CALLS
