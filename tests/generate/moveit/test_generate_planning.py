"""Whether the MoveIt configuration that is written plans: its groups in three libraries, and its poses."""

from __future__ import annotations

import math
import random
import shutil
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml
from folder import Folder
from generating import command
from planned_arm import INERTIAL, JAZZY, ROW, arm, mechanism, semantic

from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.engines import touching_links
from urdfctl.smoke.engines.mujoco_engine import COMPILER
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse

mujoco = pytest.importorskip("mujoco")

FINGERS = ("left_finger_joint", "right_finger_joint")


@pytest.fixture(name="written")
def _written(folder: Folder) -> Folder:
    folder.write({"six.urdf": arm()})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    return folder


def chain(folder: Folder) -> tuple[str, str]:
    """Return the links between which the written group of the arm is."""
    [found] = semantic(folder).findall("group/chain")
    return found.get("base_link", ""), found.get("tip_link", "")


def chance_poses(number: int) -> list[dict[str, float]]:
    """Return poses of the arm within its limits, the same ones each time."""
    chance = random.Random(11)  # noqa: S311 (it samples poses)
    return [{name: chance.uniform(-2.9, 2.9) for name, _, _ in ROW} for _ in range(number)]


def only_chain(base: str, tip: str) -> str:
    """Return the description of the arm with no links but those of a chain."""
    root = ET.fromstring(arm())
    above = {joint.find("child").get("link"): joint for joint in root.findall("joint")}  # type: ignore[union-attr]
    kept, joints = {tip}, set()
    while tip != base:
        joint = above[tip]
        tip = joint.find("parent").get("link", "")  # type: ignore[union-attr]
        kept.add(tip)
        joints.add(joint.get("name"))
    for part in [*root]:
        if part.get("name") not in (kept if part.tag == "link" else joints):
            root.remove(part)
    return ET.tostring(root, encoding="unicode")


class MuJoCo:
    """The arm in MuJoCo, with each pair of links tested."""

    def __init__(self) -> None:
        spec = mujoco.MjSpec.from_string(arm().replace('<robot name="six">', f'<robot name="six">{COMPILER}'))
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_FILTERPARENT
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)

    def take(self, pose: Mapping[str, float]) -> None:
        """Move the joints to a pose, and the second finger as the first."""
        for name, value in pose.items():
            for each in FINGERS if name == FINGERS[0] else (name,):
                self.data.qpos[self.model.joint(each).qposadr[0]] = value
        mujoco.mj_forward(self.model, self.data)

    def touching(self) -> set[frozenset[str]]:
        """Return the links that touch."""
        bodies = [[int(self.model.geom_bodyid[shape]) for shape in pair] for pair in self.data.contact.geom]
        return {frozenset(self.model.body(body).name for body in pair) for pair in bodies}


def test_the_tip_of_the_group_is_where_mujoco_and_ours_say(written: Folder) -> None:
    base, tip = chain(written)
    assert base == "base_link"
    engine = MuJoCo()
    for pose in chance_poses(10):
        engine.take(pose)
        assert mechanism().poses(pose)[tip].place == pytest.approx(engine.data.body(tip).xpos.tolist(), abs=1e-6)


def test_the_tip_of_the_group_is_where_pybullet_says(written: Folder, tmp_path: Path) -> None:
    pybullet = pytest.importorskip("pybullet")
    _, tip = chain(written)
    (tmp_path / "six.urdf").write_text(arm())
    world = pybullet.connect(pybullet.DIRECT)
    try:
        body = pybullet.loadURDF(str(tmp_path / "six.urdf"), useFixedBase=True, physicsClientId=world)
        count = pybullet.getNumJoints(body, physicsClientId=world)
        known = [pybullet.getJointInfo(body, n, physicsClientId=world) for n in range(count)]
        numbers = {one[1].decode(): one[0] for one in known}
        [last] = [one[0] for one in known if one[12].decode() == tip]
        for pose in chance_poses(5):
            for name, value in pose.items():
                pybullet.resetJointState(body, numbers[name], value, physicsClientId=world)
            placed = pybullet.getLinkState(body, last, computeForwardKinematics=True, physicsClientId=world)[4]
            assert mechanism().poses(pose)[tip].place == pytest.approx(placed, abs=1e-5)
    finally:
        pybullet.disconnect(world)


def test_ikpy_reaches_poses_of_the_written_group_within_the_limits(written: Folder, tmp_path: Path) -> None:
    solver = pytest.importorskip("ikpy.chain")
    numpy = pytest.importorskip("numpy")
    base, tip = chain(written)
    (tmp_path / "chain.urdf").write_text(only_chain(base, tip))
    kinds = [joint.get("type") for joint in ET.parse(tmp_path / "chain.urdf").getroot().findall("joint")]
    moved = [False, *(kind != "fixed" for kind in kinds)]
    assert sum(moved) == len(ROW)
    path = str(tmp_path / "chain.urdf")
    found: Any = solver.Chain.from_urdf_file(path, base_elements=[base], active_links_mask=moved)
    for pose in chance_poses(4):
        angles = numpy.array([pose.get(link.name, 0.0) for link in found.links])
        goal = found.forward_kinematics(angles)
        assert goal[:3, 3].tolist() == pytest.approx(mechanism().poses(pose)[tip].place, abs=1e-6)
        start = angles + 0.2 * numpy.array(moved) * numpy.where(angles > 0, -1, 1)
        answer = found.inverse_kinematics_frame(goal, initial_position=start, orientation_mode="all")
        assert numpy.abs(found.forward_kinematics(answer) - goal).max() < 1e-3
        assert numpy.abs(answer).max() <= 2.9 + 1e-9
    limits = yaml.safe_load(Path(written.path, "out/config/joint_limits.yaml").read_text())["joint_limits"]
    assert {link.name for link, moves in zip(found.links, moved, strict=True) if moves} < {*limits}


def test_in_no_named_pose_links_touch_that_are_tested_or_never_touch(written: Folder) -> None:
    root = semantic(written)
    disabled = {
        frozenset((one.get("link1", ""), one.get("link2", ""))): one.get("reason")
        for one in root.findall("disable_collisions")
    }
    engine = MuJoCo()
    poses = root.findall("group_state")
    assert len(poses) == 3
    for state in poses:
        pose = dict.fromkeys((name for name, _, _ in ROW), 0.0)
        pose |= {one.get("name", ""): float(one.get("value", "nan")) for one in state}
        assert not any(math.isnan(value) for value in pose.values())
        engine.take(pose)
        assert {disabled.get(pair) for pair in engine.touching()} <= {"Adjacent", "Default", "Always"}


CONTROL = """<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
  <joint name="lift"><command_interface name="position"/><state_interface name="position">
    <param name="initial_value">{}</param></state_interface></joint></ros2_control></robot>"""


def test_links_that_one_joint_moves_against_each_other_are_tested_in_steps_of_its_range(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    met: Counter[frozenset[str]] = Counter()

    def meet(self: Any, data: Any, one: int, other: int) -> bool:
        del data
        names = [self._model.body(self._model.geom_bodyid[shape]).name for shape in (one, other)]
        met[frozenset(names)] += 1
        return False

    pytest.importorskip("fcl")
    monkeypatch.setattr("urdfctl.smoke.engines.surfaces.Surfaces.meet", meet)
    fingers, tested = frozenset(("left_finger", "right_finger")), []
    wide = arm().replace('size="0.02 0.01 0.06"', 'size="0.02 0.2 0.06"')  # their hulls meet in each pose
    for text in (wide, wide.replace('<mimic joint="left_finger_joint"/>', "")):
        met.clear()
        root = parse(SourceText("six.urdf", text.encode())).documentElement
        assert root is not None
        touching_links(robot_of(root), lambda _: None, 5000, 0)
        tested.append(met[fingers])
    assert 1500 < tested[0] < 2100
    assert tested[1] > 5000


def test_poses_and_tested_links_stay_within_the_soft_limits_in_which_moveit_plans(written: Folder) -> None:
    def disabled() -> set[frozenset[str]]:
        return {
            frozenset((pair.get("link1", ""), pair.get("link2", "")))
            for pair in semantic(written).findall("disable_collisions")
        }

    assert frozenset(("hand", "base_link")) not in disabled()
    soft = '<safety_controller k_velocity="9" soft_lower_limit="{}" soft_upper_limit="{}"/>'
    text = arm().replace('effort="90" velocity="2"/>', f'effort="90" velocity="2"/>{soft.format(-0.2, 0.2)}')
    finger = '<limit lower="0" upper="0.04" effort="20" velocity="0.2"/>'
    shutil.rmtree("out")  # what is there would be taken for a person's
    written.write({"six.urdf": text.replace(finger, finger + soft.format(0.005, 0.03))})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    assert frozenset(("hand", "base_link")) in disabled()
    opened, closed = (semantic(written).find(f"group_state[@name='{name}']/joint") for name in ("open", "close"))
    assert (opened.get("value"), closed.get("value")) == ("0.03", "0.005")  # type: ignore[union-attr]
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


@pytest.mark.parametrize(("lower", "said"), [(0.005, True), (-0.005, False)])
def test_a_joint_that_starts_outside_of_its_soft_limits_is_told(lower: float, said: bool, folder: Folder) -> None:
    finger = '<limit lower="0" upper="0.04" effort="20" velocity="0.2"/>'
    soft = f'<safety_controller k_velocity="9" soft_lower_limit="{lower}" soft_upper_limit="0.03"/>'
    folder.write({"six.urdf": arm().replace(finger, finger + soft, 1)})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    told = "joint 'left_finger_joint' starts outside of its soft limits, from where MoveIt cannot plan: let it start"
    assert (ran.returncode, told in ran.stderr) == (0, said)


@pytest.mark.parametrize(("start", "status"), [(0.4, 0), (2.8, 2)])
def test_a_robot_whose_links_touch_where_it_starts_is_not_written(start: float, status: int, folder: Folder) -> None:
    folder.write({"six.urdf": arm().replace("</robot>", CONTROL.format(start))})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert ran.returncode == status, ran.stderr
    assert Path(folder.path, "out").exists() is not bool(status)
    told = "touch where the robot starts, from where MoveIt cannot plan: let it start elsewhere"
    assert (told in ran.stderr) is bool(status)


FIXED = """<joint name="stand" type="fixed"><parent link="world"/><child link="base_link"/></joint>
  <link name="base_link">"""
HOST = """<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
  {}</plugin></gazebo></robot>"""
OWN = "<parameters>own/controllers.yaml</parameters>"


@pytest.mark.parametrize(("parameters", "told"), [(OWN, True), ("", False)])
def test_a_robot_whose_plugin_loads_controllers_of_its_own_is_refused(
    parameters: str, told: bool, folder: Folder
) -> None:
    hosted = arm().replace("</robot>", HOST.format(parameters))
    folder.write({"six.urdf": hosted.replace('<link name="base_link">', '<link name="world"/>' + FIXED, 1)})
    ran = command("gen-moveit", "six.urdf", *JAZZY, "--simulator", "gz")
    assert ("plugin in the robot loads the controllers of 'own/controllers.yaml', and not these" in ran.stderr) is told
    assert Path(folder.path, "out").exists() is not told, ran.stderr


@pytest.mark.parametrize("component", [True, False])
def test_without_a_simulator_asked_for_a_robot_without_hardware_is_planned_for_with_mock_hardware(
    component: bool, folder: Folder
) -> None:
    hosted = arm().replace("</robot>", HOST.format(OWN))
    driver = """<ros2_control name="own" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin>
      </hardware></ros2_control></robot>"""
    folder.write({"six.urdf": hosted.replace("</robot>", driver) if component else hosted})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert ("written for mock hardware, without a simulator" in ran.stderr) is not component, ran.stderr
    assert Path(folder.path, "out").exists() is not component
    if not component:
        assert not command("lint", "out", "--format", "concise", "--select", "UC6").stdout


def test_a_robot_without_any_mass_is_planned_for_without_the_simulator_of_its_plugin(folder: Folder) -> None:
    hosted = arm().replace("</robot>", HOST.format(""))
    folder.write({"six.urdf": hosted.replace(INERTIAL, "")})
    ran = command("gen-moveit", "six.urdf", *JAZZY)
    assert "written for mock hardware, without a simulator: no link of the robot has an <inertial>" in ran.stderr
    assert command("lint", "out", "--fail-on", "error").returncode == 0
    assert command("smoke", "out").returncode == 0
    assert command("gen-check", "out") == (0, "", "")
    folder.write({"six.urdf": hosted})
    assert "without a simulator" not in command("gen-moveit", "six.urdf", *JAZZY[:-1], "other").stderr


def test_mock_hardware_is_commanded_by_positions_whatever_transmissions_say(folder: Folder) -> None:
    driven = "".join(
        f"""<transmission name="{name}_t"><type>transmission_interface/SimpleTransmission</type><joint name="{name}">
        <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
        <actuator name="{name}_m"/></transmission>"""
        for name, _, _ in ROW
    )
    folder.write({"six.urdf": arm().replace("</robot>", f"{driven}</robot>")})
    assert command("gen-moveit", "six.urdf", *JAZZY, "--simulator", "none").returncode == 0
    described = Path(folder.path, "out/urdf/control.xacro").read_text()
    assert described.count('<command_interface name="position">') == len(ROW) + 1
    assert "effort" not in Path(folder.path, "out/config/controllers.yaml").read_text().replace("max_effort", "")


def test_links_that_cannot_be_tested_in_time_are_one_line_and_nothing_is_written(folder: Folder) -> None:
    folder.write({"six.urdf": arm()})
    ran = command("gen-moveit", "six.urdf", "--distro", "jazzy", "--samples", "10000000", "--timeout", "5", "-o", "out")
    said = "it takes longer than 5 s; use fewer --samples, or a longer --timeout"
    assert (ran.returncode, ran.stderr) == (2, f"urdfctl: the links cannot be tested for collisions: {said}\n")
    assert not Path(folder.path, "out").exists()
