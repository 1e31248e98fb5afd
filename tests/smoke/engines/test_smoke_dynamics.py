"""The dynamics of several joints against MuJoCo as a second implementation, and against the conservation of energy."""

from __future__ import annotations

import math
import random
from typing import Any

import pytest
from smoking_engines import EACH_ENGINE

from urdfctl.model.geometry import Pose, Rotation, of_angles
from urdfctl.smoke.engines.engine import STEP, EngineSetup, open_engine
from urdfctl.smoke.engines.urdf import mechanism_urdf
from urdfctl.smoke.robot.loads import GRAVITY
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.statics.loops.stability import closed_loop, mass_matrix
from urdfctl.smoke.tasks.task import PidGains

COMPILER = '<mujoco><compiler fusestatic="false" balanceinertia="false" angle="radian"/></mujoco>'


def arm(seed: int) -> Mechanism:
    """Return an arm of three links: two joints that turn about odd axes, and one that slides or turns."""
    chance = random.Random(seed)  # noqa: S311 (a sample)

    def vector(size: float) -> tuple[float, float, float]:
        return chance.uniform(-size, size), chance.uniform(-size, size), chance.uniform(-size, size)

    bodies, hinges = {"l0": LinkBody("l0", 1.0, inertia=ball(0.01))}, []
    for n, kind in enumerate(("revolute", "revolute", chance.choice(["prismatic", "revolute"])), 1):
        x, y, z = vector(1.0)
        length = math.sqrt(x * x + y * y + z * z)
        pose, axis = Pose(vector(0.4), of_angles(*vector(3.0))), (x / length, y / length, z / length)
        hinge = Hinge(f"j{n}", kind, parent=f"l{n - 1}", child=f"l{n}", pose=pose, axis=axis, lower=-3.0, upper=3.0)
        hinges.append(hinge)
        moment = ball(chance.uniform(0.01, 0.05))
        bodies[f"l{n}"] = LinkBody(f"l{n}", chance.uniform(0.5, 3.0), centre=vector(0.3), inertia=moment)
    return Mechanism("l0", bodies, tuple(hinges))


def ball(moment: float) -> Rotation:
    return (moment, 0.0, 0.0), (0.0, moment, 0.0), (0.0, 0.0, moment)


def in_mujoco(robot: Mechanism) -> tuple[Any, Any, Any]:
    """Return MuJoCo, and the robot in it at its start."""
    mujoco = pytest.importorskip("mujoco")
    text = mechanism_urdf(robot).replace('<robot name="robot">', f'<robot name="robot">{COMPILER}', 1)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return mujoco, model, data


@pytest.mark.parametrize("seed", range(6))
def test_the_mass_matrix_is_that_of_mujoco(seed: int) -> None:
    robot = arm(seed)
    mujoco, model, data = in_mujoco(robot)
    numpy = pytest.importorskip("numpy")
    expected = numpy.zeros((3, 3))
    mujoco.mj_fullM(model, data, expected)
    assert numpy.array(mass_matrix(robot, robot.movable)) == pytest.approx(expected, rel=1e-6, abs=1e-9)


def simulated_growth(robot: Mechanism, gains: list[PidGains], period: float, swing: float) -> float:
    """Return the growth of the loop's motion in a period, from the motion of the robot in MuJoCo without gravity.

    The motion is scaled back after each period, so that it stays small. Its size counts velocities as those of a swing,
    in rad/s.
    """
    mujoco, model, data = in_mujoco(robot)
    steps, updates, small = 20, 800, 1e-5
    model.opt.timestep, model.opt.integrator = period / steps, mujoco.mjtIntegrator.mjINT_RK4
    model.opt.gravity[:] = 0
    data.qpos[:] = [small, -small, small / 2]
    growths = []
    for _ in range(updates):
        data.qfrc_applied[:] = [-g.p * q - g.d * v for g, q, v in zip(gains, data.qpos, data.qvel, strict=True)]
        for _ in range(steps):
            mujoco.mj_step(model, data)
        size = math.hypot(*data.qpos, *(data.qvel / swing)) / small
        data.qpos /= size
        data.qvel /= size
        growths.append(math.log(size))
    half = growths[updates // 2 :]
    return math.exp(sum(half) / len(half))


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize(("p", "d", "grows"), [(0.02, 0.2, False), (2.5, 0.5, True)])
def test_coupled_loops_grow_as_fast_as_in_mujoco(seed: int, p: float, d: float, *, grows: bool) -> None:
    robot, period = arm(seed), 0.01
    inertia = mass_matrix(robot, robot.movable)
    own = [inertia[n][n] for n in range(len(inertia))]
    gains = [PidGains(p=p * moment / period**2, d=d * moment / period) for moment in own]
    growth, _ = closed_loop(inertia, [[0.0] * 3 for _ in gains], [0.0] * 3, gains, period)
    assert (growth > 1.0) == grows
    assert simulated_growth(robot, gains, period, math.sqrt(p) / period) == pytest.approx(growth, rel=3e-3)


def energy(robot: Mechanism, positions: dict[str, float], velocities: dict[str, float]) -> tuple[float, float]:
    """Return the kinetic and the potential energy of a robot, in J, by the formulas of the smoke test."""
    hinges = tuple(hinge._replace(initial=positions[hinge.name]) for hinge in robot.hinges)
    here = robot._replace(hinges=hinges)
    matrix, poses = mass_matrix(here, here.movable), here.poses(positions)
    speeds = [velocities[hinge.name] for hinge in here.movable]
    kinetic = sum(matrix[n][m] * a * b for n, a in enumerate(speeds) for m, b in enumerate(speeds)) / 2
    return kinetic, sum(-GRAVITY[2] * body.mass * poses[body.name].at(body.centre)[2] for body in robot.bodies.values())


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("seed", range(4))
def test_an_arm_that_falls_keeps_its_energy(engine: str, seed: int) -> None:
    """Coriolis and centrifugal forces do no work; without them, or with a wrong inertia, the sum would change."""
    robot = arm(seed)
    names = [hinge.name for hinge in robot.hinges]
    falling = open_engine(engine, EngineSetup(mechanism_urdf(robot), root="l0", fixed=True, start=robot.start()))
    try:
        for name in names:
            falling.with_effort(name, 0.0)
        _, before = energy(robot, robot.start(), dict.fromkeys(names, 0.0))
        for _ in range(round(0.3 / STEP)):
            falling.step()
        positions = {name: falling.position(name) for name in names}
        kinetic, potential = energy(robot, positions, {name: falling.velocity(name) for name in names})
    finally:
        falling.close()
    assert kinetic > 0.5
    assert kinetic == pytest.approx(before - potential, rel=0.03)
