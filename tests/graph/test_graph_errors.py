"""The graph carries every error of lint: at the part that it is about, also if nothing is wired to it."""

from __future__ import annotations

import json

import pytest
from folder import Folder
from generating import command

LINK = """<link name="{name}"><inertial><mass value="{mass}"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>"""
JOINT = """<joint name="j" type="revolute"><parent link="a"/><child link="b"/>
  <limit lower="-1" upper="1" effort="5" velocity="1"/></joint>"""
HARDWARE = """<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
  <joint name="j"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm: {type: TYPE}
arm:
  ros__parameters: {joints: [j], interface_name: position}
"""
FORWARD = "forward_command_controller/ForwardCommandController"


def broken(
    folder: Folder, *words: str, mass: str = "1", hardware: str = HARDWARE, controllers: str = CONTROLLERS
) -> set[str]:
    """The nodes of a robot's graph that have a rule, with it."""
    links = LINK.format(name="a", mass="1") + LINK.format(name="b", mass=mass)
    folder.write({"r.urdf": f'<robot name="r">{links}{JOINT}{hardware}</robot>', "c.yaml": controllers})
    ran = command("graph", "r.urdf", "c.yaml", "--distro", "jazzy", *words, "--format", "json")
    assert ran.returncode == 0, ran.stderr
    return {f"{node['id']} {code}" for node in json.loads(ran.stdout)["nodes"] for code in node["rules"]}


def test_a_sound_robot_has_no_error_and_no_node_for_one(folder: Folder) -> None:
    assert broken(folder, controllers=CONTROLLERS.replace("TYPE", FORWARD)) == set()


def test_an_error_about_a_link_is_at_the_link(folder: Folder) -> None:
    found = broken(folder, "--simulator", "gz", mass="-1", controllers=CONTROLLERS.replace("TYPE", FORWARD))
    assert "link:b UC135" in found


def test_an_error_about_a_type_that_does_not_exist_is_at_the_controller(folder: Folder) -> None:
    found = broken(folder, controllers=CONTROLLERS.replace("TYPE", FORWARD.replace("Forward", "Forwrad")))
    assert "controller:/arm UC421" in found


def test_an_error_in_a_component_that_offers_nothing_is_at_the_component(folder: Folder) -> None:
    hardware = """<ros2_control name="hw" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="j"/></transmission>
      </ros2_control>"""
    found = broken(folder, hardware=hardware, controllers=CONTROLLERS.replace("TYPE", FORWARD))
    assert "hardware:hw UC324" in found


@pytest.mark.parametrize("form", ["mermaid", "dot", "svg", "html"])
def test_every_drawing_shows_it(folder: Folder, form: str) -> None:
    gz = ("--simulator", "gz")
    broken(folder, *gz, mass="-1", controllers=CONTROLLERS.replace("TYPE", FORWARD))
    assert "UC135" in command("graph", "r.urdf", "c.yaml", "--distro", "jazzy", *gz, "--format", form).stdout
