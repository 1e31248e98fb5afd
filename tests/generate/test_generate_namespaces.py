"""The namespace of a robot is chosen when it is started, so that two robots can be in one world."""

from __future__ import annotations

import re

import pytest
from folder import Folder
from generating import command

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Severity
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.model.launch import Launch

WEIGHT = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
ROBOT = f"""<robot name="cart"><link name="root"/>
  <joint name="fix" type="fixed"><parent link="root"/><child link="base"/></joint>
  <link name="base">{WEIGHT}
    <collision><origin xyz="0.2 0 -0.05"/><geometry><sphere radius="0.05"/></geometry></collision>
    <collision><origin xyz="-0.2 0 -0.05"/><geometry><sphere radius="0.05"/></geometry></collision></link>
  <link name="left">{WEIGHT}<collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="right">{WEIGHT}<collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="left_wheel" type="continuous"><parent link="base"/><child link="left"/>
    <origin xyz="0 0.2 0"/><axis xyz="0 1 0"/><limit effort="5" velocity="10"/></joint>
  <joint name="right_wheel" type="continuous"><parent link="base"/><child link="right"/>
    <origin xyz="0 -0.2 0"/><axis xyz="0 1 0"/><limit effort="5" velocity="10"/></joint>
</robot>"""
SETUPS = [
    ("noetic", "gazebo-classic", "python"),
    *((distro, "gz", form) for distro in ("humble", "jazzy") for form in ("python", "xml", "yaml")),
    ("humble", "gazebo-classic", "python"),
    ("humble", "gazebo-classic", "yaml"),
    ("rolling", "none", "xml"),
    ("jazzy", "mujoco", "python"),
]


def package(folder: Folder, distro: str, simulator: str, form: str, *words: str) -> str:
    """The launch file of a generated package."""
    folder.write({"cart.urdf": ROBOT})
    options = ("--distro", distro, "--simulator", simulator, "--form", form, "-o", "made")
    ran = command("gen-all", "cart.urdf", *options, *words)
    assert ran.returncode == 0, ran.stderr
    return f"made/launch/control.launch{'' if distro == 'noetic' else {'python': '.py'}.get(form, f'.{form}')}"


def started(path: str, **arguments: str) -> Launch:
    """A launch file as it is started with some arguments; lint finds nothing in it."""
    target = Target(path, tuple(arguments.items()))
    linted = lint_target(Loader(Settings(workspace="made")), target, Selection())
    found = [one for one in linted.result.outcome.diagnostics if one.severity is not Severity.INFO]
    assert found == []
    assert linted.project.launch is not None
    return linted.project.launch


@pytest.mark.parametrize(("distro", "simulator", "form"), SETUPS)
def test_everything_is_in_the_namespace_of_the_launch_argument(
    distro: str, simulator: str, form: str, folder: Folder
) -> None:
    path = package(folder, distro, simulator, form)
    for space in ("", "two"):
        launch = started(path, namespace=space)
        own = [node for node in launch.nodes if node.executable.text not in ("parameter_bridge", "gzserver")]
        assert {(node.namespace or "").strip("/") for node in own} == {space}
        assert {(spawn.namespace or "").strip("/") for spawn in launch.spawns} == {space}
        assert {(one.namespace or "").strip("/") for one in launch.descriptions if one.node != "create"} == {space}
        expanded = command("expand", "made/urdf/robot.urdf.xacro", *([f"namespace:={space}"] if space else [])).stdout
        names = re.findall(r"<(?:namespace|robotNamespace)>/?(.*)</", expanded)
        assert names == ([space] if simulator in ("gz", "gazebo-classic") else [])


@pytest.mark.parametrize("setup", [one for one in SETUPS if one[1] in ("gz", "gazebo-classic")])
def test_a_second_robot_starts_no_second_simulator(setup: tuple[str, str, str], folder: Folder) -> None:
    path = package(folder, *setup)
    assert [one.simulator for one in started(path).simulations] == [setup[1]]
    second = started(path, namespace="two", simulator="false", x="1.0")
    assert second.simulations == ()
    assert "parameter_bridge" not in [node.executable.text for node in second.nodes]
    words = [[word.text for word in node.words] for node in second.nodes if "1.0" in [one.text for one in node.words]]
    assert len(words) == 1
    assert ("two" in words[0]) == (setup[0] != "noetic")  # in ROS 1 the name is an argument


def test_the_namespace_of_the_option_is_the_default(folder: Folder) -> None:
    for distro, simulator, form in (("noetic", "gazebo-classic", "python"), ("jazzy", "gz", "python")):
        path = package(folder, distro, simulator, form, "--namespace", "one", "--force")
        assert {(spawn.namespace or "").strip("/") for spawn in started(path).spawns} == {"one"}


def test_a_plugin_of_the_robot_keeps_its_namespace(folder: Folder) -> None:
    plugin = """<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
      <ros><namespace>one</namespace></ros><parameters>$(find made)/config/controllers.yaml</parameters>
      </plugin></gazebo></robot>"""
    folder.write({"cart.urdf": ROBOT.replace("</robot>", plugin)})
    words = ("cart.urdf", "--distro", "jazzy", "--simulator", "gz", "--namespace", "one", "-o", "made")
    assert command("gen-all", *words).returncode == 0
    launch = started("made/launch/control.launch.py")
    assert "namespace" not in dict(launch.arguments)
    assert {spawn.namespace for spawn in launch.spawns} == {"/one"}
