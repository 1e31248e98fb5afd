"""Robots in MuJoCo's own format are the same mechanisms as in URDF."""

from __future__ import annotations

import random
import struct
from pathlib import Path
from typing import Any

import pytest
from collada_meshes import SHOWN, dae
from corpus import CORPUS, needs_corpus
from folder import Folder
from generating import command
from sampling import sample
from uncontrolled_robots import ROBOTS

from urdfctl.config.settings import Settings
from urdfctl.load.expansion.description import expansion_of
from urdfctl.load.loader import Loader
from urdfctl.model.geometry import cross, dot, minus, product, transposed, turned
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.robot.description import mechanism_of
from urdfctl.smoke.robot.mechanism import Hinge, Mechanism

mujoco = pytest.importorskip("mujoco", reason="needs mujoco")
numpy = pytest.importorskip("numpy", reason="needs numpy, as mujoco does")
POSES, CLOSE = 20, 1e-6
ARM = """<robot name="arm"><link name="base">
    <visual><geometry><mesh filename="base.stl" scale="1 2 1"/></geometry></visual>
    <collision><geometry><mesh filename="base.dae"/></geometry></collision></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 1 1"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/><limit lower="-2" upper="1" effort="40" velocity="2"/>
    <dynamics damping="0.3" friction="0.2"/></joint>
  <link name="upper"><inertial><origin xyz="0.02 0 0.1" rpy="0.1 0.2 0.3"/><mass value="2"/>
    <inertia ixx="0.02" ixy="0.001" ixz="0" iyy="0.03" iyz="0.002" izz="0.02"/></inertial>
    <collision><origin xyz="0 0 0.1"/><geometry><cylinder radius="0.05" length="0.2"/></geometry></collision></link>
  <joint name="slide" type="prismatic"><parent link="upper"/><child link="plate"/><axis xyz="1 0 0"/>
    <origin xyz="0 0 0.2"/><limit lower="0" upper="0.1" effort="20" velocity="1"/></joint>
  <link name="plate"/>
  <joint name="fix" type="fixed"><parent link="plate"/><child link="tool"/><origin xyz="0 0.1 0" rpy="0 0 1"/></joint>
  <link name="tool"><inertial><mass value="0.5"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial></link>
  <joint name="other" type="prismatic"><parent link="plate"/><child link="jaw"/><axis xyz="-1 0 0"/>
    <limit lower="0" upper="0.2" effort="20" velocity="1"/><mimic joint="slide" multiplier="2" offset="0.01"/></joint>
  <link name="jaw"><inertial><mass value="0.1"/>
    <inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.0001"/></inertial></link>
  <ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="turn"><command_interface name="effort"/><state_interface name="position"/></joint>
    <joint name="slide"><command_interface name="velocity"/><state_interface name="position"/></joint>
    <sensor name="imu"><state_interface name="orientation.x"/><state_interface name="angular_velocity.x"/></sensor>
  </ros2_control>
  <gazebo reference="tool"><sensor name="imu" type="imu"/></gazebo>
</robot>"""


def stl() -> bytes:
    """A tetrahedron as a binary STL file."""
    corners = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
    faces = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
    body = b"".join(
        struct.pack("<12fH", 0, 0, 0, *(value for corner in face for value in corners[corner]), 0) for face in faces
    )
    return bytes(80) + struct.pack("<I", len(faces)) + body


def mechanism(path: str, *folders: str) -> Mechanism:
    """The robot of a description as numbers, by the smoke test's own reader."""
    loader = Loader(Settings(workspace=folders[-1], package_paths=folders))
    expander = loader.expander(path)
    document = expansion_of(expander, path, {}).document
    assert document is not None
    assert document.documentElement is not None
    found = mechanism_of(robot_of(document.documentElement))
    assert found is not None
    return found


def masses(robot: Mechanism, hinges: list[Hinge], positions: dict[str, float]) -> list[list[float]]:
    """The mass matrix of some hinges in a pose: the sum over the bodies that both of two hinges move."""
    poses = robot.poses(positions)
    axes = [turned(poses[hinge.child].turn, hinge.axis) for hinge in hinges]
    below = [robot.below(hinge.child) for hinge in hinges]
    matrix = [[0.0] * len(hinges) for _ in hinges]
    for name, body in robot.bodies.items():
        turn, place = poses[name].turn, poses[name].at(body.centre)
        inertia = product(product(turn, body.inertia), transposed(turn))
        ways = {
            n: (axes[n], (0.0, 0.0, 0.0))
            if hinges[n].type == "prismatic"
            else (cross(axes[n], minus(place, poses[hinges[n].child].place)), axes[n])
            for n in range(len(hinges))
            if name in below[n]
        }
        for n, (straight, axis) in ways.items():
            for m, (other, other_axis) in ways.items():
                matrix[n][m] += body.mass * dot(straight, other) + dot(axis, turned(inertia, other_axis))
    return matrix


def differences(robot: Mechanism, model: Any) -> tuple[float, float]:
    """The greatest differences of link poses and of mass matrices in sampled poses; the latter relative to the mass."""
    data, chance = mujoco.MjData(model), random.Random(1)  # noqa: S311 (the same poses each time)
    names = {model.joint(n).name: n for n in range(model.njnt)}
    hinges = [hinge for hinge in robot.hinges if hinge.moves]
    assert {hinge.name for hinge in hinges} == {*names} - {"floating_base_joint"}
    ways = [int(model.jnt_dofadr[names[hinge.name]]) for hinge in hinges]
    assert ways
    apart = mass = 0.0
    most = max(1.0, *(body.mass for body in robot.bodies.values()))
    free = robot._replace(hinges=tuple(hinge._replace(mimic=None) for hinge in robot.hinges))
    for _ in range(POSES):
        positions = {hinge.name: chance.uniform(*hinge.span) for hinge in hinges}
        for name, position in positions.items():
            data.qpos[model.jnt_qposadr[names[name]]] = position
        mujoco.mj_forward(model, data)
        for link, pose in free.poses(positions).items():
            if link != "world":
                apart = max(apart, *(abs(a - b) for a, b in zip(data.body(link).xpos, pose.place, strict=True)))
                flat = [value for row in pose.turn for value in row]
                apart = max(apart, *(abs(a - b) for a, b in zip(data.body(link).xmat, flat, strict=True)))
        dense = numpy.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, dense)
        right = masses(free, hinges, positions)
        for n, row in enumerate(right):
            for m, value in enumerate(row):
                mass = max(mass, abs(dense[ways[n]][ways[m]] - value) / most)
    return apart, mass


def test_an_arm_is_the_same_mechanism(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM, "base.stl": stl(), "base.dae": "<COLLADA/>"})
    ran = command("convert", "arm.urdf", "--to", "mjcf", "-o", "out/arm.xml")
    assert ran.returncode == 0, ran.stderr
    model = mujoco.MjModel.from_xml_path(str(folder.path / "out/arm.xml"))
    apart, mass = differences(mechanism(str(folder.path / "arm.urdf"), str(folder.path)), model)
    assert apart < CLOSE
    assert mass < CLOSE
    text = (folder.path / "out/arm.xml").read_text()
    assert 'file="../base.stl" scale="1 2 1"' in text
    assert "mesh 'base.dae' of link 'base' is left out: it cannot be read as COLLADA" in text
    assert '<motor name="turn" joint="turn" ctrlrange="-40.0 40.0"/>' in text
    assert '<velocity name="slide" joint="slide"' in text
    assert '<joint joint1="other" joint2="slide" polycoef="0.01 2.0 0 0 0"/>' in text
    assert '<framequat name="imu_quat" objtype="site" objname="imu_site"/>' in text
    assert 'damping="0.3" frictionloss="0.2"' in text


def test_a_mesh_that_mujoco_does_not_read_is_written_into_the_model(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM, "base.stl": stl(), "base.dae": dae(f"<translate>1 2 3</translate>{SHOWN}")})
    ran = command("convert", "arm.urdf", "--to", "mjcf", "-o", "out/arm.xml")
    assert (ran.returncode, "is left out" in ran.stderr) == (0, False)
    model = mujoco.MjModel.from_xml_path(str(folder.path / "out/arm.xml"))
    mesh = model.mesh("base_1").id
    first, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    corners = model.mesh_vert[first : first + count] + model.mesh_pos[mesh]
    assert numpy.allclose([corners.min(axis=0), corners.max(axis=0)], [[0, 1, 2], [2, 3, 4]], atol=CLOSE)


def test_an_inertia_that_no_solid_has_is_repaired_and_told(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM.replace('izz="0.001"', 'izz="0.003"')})
    assert command("convert", "arm.urdf", "--to", "mjcf", "-o", "arm.xml").returncode == 0
    mujoco.MjModel.from_xml_path(str(folder.path / "arm.xml"))
    text = (folder.path / "arm.xml").read_text()
    assert "the inertia of link 'tool' is impossible for a solid; the nearest possible one is taken" in text
    assert text.count("is impossible") == 1


def test_a_package_for_mujoco_has_the_model_and_its_meshes(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM.replace("<ros2_control", "<x").replace("</ros2_control", "</x"), "base.stl": stl()})
    words = ("arm.urdf", "--type", "trajectory", "--distro", "jazzy", "--simulator", "mujoco", "-o", "made")
    assert command("gen-all", *words).returncode == 0
    assert command("gen-all", *words, "--check").returncode == 0
    assert command("gen-check", "made") == (0, "", "")
    assert command("gen-check", "made", "--update").returncode == 0
    assert not (folder.path / "made/mujoco/package.xml").exists()
    assert (folder.path / "made/mujoco/meshes/base.stl").read_bytes() == stl()
    mujoco.MjModel.from_xml_path(str(folder.path / "made/mujoco/robot.xml"))
    control = (folder.path / "made/urdf/control.xacro").read_text()
    assert "<plugin>mujoco_ros2_control/MujocoSystemInterface</plugin>" in control
    assert '<param name="mujoco_model">$(find made)/mujoco/robot.xml</param>' in control
    assert "install(DIRECTORY config launch urdf mujoco" in (folder.path / "made/CMakeLists.txt").read_text()
    assert command("lint", "made", "--fail-on", "warning", "--ignore", "UC1").returncode == 0


def test_the_format_must_be_known(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    assert command("convert", "arm.urdf").stderr == "urdfctl: --to is missing: use --to mjcf or --to sdf\n"
    assert command("convert", "arm.urdf", "--to", "usd").stderr == "urdfctl: --to must be mjcf, sdf\n"
    ran = command("convert", "--joint", "a", "--to", "mjcf")
    assert ran.stderr == "urdfctl: a model for MuJoCo requires a robot, not a list of joints\n"


@needs_corpus
@pytest.mark.parametrize("path", sample(ROBOTS, 7))
def test_public_robots_are_the_same_mechanisms(path: str, tmp_path: Path) -> None:
    robot, repository = str(CORPUS / path), str(CORPUS / path.partition("/")[0])
    made = tmp_path / "robot.xml"
    where = ("--workspace", repository, "--package-path", repository)
    ran = command("convert", robot, "--to", "mjcf", *where, "-o", str(made))
    assert ran.returncode == 0, ran.stderr
    model = mujoco.MjModel.from_xml_path(str(made))
    apart, mass = differences(mechanism(robot, repository), model)
    assert apart < CLOSE
    assert mass < CLOSE or "is impossible for a solid; the nearest possible one is taken" in made.read_text()


SHELF = """<robot name="shelf"><link name="base"><inertial><mass value="2"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link><link name="board"/>
  <joint name="nailed" type="fixed"><parent link="base"/><child link="board"/><origin xyz="0 0 0.5"/></joint></robot>"""


def test_a_robot_without_a_joint_that_moves_is_a_model_too(folder: Folder) -> None:
    folder.write({"shelf.urdf": SHELF})
    done = command("convert", "shelf.urdf", "--to", "mjcf")
    assert done.returncode == 0, done.stderr
    model = mujoco.MjModel.from_xml_string(done.stdout)
    board = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, "board")
    assert list(model.body_pos[board]) == [0.0, 0.0, 0.5]


@pytest.mark.parametrize(("made_of", "status"), [("plank", 1), ("board", 0)])
def test_a_robot_that_xacro_refuses_is_not_converted_in_part(made_of: str, status: int, folder: Folder) -> None:
    start = '<robot name="shelf" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="board" params="mass">'
    macro = '<inertial><mass value="${mass}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    link = f'<link name="base"><xacro:{made_of} mass="2"/></link><link name="top"/>'
    joint = '<joint name="turn" type="continuous"><parent link="base"/><child link="top"/></joint></robot>'
    folder.write({"shelf.urdf.xacro": f"{start}{macro}</xacro:macro>{link}{joint}"})
    done = command("convert", "shelf.urdf.xacro", "--to", "mjcf", "-o", "shelf.xml")
    assert (done.returncode, Path("shelf.xml").exists()) == (status, status == 0), done.stderr
    assert ("'plank'" in done.stderr) is (status == 1)
