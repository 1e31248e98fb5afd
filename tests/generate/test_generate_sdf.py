"""Robots in SDF are the same mechanisms as in URDF, with what fixed joints connect in one link."""

from __future__ import annotations

import random
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from folder import Folder
from generating import command

from urdfctl.config.settings import Settings
from urdfctl.load.expansion.description import expansion_of
from urdfctl.load.loader import Loader
from urdfctl.model.geometry import Pose, Rotation, Vector, about, scaled
from urdfctl.model.robot import Robot
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.robot import mechanism_of

CLOSE = 1e-9
INERTIAL = (
    '<inertial><origin xyz="0.02 0 0.1" rpy="0.1 0.2 0.3"/><mass value="2"/>'
    '<inertia ixx="0.02" ixy="0.001" ixz="0" iyy="0.03" iyz="0.002" izz="0.02"/></inertial>'
)
ARM = f"""<robot name="arm"><link name="foot"/>
  <joint name="stand" type="fixed"><parent link="foot"/><child link="base"/>
    <origin xyz="0 0 0.4" rpy="0 0.3 0"/></joint>
  <link name="base">{INERTIAL}
    <collision><geometry><mesh filename="package://arm/base.stl"/></geometry></collision></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 1 1"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/><limit lower="-2" upper="1" effort="40" velocity="2"/>
    <dynamics damping="0.3" friction="0.2"/></joint>
  <link name="upper">{INERTIAL}</link>
  <joint name="bolt" type="fixed"><parent link="upper"/><child link="plate"/>
    <origin xyz="0 0.1 0" rpy="3.1 0 1"/></joint>
  <link name="plate">{INERTIAL}
    <collision><origin rpy="0.2 0 0"/><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link>
  <joint name="slide" type="prismatic"><parent link="plate"/><child link="tool"/><axis xyz="1 0 1"/>
    <origin xyz="0 0 0.2" rpy="0 1.57 0"/><limit lower="0" upper="0.1" effort="20" velocity="1"/></joint>
  <link name="tool">{INERTIAL}</link>
  <joint name="spin" type="continuous"><parent link="tool"/><child link="bit"/><axis xyz="0 0 1"/></joint>
  <link name="bit">{INERTIAL}</link>
  <joint name="other" type="prismatic"><parent link="tool"/><child link="jaw"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.2" effort="20" velocity="1"/><mimic joint="slide" multiplier="2" offset="0.01"/></joint>
  <link name="jaw">{INERTIAL}</link>
  <gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
    <parameters>controllers.yaml</parameters></plugin></gazebo>
  <gazebo reference="plate"><mu1>0.4</mu1><sensor name="imu" type="imu"><topic>imu</topic></sensor></gazebo>
</robot>"""


def converted(folder: Folder, urdf: str) -> ET.Element:
    folder.write({"robot.urdf": urdf})
    done = command(*"convert robot.urdf --to sdf -o robot.sdf".split())
    assert done.returncode == 0, done.stderr
    model = ET.fromstring((folder.path / "robot.sdf").read_text()).find("model")
    assert model is not None
    return model


def robot_in(path: Path) -> Robot:
    expander = Loader(Settings(workspace=str(path.parent))).expander(str(path))
    document = expansion_of(expander, str(path), {}).document
    assert document is not None
    assert document.documentElement is not None
    return robot_of(document.documentElement)


def pose_in(element: ET.Element) -> tuple[str, Pose]:
    """The frame that a pose is given in, and the pose."""
    pose = element.find("pose")
    if pose is None:
        return "", Pose()
    x, y, z, a, b, c, w = map(float, (pose.text or "").split())
    turn: Rotation = (
        (1 - 2 * (b * b + c * c), 2 * (a * b - c * w), 2 * (a * c + b * w)),
        (2 * (a * b + c * w), 1 - 2 * (a * a + c * c), 2 * (b * c - a * w)),
        (2 * (a * c - b * w), 2 * (b * c + a * w), 1 - 2 * (a * a + b * b)),
    )
    return pose.get("relative_to", ""), Pose((x, y, z), turn)


def poses_of(model: ET.Element, positions: dict[str, float]) -> dict[str, Pose]:
    """Where the frames of a model are, as SDF's documentation of pose frames defines it."""
    given = {each.get("name", ""): each for each in model if each.tag in ("link", "joint", "frame")}
    moved: dict[str, Pose] = {}
    for name, joint in given.items():
        axis = joint.find("axis/xyz")
        if joint.tag == "joint" and axis is not None:
            x, y, z = map(float, (axis.text or "").split())
            way: Vector = (x, y, z)
            value = positions[name]
            slides = joint.get("type") == "prismatic"
            moved[name] = Pose(scaled(way, value)) if slides else Pose(turn=about(way, value))

    def pose_of(name: str) -> Pose:
        if name == "__model__":
            return Pose()
        element = given[name]
        frame, pose = pose_in(element)
        frame = frame or element.get("attached_to", "")
        return pose_of(frame).then(moved.get(frame, Pose())).then(pose) if frame else pose

    return {name: pose_of(name) for name, element in given.items() if element.tag != "joint"}


@pytest.mark.parametrize("root", ["foot", "world"])
def test_links_are_where_they_are_in_the_urdf_at_all_joint_positions(root: str, folder: Folder) -> None:
    model = converted(folder, ARM.replace('"foot"', f'"{root}"'))
    mechanism = mechanism_of(robot_in(folder.path / "robot.urdf"))
    assert mechanism is not None
    mechanism = mechanism._replace(hinges=tuple(hinge._replace(mimic=None) for hinge in mechanism.hinges))
    dice = random.Random(1)  # noqa: S311 (the same poses each time)
    for _ in range(20):
        positions = {hinge.name: dice.uniform(-1, 1) for hinge in mechanism.hinges}
        expected = mechanism.poses(positions)
        places = poses_of(model, positions)
        for name in expected.keys() - {"world"}:
            pose = places[name]
            assert pose.place == pytest.approx(expected[name].place, abs=CLOSE), name
            assert [*sum(pose.turn, ())] == pytest.approx([*sum(expected[name].turn, ())], abs=CLOSE), name


def test_what_fixed_joints_connect_is_one_link_with_all_their_mass(folder: Folder) -> None:
    model = converted(folder, ARM)
    links = {link.get("name"): link for link in model.findall("link")}
    assert [*links] == ["foot", "upper", "tool", "bit", "jaw"]
    masses = [link.findtext("inertial/mass") for link in links.values()]
    assert masses == ["2.0", "4.0", "2.0", "2.0", "2.0"]
    collision = links["upper"].find("collision")
    assert collision is not None
    assert collision.get("name") == "upper_fixed_joint_lump__plate_collision"


def test_every_frame_that_a_pose_is_relative_to_is_in_the_model(folder: Folder) -> None:
    """What is fixed to the world has its pose in the model: `world` is no frame of a model in sdformat."""
    model = converted(folder, ARM.replace('"foot"', '"world"'))
    frames = {each.get("name") for each in model if each.tag in ("link", "joint", "frame")} | {"__model__"}
    assert {pose.get("relative_to", "__model__") for pose in model.iter("pose")} <= frames
    assert model.findtext("joint[@name='stand']/parent") == "world"


def test_a_moving_joint_with_the_name_of_a_link_is_refused_and_a_fixed_one_disappears(folder: Folder) -> None:
    model = converted(folder, ARM.replace('"bolt"', '"plate"'))
    assert [frame.get("name") for frame in model.findall("frame")] == ["stand", "base", "plate"]
    folder.write({"robot.urdf": ARM.replace('name="turn"', 'name="upper"')})
    done = command(*"convert robot.urdf --to sdf -o other.sdf".split())
    assert (done.returncode, (folder.path / "other.sdf").exists()) == (2, False)
    assert "joint 'upper' has the same name as a link, which Gazebo rejects; rename one of them" in done.stderr


def test_gazebo_elements_limits_and_mimic_joints_are_kept(folder: Folder) -> None:
    model = converted(folder, ARM)
    assert model.findtext("plugin/parameters") == "controllers.yaml"
    assert model.findtext("link[@name='upper']/sensor/topic") == "imu"
    assert model.findtext("link[@name='upper']/collision/surface/friction/ode/mu") == "0.4"
    assert model.findtext("link[@name='foot']/collision/geometry/mesh/uri") == "model://arm/base.stl"
    assert model.findtext("joint[@name='turn']/axis/limit/upper") == "1.0"
    assert model.findtext("joint[@name='spin']/axis/limit/upper") == "1e+16"
    assert model.findtext("joint[@name='other']/axis/mimic/multiplier") == "2.0"


def test_a_link_without_mass_is_named(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM.replace(f'<link name="bit">{INERTIAL}</link>', '<link name="bit"/>')})
    done = command(*"convert robot.urdf --to sdf -o robot.sdf".split())
    assert "link 'bit' has no mass: Gazebo drops it" in done.stderr


def test_a_robot_of_ros_1_is_converted_too(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    for to in ("sdf", "mjcf"):
        done = command(*f"convert robot.urdf --to {to} --distro noetic -o robot.{to}".split())
        assert done.returncode == 0, done.stderr
