"""Single bodies and joints in each engine against the formulas of mechanics."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from collada_meshes import SHOWN, dae
from smoke_robots import link
from smoking_engines import EACH_ENGINE, needs_pybullet

from urdfctl.smoke.engines.engine import STEP, Engine, EngineSetup, RobotRejected, open_engine

CARRIAGE = 2.0
"""The mass of a carriage, in kg."""
LIFT = CARRIAGE * 9.81
"""Its weight, in N."""


def sliding(axis: str, dynamics: str = "") -> str:
    """Return a carriage on a rail along an axis."""
    return f"""<robot name="robot">{link("base", 1.0, 0.01)}{link("carriage", CARRIAGE, 0.01)}
    <joint name="rail" type="prismatic"><parent link="base"/><child link="carriage"/><axis xyz="{axis}"/>
    <limit lower="-100" upper="100" effort="100" velocity="100"/>{dynamics}</joint></robot>"""


def lying(shape: str) -> str:
    """Return a body of 1 kg that is a shape."""
    return f'<robot name="robot">{link("body", 1.0, 0.01, shape)}</robot>'


@contextmanager
def railed(engine: str, axis: str = "1 0 0", dynamics: str = "", **fields: object) -> Iterator[Engine]:
    start = fields.pop("start", {"rail": 0.0})
    setup = EngineSetup(sliding(axis, dynamics), "base", True, start, **fields)  # type: ignore[arg-type]
    opened = open_engine(engine, setup)
    yield opened
    opened.close()


@contextmanager
def grounded(engine: str, urdf: str, **fields: object) -> Iterator[Engine]:
    opened = open_engine(engine, EngineSetup(urdf, "body", False, {}, **fields))  # type: ignore[arg-type]
    yield opened
    opened.close()


def run(engine: Engine, seconds: float) -> None:
    for _ in range(round(seconds / STEP)):
        engine.step()


# -- joints ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_joint_begins_where_the_robot_starts(engine: str) -> None:
    with railed(engine, start={"rail": 0.25}) as robot:
        assert robot.position("rail") == pytest.approx(0.25)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_force_accelerates_a_mass(engine: str) -> None:
    with railed(engine) as robot:
        robot.with_effort("rail", 4.0)
        run(robot, 0.3)
        assert robot.velocity("rail") == pytest.approx(4.0 / CARRIAGE * 0.3, rel=0.01)
        assert robot.position("rail") == pytest.approx(0.5 * 4.0 / CARRIAGE * 0.3**2, rel=0.01)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_joint_that_is_pushed_is_no_longer_driven(engine: str) -> None:
    with railed(engine) as robot:
        robot.at_velocity("rail", 1.0, 1000.0)
        run(robot, 0.02)
        before = robot.velocity("rail")
        robot.with_effort("rail", -4.0)
        run(robot, 0.3)
        assert before == pytest.approx(1.0, rel=0.01)
        assert robot.velocity("rail") == pytest.approx(before - 4.0 / CARRIAGE * 0.3, abs=0.01)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_damped_mass_nears_the_velocity_at_which_damping_takes_the_whole_force(engine: str) -> None:
    """With a force F, a mass m and a damping D the velocity is F/D (1 - exp(-D t / m))."""
    with railed(engine, dynamics='<dynamics damping="10"/>') as robot:
        robot.with_effort("rail", 4.0)
        run(robot, 0.2)
        assert robot.velocity("rail") == pytest.approx(0.4 * (1 - math.exp(-10 * 0.2 / CARRIAGE)), rel=0.01)
        assert robot.effort("rail") == 4.0


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("stiff", [False, True])
def test_a_motor_drives_a_joint_as_fast_as_friction_and_damping_leave_it(engine: str, *, stiff: bool) -> None:
    """Of 10 N a friction of 2 N leaves 8 N, which a damping of 400 N s/m takes at 0.02 m/s."""
    fields = {"resist": {"rail": (2.0, 400.0)}, "stiff": ("rail",) if stiff else ()}
    with railed(engine, **fields) as robot:
        robot.at_velocity("rail", 3.0, 10.0)
        run(robot, 0.1)
        assert robot.velocity("rail") == pytest.approx(0.02, rel=0.02)


@needs_pybullet
@pytest.mark.parametrize("damping", [5000.0, 50000.0])
def test_a_stiff_joint_reaches_what_its_motor_leaves_in_spite_of_a_damping_beyond_its_step(damping: float) -> None:
    """A mass of 2 kg bears no explicit damping over 2 m / STEP."""
    dynamics = f'<dynamics damping="{damping}"/>'
    with railed("pybullet", dynamics=dynamics, resist={"rail": (0.0, damping)}, stiff=("rail",)) as robot:
        robot.at_velocity("rail", 3.0, 100.0)
        run(robot, 0.05)
        assert robot.velocity("rail") == pytest.approx(100.0 / damping, rel=0.02)


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("resist", [{}, {"rail": (2.0, 4.0)}])
def test_a_motor_brings_a_joint_to_its_target_with_and_without_friction(
    engine: str, resist: dict[str, tuple[float, float]]
) -> None:
    with railed(engine, resist=resist) as robot:
        robot.to_position("rail", 0.3, 100.0, 2.0)
        run(robot, 0.4)
        assert robot.position("rail") == pytest.approx(0.3, abs=0.001)
        assert robot.velocity("rail") == pytest.approx(0.0, abs=0.001)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_joint_arrives_when_its_velocity_limit_lets_it_and_does_not_overshoot(engine: str) -> None:
    """At 1 m/s it covers 0.3 m in 0.3 s. Its 100 N could stop it within 20 ms."""
    with railed(engine) as robot:
        robot.to_position("rail", 0.3, 100.0, 1.0)
        places = []
        for _ in range(380):
            robot.step()
            places.append(robot.position("rail"))
    assert places[299] < 0.3
    assert places[-1] == pytest.approx(0.3, abs=0.001)
    assert max(places) < 0.301


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_motor_that_lifts_a_mass_bears_its_weight(engine: str) -> None:
    with railed(engine, axis="0 0 1") as robot:
        robot.at_velocity("rail", 0.5, 100.0)
        run(robot, 0.05)
        assert robot.velocity("rail") == pytest.approx(0.5, rel=0.01)
        assert robot.effort("rail") == pytest.approx(LIFT, rel=0.01)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_strong_motor_reaches_its_velocity_at_once(engine: str) -> None:
    with railed(engine) as robot:
        robot.at_velocity("rail", 0.5, 1e6)
        robot.step()
        assert robot.velocity("rail") == pytest.approx(0.5, rel=0.1)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_carriage_falls_unless_it_is_weightless(engine: str) -> None:
    for weightless, fallen in (((), 0.5 * 9.81 * 0.2**2), (("carriage",), 0.0)):
        with railed(engine, axis="0 0 1", weightless=weightless) as robot:
            robot.with_effort("rail", 0.0)
            run(robot, 0.2)
            assert robot.position("rail") == pytest.approx(-fallen, rel=0.02, abs=1e-6)


# -- bodies on the ground --------------------------------------------------------------------------------------------


BOX = '<box size="0.4 0.3 0.2"/>'


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize(
    ("shape", "height", "wheels"),
    [
        (BOX, 0.1, ()),
        (BOX, 0.1, ("body",)),
        ('<sphere radius="0.15"/>', 0.15, ()),
        ('<cylinder radius="0.05" length="0.16"/>', 0.08, ()),
    ],
    ids=["box", "wheel that is a box", "sphere", "upright cylinder"],
)
def test_a_body_rests_at_half_its_height_and_never_jumps(
    engine: str, shape: str, height: float, wheels: tuple[str, ...]
) -> None:
    with grounded(engine, lying(shape), wheels=wheels) as robot:
        heights = [robot.base_pose().z]
        for _ in range(200):
            robot.step()
            heights.append(robot.base_pose().z)
        assert robot.touching() == {"body"}
    assert heights[-1] == pytest.approx(height, abs=0.001)
    assert max(heights) < height + 0.005


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize(
    ("shape", "reach"),
    [
        ('<sphere radius="0.15"/>', 0.15),
        ('<box size="0.4 0.3 0.2"/>', 0.2 * math.sin(0.7) + 0.1 * math.cos(0.7)),
        ('<cylinder radius="0.05" length="0.16"/>', 0.05 * math.sin(0.7) + 0.08 * math.cos(0.7)),
        ('<mesh filename="tetrahedron.obj"/>', 0.2 * math.sin(0.7)),
    ],
    ids=["sphere", "box", "cylinder", "mesh"],
)
def test_a_tilted_body_is_put_down_where_it_touches_the_ground(
    engine: str, shape: str, reach: float, tmp_path: Path
) -> None:
    """It is turned by 0.7 rad about y. The mesh has corners at its origin and 0.2 m ahead, aside and up.

    pybullet adds a margin of some millimetres to a mesh.
    """
    path = tmp_path / "tetrahedron.obj"
    corners = "v 0 0 0\nv 0.2 0 0\nv 0 0.2 0\nv 0 0 0.2\n"
    path.write_text(f"{corners}f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", encoding="utf-8")
    level = lying(shape.replace("tetrahedron.obj", str(path)))
    tilted = level.replace('<origin xyz="0 0 0"/>', '<origin xyz="0 0 0" rpy="0 0.7 0"/>')
    assert tilted != level
    with grounded(engine, tilted) as robot:
        assert robot.base_pose().z == pytest.approx(reach, abs=0.01)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_body_that_is_fixed_to_the_world_stays_where_it_is(engine: str) -> None:
    opened = open_engine(engine, EngineSetup(lying(BOX), "body", True, {}))
    run(opened, 0.01)
    assert opened.base_pose() == (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    opened.close()


# -- what engines reject ---------------------------------------------------------------------------------------------


def train(count: int) -> EngineSetup:
    """Return a train of carriages, each of which slides on the one before."""
    parts = [link(f"c{n}", 1.0, 0.01) for n in range(count + 1)]
    parts += [
        f'<joint name="j{n}" type="prismatic"><parent link="c{n}"/><child link="c{n + 1}"/><axis xyz="1 0 0"/>'
        '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        for n in range(count)
    ]
    start = {f"j{n}": 0.0 for n in range(count)}
    return EngineSetup("\n".join(['<robot name="robot">', *parts, "</robot>"]), "c0", True, start)


@needs_pybullet
def test_pybullet_moves_the_last_of_121_joints_and_rejects_one_more() -> None:
    """It keeps 128 coordinates of a robot (MAX_DEGREE_OF_FREEDOM), and 7 of them are those of the base."""
    robot = open_engine("pybullet", train(121))
    robot.with_effort("j120", 4.0)
    run(robot, 0.01)
    assert robot.velocity("j120") > 0.01
    robot.close()
    with pytest.raises(RobotRejected, match=r"^it has 122 movable joints"):
        open_engine("pybullet", train(122))


def test_mujoco_stands_on_the_corners_of_a_mesh_that_has_a_volume(tmp_path: Path) -> None:
    """The cube is 2 m high, with its origin in the middle."""
    pytest.importorskip("mujoco")
    path = tmp_path / "body.dae"
    urdf = lying(f'<mesh filename="{path}"/>')
    path.write_text(dae(SHOWN), encoding="utf-8")
    with grounded("mujoco", urdf) as robot:
        run(robot, 0.1)
        assert robot.base_pose().z == pytest.approx(1.0, abs=0.002)
    path.write_text(dae(SHOWN, "-1 -1 -1 1 -1 -1 0 1 -1"), encoding="utf-8")
    with pytest.raises(RobotRejected, match=r"^'body\.dae' has no corners that urdfctl can read$"):
        open_engine("mujoco", EngineSetup(urdf, "body", False, {}))
