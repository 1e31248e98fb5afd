"""Gains that hold: from the inertia and the weight in the worst pose, within the effort limit, and stable."""

from __future__ import annotations

import pytest
from folder import Folder
from generating import command

from urdfctl.commands.generate.measuring import measure_work
from urdfctl.config.settings import Settings
from urdfctl.generate.controllers.gains import Loop, starting_gains
from urdfctl.generate.robot.coupling import Inverse, inverted
from urdfctl.generate.robot.drive_limits import drive_limit
from urdfctl.generate.robot.facts import JointFacts, Load
from urdfctl.lint.job import job_for, perform_alone
from urdfctl.load.target import Target


def link(name: str, mass: float, at: str = "0 0 0") -> str:
    return (
        f'<link name="{name}"><inertial><origin xyz="{at}"/><mass value="{mass}"/>'
        '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>'
    )


def thin(name: str, mass: float, at: str = "0 0 0") -> str:
    return link(name, mass, at).replace('"0.01"', '"0.004"')


def joint(name: str, parent: str, child: str, axis: str, at: str, effort: float = 90) -> str:
    return (
        f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/><axis xyz="{axis}"/>'
        f'<origin xyz="{at}"/><limit lower="-3" upper="3" effort="{effort}" velocity="3"/></joint>'
    )


ARM = (
    '<robot name="arm"><link name="base"/>'
    + joint("turn", "base", "column", "0 0 1", "0 0 0.1")
    + link("column", 3)
    + joint("shoulder", "column", "upper", "0 1 0", "0 0 0.2")
    + link("upper", 4, "0 0 0.25")
    + joint("elbow", "upper", "fore", "0 1 0", "0 0 0.5", 40)
    + link("fore", 2, "0 0 0.2")
    + joint("wrist", "fore", "hand", "0 1 0", "0 0 0.4", 8)
    + link("hand", 0.4, "0 0 0.05")
    + "</robot>"
)

REDUNDANT = (  # upright, the axes of turn, roll, swivel and flange are one line, and each moves little alone
    '<robot name="arm"><link name="base"/>'
    + joint("turn", "base", "column", "0 0 1", "0 0 0.1")
    + thin("column", 2.8)
    + joint("shoulder", "column", "upper", "0 1 0", "0 0 0.2")
    + thin("upper", 2.5, "0 0 0.15")
    + joint("roll", "upper", "sleeve", "0 0 1", "0 0 0.3")
    + thin("sleeve", 2.5, "0.03 0 0.03")
    + joint("elbow", "sleeve", "fore", "0 1 0", "0.08 0 0.05")
    + thin("fore", 2.5, "-0.05 0 0.1")
    + joint("swivel", "fore", "cuff", "0 0 1", "-0.08 0 0.35", 12)
    + thin("cuff", 1.5, "0 0.03 -0.1")
    + joint("wrist", "cuff", "palm", "0 1 0", "0 0 0", 12)
    + thin("palm", 1, "0.05 0 0")
    + joint("flange", "palm", "hand", "0 0 1", "0.09 0 0.1", 12)
    + thin("hand", 0.4, "0.01 0 0.05")
    + "</robot>"
)


def loads(folder: Folder, robot: str = ARM) -> dict[str, Load]:
    folder.write({"r.urdf": robot})
    job = job_for(measure_work, Target(str(folder.path / "r.urdf")), Settings(workspace=str(folder.path)))
    return {one["name"]: Load(*one["load"]) for one in perform_alone(job)["facts"]["joints"]}


def test_the_weight_is_that_of_the_worst_pose(folder: Folder) -> None:
    found = loads(folder)
    stretched = 9.81 * (4 * 0.25 + 2 * 0.7 + 0.4 * 0.95)  # at zero the arm stands upright and bears nothing
    assert 0.9 * stretched < found["shoulder"].gravity <= stretched
    assert found["turn"].gravity == pytest.approx(0, abs=1e-9)
    assert 0.9 * 9.81 * 0.4 * 0.05 < found["wrist"].gravity <= 9.81 * 0.4 * 0.05
    assert found["elbow"].lightest < found["elbow"].heaviest


def test_the_integral_part_holds_the_weight_within_the_effort_limit() -> None:
    heavy = JointFacts("j", inertia=1.0, effort=30.0, load=Load(gravity=25.0, heaviest=1.0, lightest=0.5))
    gains = starting_gains(heavy, "position", "effort", Loop(0.001, 6))
    assert gains.i > 0
    assert gains.i_clamp == 30.0  # 25 N m and a margin would be more than the motor has
    assert gains.p * 0.05 <= 30.0
    assert "the weight of 25" not in gains.how
    weak = starting_gains(heavy._replace(effort=20.0), "position", "effort", Loop(0.001, 6))
    assert weak.how.endswith("the weight of 25 exceeds the effort limit")
    level = starting_gains(heavy._replace(load=Load(0.0, 1.0, 0.5)), "position", "effort", Loop(0.001, 6))
    assert (level.i, level.i_clamp) == (0.0, None)


def test_a_joint_with_damping_and_friction_still_moves_at_once() -> None:
    stiff = JointFacts("j", inertia=0.002, effort=54.0, damping=0.5, friction=0.3, load=Load(0.0, 0.002, 0.001))
    gains = starting_gains(stiff, "position", "effort", Loop(0.001, 6))
    assert stiff.damping / gains.p <= 0.1  # s
    assert gains.i_clamp is not None
    assert gains.i_clamp >= 0.3


def test_damping_is_stable_for_the_lightest_load_at_the_update_rate() -> None:
    light = JointFacts("j", inertia=1.0, effort=90.0, load=Load(gravity=20.0, heaviest=1.0, lightest=0.01))
    for rate in (100, 500, 1000):
        gains = starting_gains(light, "position", "effort", Loop(1 / rate, 6))
        assert gains.d / 0.01 / rate * 6 <= 0.51


def test_fingers_grip_with_their_effort_within_their_range_and_stay_stable() -> None:
    finger = JointFacts(
        "finger", "prismatic", lower=0.0, upper=0.04, effort=20.0, inertia=0.05, load=Load(0.0, 0.05, 0.05)
    )
    grip = starting_gains(finger, "position", "effort", Loop(0.001, grips=True))
    assert grip.p * 0.25 * 0.04 == pytest.approx(20.0)
    assert grip.d * 0.001 <= 0.5 * 0.05
    strong = starting_gains(finger._replace(effort=2000.0), "position", "effort", Loop(0.001, grips=True))
    assert strong.d * 0.001 <= 0.5 * 0.05
    assert "update rate" in strong.how


@pytest.mark.parametrize(("kind", "distro"), [("trajectory", "jazzy"), ("pid", "rolling"), ("position", "noetic")])
def test_generated_gains_pass_the_smoke_test(kind: str, distro: str, folder: Folder) -> None:
    folder.write({"r.urdf": ARM})
    words = ("--type", kind, "--interface", "effort", "--distro", distro)
    assert command("gen-all", "r.urdf", *words, "-o", "made").returncode == 0
    ran = command("smoke", "made", "--engine", "pybullet", "--distro", distro, "--format", "text")
    assert ran.returncode == 0, ran.stdout


@pytest.mark.parametrize("kind", ["trajectory", "pid"])
def test_a_redundant_arm_is_not_damped_as_if_all_of_its_joints_moved_one_mass(kind: str, folder: Folder) -> None:
    found = loads(folder, REDUNDANT)
    assert found["roll"].lightest < found["roll"].heaviest / 10
    assert 1 < found["roll"].coupling < 4
    words = ("--type", kind, "--interface", "effort", "--distro", "rolling")
    assert command("gen-all", "r.urdf", *words, "-o", "made").returncode == 0
    ran = command("smoke", "made", "--engine", "pybullet", "--distro", "rolling", "--format", "text")
    assert ran.returncode == 0, ran.stdout


def test_the_coupling_of_joints_is_the_greatest_eigenvalue_of_their_inverse_mass_matrix() -> None:
    rows = inverted([[2.0, 1.0], [1.0, 2.0]])
    assert rows is not None
    inverse = Inverse({"a": 0, "b": 1}, rows)
    assert inverse.alone("a") == pytest.approx(1.5)
    assert inverse.greatest({"a": 1.5, "b": 1.5}) == pytest.approx(1.5)  # 1.5 times the eigenvalues 1 and 1/3
    assert inverse.greatest({"a": 1.5, "b": 0.0}) == pytest.approx(1.0)
    assert inverted([[1.0, 1.0], [1.0, 1.0]]) is None


def test_mecanum_wheels_turn_a_robot_slower_than_two_rows_of_wheels() -> None:
    left, right = (
        [
            JointFacts(f"{end}{side}", at=(x, y, 0.0), axis=(0.0, 1.0, 0.0), radius=0.1, velocity=10.0)
            for end, x in (("f", 0.3), ("r", -0.3))
        ]
        for side, y in (("l", 0.2), ("r", -0.2))
    )
    rows, mecanum = (drive_limit("turn", left, right, sideways=sideways) for sideways in (False, True))
    assert rows
    assert mecanum
    assert (rows.value, mecanum.value) == (pytest.approx(1.0 / 0.2), pytest.approx(1.0 / 0.5))


def test_tolerances_and_limits_come_from_the_robot(folder: Folder) -> None:
    folder.write({"r.urdf": ARM})
    text = command("gen-controllers", "r.urdf", "--type", "trajectory", "--distro", "jazzy").stdout
    assert "goal: 0.05  # rad" in text
    assert "goal_time: 1.0" in text
    assert "update_rate: 100  # Hz" in text
    effort = ("gen-controllers", "r.urdf", "--type", "trajectory", "--interface", "effort", "--distro", "jazzy")
    assert "update_rate: 1000  # Hz" in command(*effort).stdout
    assert "update_rate: 400  # Hz" in command(*effort, "--rate", "400").stdout
