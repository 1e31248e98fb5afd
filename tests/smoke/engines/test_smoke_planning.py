"""The plan for an engine: which joints keep their damping, and what is said of collision meshes that are left out."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Arm
from smoking import checked, target_of

from urdfctl.config.settings import Settings
from urdfctl.load.loader import Loader
from urdfctl.smoke.engines.urdf import EngineUrdf
from urdfctl.smoke.robot_motion import troubles_of_left_out
from urdfctl.smoke.run import SmokeRequest


@pytest.mark.parametrize(("interface", "damped"), [("effort", True), ("position", False)])
def test_joints_that_efforts_push_keep_their_damping(interface: str, damped: bool, tmp_path: Path) -> None:
    """A motor that follows positions has the damping in itself."""
    urdf = Arm().urdf(interface=interface).replace("</joint>", '<dynamics damping="0.125"/></joint>')
    files = {"robot.urdf": urdf, "controllers.yaml": Arm().yaml(interface=interface)}
    made = checked(Loader(Settings(distro="jazzy")), target_of(tmp_path, files), SmokeRequest(engines=("pybullet",)))
    assert made.plan is not None
    assert ('damping="0.125"' in made.plan.urdf) == damped


@pytest.mark.parametrize(
    ("links", "more"), [(1, ""), (2, "and that of 1 other link"), (3, "and that of 2 other links")]
)
def test_links_without_their_meshes_are_one_finding(links: int, more: str) -> None:
    left_out = {f"l{n}": "'a.stl' has no triangles" for n in range(links)}
    [trouble] = troubles_of_left_out(EngineUrdf("", left_out, {}))
    assert "'l0'" in trouble.message
    assert more in trouble.message
    assert ("other link" in trouble.message) == (links > 1)
    assert ("other links" in trouble.message) == (links > 2)
    assert troubles_of_left_out(EngineUrdf("", {}, {})) == []


@pytest.mark.parametrize(
    ("kind", "axis", "refused"),
    [("continuous", "0 0 0", True), ("continuous", "0 0 1", False), ("prismatic", "0 0 0", False)],
)
def test_a_robot_whose_joint_turns_about_no_axis_is_not_given_to_an_engine(
    kind: str, axis: str, refused: bool, tmp_path: Path
) -> None:
    """MuJoCo rejects it, and pybullet's positions are no numbers. That the joint is loose does not matter."""
    flap = f"""<link name="flap"><inertial><mass value="1"/>
        <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
        <joint name="spare" type="{kind}"><parent link="base_link"/><child link="flap"/><axis xyz="{axis}"/>
        <limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>"""
    files = {"robot.urdf": Arm().urdf().replace("</robot>", flap), "controllers.yaml": Arm().yaml()}
    made = checked(Loader(Settings(distro="jazzy")), target_of(tmp_path, files), SmokeRequest(engines=("pybullet",)))
    told = [each.message for each in made.result.linted.outcome.diagnostics if each.code == "UC921"]
    why = "the smoke test rejects the robot: the axis of joint 'spare' is 0 0 0; give it a direction"
    assert told == [why] * refused
    assert (made.plan is None) == refused
