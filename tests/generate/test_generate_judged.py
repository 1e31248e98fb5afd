"""gen-all judges what it makes, writes nothing that would not start, and repairs impossible inertia in a copy."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence

import pytest
from folder import Folder
from generating import command

from urdfctl.commands.generate import judging, running
from urdfctl.commands.generate.model_check import CheckedModel
from urdfctl.generate.options import File
from urdfctl.generate.robot.inertia_repair import nearest_valid, with_valid_inertia
from urdfctl.smoke.checked_robot import CheckedRobot
from urdfctl.smoke.motion import engine_workers
from urdfctl.smoke.results import RobotResult

pytestmark = pytest.mark.usefixtures("judging_engine")
INERTIA = '<inertia ixx="{}" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
ARM = """\
<robot name="arm">
  <link name="world"/>
  <joint name="foot" type="fixed"><parent link="world"/><child link="base"/></joint>
  <link name="base"><inertial><mass value="5"/>{base}</inertial></link>
  <link name="upper">
    <inertial><origin xyz="0 0 0.1"/><mass value="2"/>{inertia}</inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="50" velocity="2"/>
  </joint>
</robot>
"""
GOOD, BAD = (ARM.format(base=INERTIA.format(0.01), inertia=INERTIA.format(moment)) for moment in (0.01, 5))


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ([0.02, 0, 0, 0.01, 0, 0.015], None),
        ([0.02, 0, 0, 0.01, 0, 0.01], None),
        ([5, 0, 0, 1, 0, 1], [4, 0, 0, 2, 0, 2]),
        ([1, 0, 0, 1, 0, 5], [2, 0, 0, 2, 0, 4]),
        ([-1, 0, 0, 1, 0, 1], [0.001, 0, 0, 1, 0, 1]),
        ([0, 0, 0, 0, 0, 0], [2e-4, 0, 0, 2e-4, 0, 2e-4]),
    ],
)
def test_the_nearest_valid_inertia_is_where_the_greatest_moment_is_the_sum(
    given: list[float], expected: list[float] | None
) -> None:
    valid = nearest_valid(given, 2.0)
    assert valid == (expected if expected is None else pytest.approx(expected, rel=2e-3, abs=1e-9))


def test_a_repaired_inertia_with_products_is_valid() -> None:
    valid = nearest_valid([0.1, 0.4, 0.0, 0.1, 0.0, 0.1], 1.0)
    assert valid is not None
    assert nearest_valid(valid, 1.0) is None


def test_only_impossible_inertia_given_in_numbers_is_repaired() -> None:
    assert with_valid_inertia(GOOD).changes == ()
    assert with_valid_inertia(BAD).changes == ("inertia of link 'upper': ixx 3.337, iyy 1.67, izz 1.67",)
    assert with_valid_inertia(BAD.replace('"5"', '"${i}"')).changes == ()


def test_a_package_that_gz_would_not_spawn_is_not_written(folder: Folder) -> None:
    folder.write({"arm.urdf": BAD})
    done = command(*"gen-all arm.urdf --type trajectory --distro jazzy --simulator gz -o made".split())
    assert done.returncode == 1
    assert "arm.urdf:6: UC901 the robot cannot be spawned" in done.stderr
    assert "add --fix-inertia" in done.stderr
    assert not (folder.path / "made").exists()


def test_a_robot_without_masses_is_not_written_for_gz(folder: Folder) -> None:
    folder.write({"arm.urdf": re.sub(r"<inertial>.*?</inertial>", "", GOOD)})
    done = command(*"gen-all arm.urdf --type trajectory --distro jazzy --simulator gz -o made".split())
    assert done.returncode == 1
    assert "UC901 the robot cannot be spawned: no link of the robot has an <inertial>" in done.stderr
    assert not (folder.path / "made").exists()


def test_a_robot_whose_own_driver_gz_cannot_load_is_not_written_for_gz(folder: Folder) -> None:
    driver = """<ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control></robot>"""
    folder.write({"arm.urdf": GOOD.replace("</robot>", driver)})
    done = command(*"gen-all arm.urdf --type trajectory --distro jazzy --simulator gz -o made".split())
    assert done.returncode == 1
    assert "UC902 the hardware cannot be started: 'mock_components/GenericSystem' is not simulated" in done.stderr


def test_the_repaired_copy_is_written_and_is_sound(folder: Folder) -> None:
    folder.write({"arm.urdf": BAD})
    done = command(*"gen-all arm.urdf --type trajectory --distro jazzy --simulator gz --fix-inertia -o made".split())
    assert (done.returncode, "inertia of link 'upper'" in done.stderr) == (0, True)
    assert command(*"lint made --fail-on warning".split()).returncode == 0
    assert command(*"smoke made --engine none".split()).returncode == 0


def test_a_sound_robot_is_written_without_a_word_about_it(folder: Folder) -> None:
    folder.write({"arm.urdf": GOOD})
    done = command(
        *"gen-all arm.urdf --type trajectory --interface effort --distro jazzy --simulator gz -o made".split()
    )
    assert (done.returncode, "UC9" in done.stderr) == (0, False)
    assert command(*"gen-all arm.urdf --fix-inertia --type trajectory --distro jazzy -o other".split()).returncode == 2


TWO = """\
<robot name="r">
  <link name="base">{visual}
    <inertial><mass value="1"/><inertia ixx="0.1" ixy="{xy}" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <link name="a">
    <inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <joint name="j" type="revolute"><parent link="base"/><child link="a"/>
    <limit lower="-1" upper="1" effort="5" velocity="1"/></joint>
</robot>
"""
FLAT = b" " * 80 + (1).to_bytes(4, "little") + bytes(50)
"""A binary STL file with one triangle, whose corners are one point."""


@pytest.mark.parametrize("package", ["scanner", ""])
def test_the_package_that_a_robot_needs_to_be_tested_is_named(package: str, folder: Folder) -> None:
    include = f'<xacro:include filename="$(find {package})/urdf/scanner.xacro"/>' if package else ""
    xacro = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    folder.write({"arm.urdf.xacro": GOOD.replace('<robot name="arm">', xacro + include)})
    done = command("gen-all", "arm.urdf.xacro", *"--distro jazzy --simulator gz -o made".split())
    expected = (
        "parts of the robot are not known, and its package is not tested: it needs files of package 'scanner', not here"
    )
    assert (done.returncode, expected in done.stderr) == (0, bool(package))


def test_a_model_for_mujoco_has_an_inertia_that_a_solid_can_have(folder: Folder) -> None:
    folder.write({"r.urdf": TWO.format(visual="", xy="0.5")})
    done = command("convert", "r.urdf", "--to", "mjcf", "-o", "r.xml")
    assert (done.returncode, "the inertia of link 'base' is impossible" in done.stderr) == (0, True)
    mujoco = pytest.importorskip("mujoco")
    assert mujoco.MjModel.from_xml_path(str(folder.path / "r.xml")).nbody == 3


def test_a_mesh_that_mujoco_does_not_load_is_left_out_and_named(folder: Folder) -> None:
    mujoco = pytest.importorskip("mujoco")
    visual = '<visual><geometry><mesh filename="flat.stl"/></geometry></visual>'
    folder.write({"r.urdf": TWO.format(visual=visual, xy="0"), "flat.stl": FLAT})
    done = command("convert", "r.urdf", "--to", "mjcf", "-o", "r.xml")
    assert (done.returncode, "mesh 'flat' is left out" in done.stderr) == (0, True)
    assert mujoco.MjModel.from_xml_path(str(folder.path / "r.xml")).nmesh == 0


def test_a_model_that_mujoco_does_not_load_is_not_written(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    refused = CheckedModel(File("r.xml", ""), fault="Error: broken")
    monkeypatch.setattr(running, "loaded_model", lambda *_: refused)
    folder.write({"r.urdf": TWO.format(visual="", xy="0")})
    done = command("convert", "r.urdf", "--to", "mjcf", "-o", "r.xml")
    assert (done.returncode, (folder.path / "r.xml").exists()) == (1, False)
    assert "which is not written: Error: broken" in done.stderr


@pytest.mark.parametrize(
    ("output", "expected"),
    [("robot/made", "use -o made"), ("robot/deep/made", "use -o made"), ("made", ""), ("robot", "")],
)
def test_a_package_in_a_package_is_told_where_it_should_be(output: str, expected: str, folder: Folder) -> None:
    folder.write({"robot/package.xml": "<package><name>robot</name></package>", "robot/deep/arm.urdf": GOOD})
    words = ("--type", "trajectory", "--distro", "jazzy", "--simulator", "gz")
    done = command("gen-all", "robot/deep/arm.urdf", *words, "-o", output)
    said = [line for line in done.stderr.splitlines() if "colcon finds no packages" in line]
    assert [expected in line for line in said] == ([True] if expected else [])


OWN = """<ros2_control name="own" type="system"><hardware><plugin>my_driver/Arm</plugin></hardware>
  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/>
  <state_interface name="velocity"/></joint></ros2_control></robot>"""


@pytest.mark.parametrize(("robot", "expected"), [(GOOD, False), (GOOD.replace("</robot>", OWN), True)])
def test_hardware_that_the_robot_already_names_is_not_changed_without_a_word(
    robot: str, expected: bool, folder: Folder
) -> None:
    folder.write({"arm.urdf": robot})
    words = ("--type", "trajectory", "--distro", "jazzy", "--hardware", "mock", "--force")
    done = command("gen-all", "arm.urdf", *words, "-o", "made")
    assert ("--hardware mock does not change the plugin of <ros2_control> 'own'" in done.stderr) is expected


@pytest.mark.parametrize(("effort", "status"), [("50", 0), ("2", 1)])
def test_a_package_that_does_not_move_as_commanded_is_not_written(effort: str, status: int, folder: Folder) -> None:
    heavy = GOOD.replace('effort="50"', f'effort="{effort}"').replace('xyz="0 0 0.1"', 'xyz="0.2 0 0"')
    folder.write({"arm.urdf": heavy})
    done = command(*"gen-all arm.urdf --type trajectory --distro jazzy --simulator gz -o made".split())
    assert (done.returncode, (folder.path / "made").exists()) == (status, status == 0)
    assert ("UC915 joint 'shoulder' needs 3.92 N m to hold the robot" in done.stderr) == bool(status)
    assert ("this robot would not move as commanded" in done.stderr) == bool(status)


def test_an_engine_that_crashes_says_nothing_about_the_package(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("mujoco")
    monkeypatch.setattr(engine_workers, "run_trial", lambda *_: os._exit(7))
    folder.write({"arm.urdf": GOOD})
    done = command(*"gen-all arm.urdf --type trajectory --distro jazzy --simulator gz -o made".split())
    assert (done.returncode, (folder.path / "made").exists()) == (0, True)
    assert "crashed while simulating the robot" in done.stderr


def test_nothing_is_written_after_an_interruption_of_the_judgement(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(robots: Sequence[CheckedRobot], *_: object) -> Iterator[RobotResult]:
        return (robot.result._replace(interrupted=True) for robot in robots)

    monkeypatch.setattr(judging, "installed", lambda: ("mujoco",))
    monkeypatch.setattr(judging, "move", interrupted)
    folder.write({"arm.urdf": GOOD})
    command(*"gen-all arm.urdf --type trajectory --distro jazzy --simulator gz -o made".split())
    assert not (folder.path / "made").exists()
