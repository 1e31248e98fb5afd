"""Conditions and attributes inside of nodes and includes of ROS 1, which launch files of ROS 2 have in another form."""

from __future__ import annotations

import ast

import pytest
from folder import Folder

MANIFEST = "<package format='2'><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>"
SPAWNER = '<node name="s" pkg="controller_manager" type="spawner" args="leg_controller"/>'
LAUNCH = f'<launch><arg name="fast" default="false"/>{SPAWNER}{{}}</launch>'
NODE = '<node name="n" pkg="arm" type="mover"{}>{}</node>'


def migrated(folder: Folder, body: str, *words: str) -> tuple[str, str]:
    """The launch file and the report after a migration."""
    folder.write({"arm/package.xml": MANIFEST, "arm/launch/go.launch": LAUNCH.format(body), "arm/scripts/mover": "#!"})
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--simulator", "none", "-o", "out", *words)
    assert ran.returncode == 0, ran.stderr
    [path] = (folder.path / "out").rglob("go.launch.*")
    return path.read_text(), "".join(each.read_text() for each in (folder.path / "out").rglob("MIGRATION.md"))


def test_each_branch_of_a_condition_inside_of_a_node_is_a_node_of_its_own(folder: Folder) -> None:
    both = '<param name="speed" value="9" if="$(arg fast)"/><param name="speed" value="1" unless="$(arg fast)"/>'
    text, _ = migrated(folder, NODE.format("", both))
    ast.parse(text)
    assert text.count('executable="mover"') == 2
    assert (text.count("IfCondition("), text.count("UnlessCondition(")) == (1, 1)
    assert ('{"speed": 9}' in text, '{"speed": 1}' in text) == (True, True)


def test_a_condition_inside_of_an_include_chooses_between_two_includes(folder: Folder) -> None:
    body = '<include file="$(find arm)/launch/go.launch"><arg name="fast" value="true" unless="$(arg fast)"/></include>'
    text, _ = migrated(folder, body, "--launch", "xml")
    assert text.count("<include ") == 2
    assert text.count('<arg name="fast" value="true"/>') == 1


@pytest.mark.parametrize(
    ("attributes", "children", "says"),
    [
        (' required="true"', "", "on_exit=Shutdown()"),
        (' respawn="true" respawn_delay="4"', "", "respawn_delay=4.0"),
        (' launch-prefix="nice -n 5"', "", 'prefix="nice -n 5"'),
        ("", '<env name="PORT" value="$(arg fast)"/>', 'additional_env={"PORT": LaunchConfiguration("fast")}'),
    ],
)
def test_an_attribute_of_a_node_keeps_its_meaning(folder: Folder, attributes: str, children: str, says: str) -> None:
    text, _ = migrated(folder, NODE.format(attributes, children))
    ast.parse(text)
    assert says in text


@pytest.mark.parametrize(
    ("attributes", "says"),
    [
        (' machine="far"', "ran on machine 'far'"),
        (' cwd="node"', 'had cwd="node"'),
        (' clear_params="true"', "clear_params"),
    ],
)
def test_an_attribute_without_counterpart_is_left_to_a_person(folder: Folder, attributes: str, says: str) -> None:
    assert says in migrated(folder, NODE.format(attributes, ""))[1].partition("## For you")[2]


def test_a_node_that_stops_controllers_when_it_ends_starts_none(folder: Folder) -> None:
    node = '<node name="u" pkg="controller_manager" type="unspawner" args="arm_controller"/>'
    text, report = migrated(folder, node + NODE.format("", ""))
    assert (text.count('executable="spawner"'), '"arm_controller"' in text) == (1, False)
    assert "'unspawner arm_controller' waited" in report
