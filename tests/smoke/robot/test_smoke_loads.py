"""The weight on joints in the worst of many poses: how near the poses come to it, and how many they are."""

from __future__ import annotations

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.robot import loads
from urdfctl.smoke.robot.loads import worst_loads
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism

LEFT = (0.0, 1.0, 0.0)


def crane(joints: int) -> Mechanism:
    """Return a chain of levers of 1 kg and 1 m, which hangs down at spawn."""
    hinges = [
        Hinge(f"j{n}", "revolute", parent=f"l{n}", child=f"l{n + 1}", pose=Pose((0.0, 0.0, -1.0)), axis=LEFT)._replace(
            lower=-2.0, upper=2.0, effort=10.0
        )
        for n in range(joints)
    ]
    bodies = [LinkBody("l0"), *(LinkBody(f"l{n + 1}", 1.0, centre=(0.0, 0.0, -1.0)) for n in range(joints))]
    return Mechanism("l0", {body.name: body for body in bodies}, tuple(hinges))


@pytest.mark.parametrize(("joints", "least"), [(2, 0.99), (4, 0.94), (20, 0.75)])
def test_the_worst_pose_of_a_crane_is_nearly_its_stretched_one(joints: int, least: float) -> None:
    """n masses of 1 kg at 1 m to n m: 9.81 N m for each metre. Many joints are only sampled."""
    stretched = 9.81 * sum(range(1, joints + 1))
    arm = crane(joints)
    assert least * stretched < worst_loads(arm, arm.hinges)["j0"][0] < 1.0001 * stretched


@pytest.mark.parametrize(("joints", "most"), [(12, 1100), (13, 60)])
def test_the_worst_pose_is_found_in_few_poses(joints: int, most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each pose takes a pass over the robot, which for 1100 poses of 12 joints is a tenth of a second."""
    tried: list[object] = []

    def heavy(mechanism: Mechanism, pose: object) -> dict[str, float]:
        tried.append(pose)
        return dict.fromkeys(mechanism.start(), 9.0)

    monkeypatch.setattr(loads, "gravity_load", heavy)
    arm = crane(joints)
    assert worst_loads(arm, arm.hinges)["j0"][0] == 9.0
    assert len(tried) < most
