"""Files that are no launch files yet, and paths that lack an argument, say nothing about what is started."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MANIFEST = "<package><name>lathe</name><buildtool_depend>catkin</buildtool_depend></package>"
LOADING = """<launch>
  <arg name="tools" default="{}"/>
  <rosparam file="$(find lathe)/config/$(arg tools)"/>
</launch>"""
BROKEN = """<launch>
  <param name="robot_description" {}/>
  <node name="s" pkg="controller_manager" type="spawner" args="chuck"/>
</launch>"""


def codes(folder: Folder, launch: str) -> list[str]:
    folder.write(
        {
            "package.xml": MANIFEST,
            "config/tools.yaml": "chuck: {type: velocity_controllers/JointVelocityController, joint: spindle}\n",
            "config/old/tools.yaml": "",
            "launch/up.launch": launch,
        }
    )
    ran = folder.run("lint", "launch/up.launch", "--format", "json")
    found = json.loads(ran.stdout)["findings"] if ran.stdout else []
    return [each["code"] for each in found if each["severity"] == "error"]


def test_a_folder_in_the_place_of_a_file_is_an_error(folder: Folder) -> None:
    assert "UC004" in codes(folder, LOADING.format("old"))


def test_a_path_that_ends_where_an_argument_is_to_be_given_names_no_folder(folder: Folder) -> None:
    assert codes(folder, LOADING.format("")) == []


@pytest.mark.parametrize(
    "rest", ["[URDF_ATTRIBUTE]", "{{ description }}", "@ROBOT_FILE@", 'value="$(find <your-package>)"']
)
def test_a_launch_file_with_placeholders_is_not_read_as_xml(folder: Folder, rest: str) -> None:
    assert codes(folder, BROKEN.format(rest)) == []


def test_a_launch_file_that_is_no_xml_is_an_error(folder: Folder) -> None:
    assert codes(folder, BROKEN.format('value="robot" [urdf]')) == ["UC001"]
    assert codes(folder, BROKEN.format('value="$(find <robot>)"')) == ["UC001"]


ENTRY = """
from launch import LaunchDescription
{}
def generate_launch_description_{}():
    return LaunchDescription([])
"""


@pytest.mark.parametrize(
    ("name", "imported", "told"),
    [
        ("up.launch.py", "", ["UC037"]),
        ("up.launch.py", "from shared.entries import *", []),
        ("entries.py", "", []),
    ],
)
def test_a_function_that_launch_does_not_look_for(folder: Folder, name: str, imported: str, told: list[str]) -> None:
    folder.write({"package.xml": "<package format='3'><name>lathe</name><depend>launch</depend></package>"})
    folder.write({f"launch/{name}": ENTRY.format(imported, "real")})
    ran = folder.run("lint", f"launch/{name}", "--select", "UC037", "--format", "json")
    assert [each["code"] for each in (json.loads(ran.stdout)["findings"] if ran.stdout else [])] == told
