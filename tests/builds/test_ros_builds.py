"""The packages for ROS's builds, with stand-ins for the functions of ament and catkin that they call."""

from __future__ import annotations

import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
import tomli
import yaml
from folder import CHECKOUT

needs_cmake = pytest.mark.skipif(
    shutil.which("cmake") is None or shutil.which("ctest") is None, reason="CMake is not installed"
)
ROS = CHECKOUT / "ros"
SOUND = '<robot name="r"><link name="base"/></robot>\n'
BROKEN = SOUND.replace(
    "</robot>", '<joint name="j" type="fixed"><parent link="base"/><child link="no"/></joint></robot>'
)
AMENT = """
set(AMENT_TEST_RESULTS_DIR "${CMAKE_BINARY_DIR}/test_results")
function(ament_add_test name)
  cmake_parse_arguments(A "" "TIMEOUT;OUTPUT_FILE;RESULT_FILE;WORKING_DIRECTORY" "COMMAND" ${ARGN})
  if(A_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "ament_add_test() called with unused arguments: ${A_UNPARSED_ARGUMENTS}")
  endif()
  add_test(NAME "${name}" COMMAND ${A_COMMAND} WORKING_DIRECTORY "${A_WORKING_DIRECTORY}")
  set_tests_properties("${name}" PROPERTIES TIMEOUT "${A_TIMEOUT}")
endfunction()
"""
CATKIN = """
set(CATKIN_ENABLE_TESTING ON)
set(CATKIN_TEST_RESULTS_DIR "${CMAKE_BINARY_DIR}/test_results")
function(catkin_run_tests_target type name xunit_filename)
  cmake_parse_arguments(A "" "WORKING_DIRECTORY" "COMMAND;DEPENDENCIES" ${ARGN})
  if(A_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "catkin_run_tests_target() called with unused arguments: ${A_UNPARSED_ARGUMENTS}")
  endif()
  add_test(NAME "${type}" COMMAND sh -c "${A_COMMAND}" WORKING_DIRECTORY "${A_WORKING_DIRECTORY}")
endfunction()
"""


def ended(folder: Path, call: str, robot: str, *, file: Path, stand_in: str) -> tuple[int, str]:
    """Configure a package with a robot that calls a function of ours, run its tests, and return how they end."""
    program = folder / "bin" / "urdfctl"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nPYTHONPATH="{CHECKOUT}" exec "{sys.executable}" -m urdfctl "$@"\n')
    program.chmod(0o755)
    (folder / "robot.urdf").write_text(robot)
    lines = ["cmake_minimum_required(VERSION 3.12)", "project(my_robot NONE)", "enable_testing()", stand_in]
    (folder / "CMakeLists.txt").write_text("\n".join([*lines, f'include("{file}")', call, ""]))
    build = folder / "build"
    configure = ["cmake", "-S", str(folder), "-B", str(build), f"-DURDFCTL={program}"]
    subprocess.run(configure, check=True, capture_output=True, text=True)
    (build / "test_results" / "my_robot").mkdir(parents=True)
    done = subprocess.run(["ctest", "--output-on-failure"], cwd=build, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


@needs_cmake
@pytest.mark.parametrize(("robot", "status"), [(BROKEN, 8), (SOUND, 0)])
def test_ament_urdfctl_is_a_test_of_a_package_whose_findings_are_in_xunit(
    tmp_path: Path, robot: str, status: int
) -> None:
    file = ROS / "ament_urdfctl" / "cmake" / "ament_urdfctl.cmake"
    call = "ament_urdfctl(COMMAND lint robot.urdf --distro jazzy)"
    status_of_ctest, said = ended(tmp_path, call, robot, file=file, stand_in=AMENT)
    assert status_of_ctest == status, said
    results = ET.parse(tmp_path / "build" / "test_results" / "my_robot" / "urdfctl.xunit.xml")
    assert bool(results.findall(".//failure")) == (status != 0)


@needs_cmake
@pytest.mark.parametrize(("robot", "status"), [(BROKEN, 8), (SOUND, 0)])
def test_catkin_urdfctl_is_a_test_of_a_package_whose_findings_are_in_xunit(
    tmp_path: Path, robot: str, status: int
) -> None:
    file = ROS / "catkin_urdfctl" / "cmake" / "catkin_urdfctl.cmake"
    call = "catkin_urdfctl(COMMAND lint robot.urdf --distro noetic)"
    status_of_ctest, said = ended(tmp_path, call, robot, file=file, stand_in=CATKIN)
    assert status_of_ctest == status, said
    results = ET.parse(tmp_path / "build" / "test_results" / "my_robot" / "urdfctl.xml")
    assert bool(results.findall(".//failure")) == (status != 0)


@pytest.mark.parametrize("name", ["ament_urdfctl", "catkin_urdfctl"])
def test_the_manifests_name_the_key_that_rosdep_would_get(name: str) -> None:
    needed = ET.parse(ROS / name / "package.xml").findtext("exec_depend")
    assert needed in yaml.safe_load((CHECKOUT / "packaging" / "rosdep.yaml").read_text("utf-8"))


def test_the_conda_recipe_asks_for_what_pyproject_asks_for() -> None:
    project = tomli.loads((CHECKOUT / "pyproject.toml").read_text("utf-8"))["project"]
    recipe = yaml.safe_load((CHECKOUT / "packaging" / "recipe.yaml").read_text("utf-8"))
    wanted = {one.split(";")[0].strip() for one in project["dependencies"]}
    given = {one.replace(" ", "") for one in recipe["requirements"]["run"] if not one.startswith("python ")}
    assert given == wanted
