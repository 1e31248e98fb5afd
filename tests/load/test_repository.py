"""The files around a package name its distro: containers, CI, what is built beside it, and at last its README."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

MANIFEST = "<package format='3'><name>p</name><export><build_type>ament_cmake</build_type></export></package>"
ROBOT = (
    "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='continuous'><parent link='a'/><child "
    "link='b'/></joint><ros2_control name='s' type='system'><hardware><plugin>own/System</plugin></hardware>"
    "<joint name='j'><command_interface name='velocity'/></joint></ros2_control></robot>"
)
LAUNCH = """
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'cat $(find-pkg-share p)/r.urdf')" type="str"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node"/>
</launch>
"""
"""In humble the manager gets no description; in jazzy it reads the topic that robot_state_publisher publishes."""
PACKAGE = {"src/p/package.xml": MANIFEST, "src/p/r.urdf": ROBOT, "src/p/launch/r.launch.xml": LAUNCH, ".git/HEAD": ""}


def distro_of(folder: Folder) -> tuple[str | None, str]:
    """The distro that lint takes, and what it has it from."""
    target = report(folder)["targets"][0]
    return target["distro"], target["distro_from"]


def report(folder: Folder, path: str = ".") -> dict[str, Any]:
    given: dict[str, Any] = json.loads(folder.run("lint", path, "--format", "json", "--exit-zero").stdout)
    return given


@pytest.mark.parametrize(
    ("file", "text", "line"),
    [
        ("Dockerfile", "# the base\nFROM ros:humble-ros-base\n", 2),
        ("docker/Dockerfile.dev", "FROM osrf/ros:humble-desktop-full\n", 1),
        ("Dockerfile", "ARG ROS_DISTRO=humble\nFROM ros:${ROS_DISTRO}\n", 1),
        ("src/p/Dockerfile", "FROM ubuntu:22.04\nRUN apt install -y ros-humble-desktop\n", 2),
        (".devcontainer/devcontainer.json", '{\n  "image": "ros:humble"\n}\n', 2),
        (".github/workflows/ci.yml", "env:\n  ROS_DISTRO: humble\n", 2),
        (".github/workflows/ci.yml", "with:\n  required-ros-distributions: humble\n", 2),
        (".github/workflows/ci.yml", "with:\n  target-ros2-distro: humble\n", 2),
        (".gitlab-ci.yml", "build:\n  image: ros:humble\n", 2),
        ("p.repos", "repositories:\n  q:\n    type: git\n    version: humble\n", 4),
        ("compose.yaml", "services:\n  robot:\n    image: my/robot\n    environment: [ROS_DISTRO=humble]\n", 4),
        ("README.md", "Run\n\n    source /opt/ros/humble/setup.bash\n", 3),
        ("README.md", "It works with ROS 2 Humble Hawksbill.\n", 1),
    ],
)
def test_the_distro_is_the_one_that_a_file_of_the_repository_names(
    file: str, text: str, line: int, folder: Folder
) -> None:
    folder.write({**PACKAGE, file: text})
    assert distro_of(folder) == ("humble", f"{file}:{line}")


@pytest.mark.parametrize(
    "text", ["FROM ros_humble:latest\n", "FROM python:3.12\nRUN echo jazzy music\n", "# gazebo: humble servant\n"]
)
def test_a_name_in_another_meaning_is_no_evidence(text: str, folder: Folder) -> None:
    folder.write({**PACKAGE, "Dockerfile": text})
    assert distro_of(folder)[0] is None


def test_several_distros_that_are_named_are_all_possible(folder: Folder) -> None:
    matrix = "matrix:\n  ros_distro: [humble, jazzy]\n"
    folder.write({**PACKAGE, ".github/workflows/ci.yml": matrix, "README.md": "ros-kilted-desktop\n"})
    assert distro_of(folder)[0] is None
    told = folder.run("lint", ".").stdout + folder.run("lint", ".").stderr
    assert "(humble to jazzy)" in told or "(humble or jazzy)" in told or "humble and jazzy" in told


def test_the_nearest_folder_counts(folder: Folder) -> None:
    folder.write({**PACKAGE, "Dockerfile": "FROM ros:humble\n", "src/p/Dockerfile": "FROM ros:jazzy\n"})
    assert distro_of(folder) == ("jazzy", "src/p/Dockerfile:1")


def test_a_readme_counts_only_where_nothing_else_names_a_distro(folder: Folder) -> None:
    readme = "source /opt/ros/jazzy/setup.bash\n"
    folder.write({**PACKAGE, "src/p/README.md": readme, "Dockerfile": "FROM ros:humble\n"})
    assert distro_of(folder) == ("humble", "Dockerfile:1")


@pytest.mark.parametrize(
    ("setup", "known"),
    [
        ('COLCON_CURRENT_PREFIX="/opt/ros/humble"\n', ("humble", "install/setup.sh:2")),
        ("echo /opt/ros/humble\n", (None, "<ros2_control>")),
        ('COLCON_CURRENT_PREFIX="/home/me/other/install"\n', (None, "<ros2_control>")),
    ],
)
def test_what_a_workspace_is_built_on_counts_before_what_its_repositories_support(
    setup: str, known: tuple[str | None, str], folder: Folder
) -> None:
    matrix = "matrix:\n  ros_distro: [humble, jazzy]\n"
    folder.write({**PACKAGE, "src/p/.github/workflows/ci.yml": matrix, "install/setup.sh": f"# colcon\n{setup}"})
    assert distro_of(folder) == known


def test_the_other_generation_is_no_distro_of_a_package(folder: Folder) -> None:
    folder.write({**PACKAGE, ".github/workflows/ci.yml": "ros_distro: [noetic, humble]\n"})
    assert distro_of(folder)[0] == "humble"


@pytest.mark.parametrize(
    ("readme", "severity"), [("Made for ROS 2 Humble.\n", "warning"), ("`ros-humble-desktop`\n", "error")]
)
def test_what_holds_only_in_the_distro_of_a_readmes_prose_is_a_warning(
    readme: str, severity: str, folder: Folder
) -> None:
    folder.write({**PACKAGE, "README.md": readme})
    found = {finding["code"]: finding["severity"] for finding in report(folder)["findings"]}
    assert found["UC611"] == severity


@pytest.mark.parametrize(
    ("launch", "ros"),
    [
        ('<launch><node name="a" pkg="p" type="x"/></launch>', 1),
        ('<launch><node name="a" pkg="p" exec="x"/></launch>', None),
        ('<launch><node pkg="p" type="x"/><node pkg="p" exec="x"/></launch>', None),
        ("<launch/>", None),
    ],
)
def test_launch_files_beside_a_robot_tell_the_generation_where_nothing_else_does(
    launch: str, ros: int | None, folder: Folder
) -> None:
    folder.write({".git/HEAD": "", "worlds/objects/table.urdf": '<robot name="r"><link name="a"/></robot>'})
    folder.write({"worlds/launch/table.launch": launch})
    [target] = report(folder, "worlds/objects/table.urdf")["targets"]
    assert target["ros"] == ros


@pytest.mark.parametrize(("other", "ros"), [("ament_cmake", 2), ("catkin", 1)])
def test_a_robot_outside_of_packages_is_for_the_generation_of_all_of_them(other: str, ros: int, folder: Folder) -> None:
    manifest = MANIFEST.replace("<name>p", "<name>q").replace("ament_cmake", other)
    folder.write({**PACKAGE, "src/q/package.xml": manifest, "Dockerfile": "FROM ros:noetic\n"})
    folder.write({"urdf/table.urdf": '<robot name="r"><link name="a"/></robot>'})
    [target] = report(folder, "urdf/table.urdf")["targets"]
    assert target["ros"] == ros
