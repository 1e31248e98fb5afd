"""The formulas of the smoke test: each tolerance from both sides, and the physics against a second implementation."""

from __future__ import annotations

import math
import random

import pytest

from urdfctl.model.geometry import Pose, of_angles
from urdfctl.smoke.engines.urdf import mechanism_urdf
from urdfctl.smoke.motion.mobile_base import assumed_sides
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.robot.loads import gravity_load, moved_inertias, worst_loads
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.robot.rest_pose import rest_pose_of
from urdfctl.smoke.robot.shapes import Shape, Shapes, rim_of, with_rims
from urdfctl.smoke.statics.drives import drive_troubles
from urdfctl.smoke.statics.efforts import effort_troubles
from urdfctl.smoke.statics.ground import ground_troubles
from urdfctl.smoke.statics.loops.stability import loop_troubles, mass_matrix
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily, PidGains

UP = (0.0, 0.0, 1.0)
LEFT = (0.0, 1.0, 0.0)
EFFORT = ControllerTask("arm", MotionFamily.TRAJECTORY, ("j",), "effort", (PidGains(p=1000.0, d=100.0),))
POSITION = ControllerTask("arm", MotionFamily.TRAJECTORY, ("j",), "position")


def ball(moment: float) -> tuple[tuple[float, float, float], ...]:
    return (moment, 0.0, 0.0), (0.0, moment, 0.0), (0.0, 0.0, moment)


def lift(**fields: object) -> Mechanism:
    """Return a carriage of 10 kg (98.1 N) on a vertical slide of 1 m."""
    hinge = Hinge("j", "prismatic", parent="base", child="arm", pose=Pose(), axis=UP)
    hinge = hinge._replace(lower=0.0, upper=1.0, effort=200.0, velocity=1.0)._replace(**fields)  # type: ignore[arg-type]
    return Mechanism("base", {"base": LinkBody("base"), "arm": LinkBody("arm", 10.0)}, (hinge,))


def lever(mass: float = 1.0, **fields: object) -> Mechanism:
    """Return a lever whose mass is 1 m from a level axis, and hangs down at spawn: 9.81 N m when level."""
    hinge = Hinge("j", "revolute", parent="base", child="arm", pose=Pose(), axis=LEFT)
    hinge = hinge._replace(lower=-2.0, upper=2.0, effort=200.0, velocity=1.0)._replace(**fields)  # type: ignore[arg-type]
    return Mechanism(
        "base", {"base": LinkBody("base"), "arm": LinkBody("arm", mass, centre=(0.0, 0.0, -1.0))}, (hinge,)
    )


def codes(troubles: object) -> list[str]:
    return [trouble.code for trouble in troubles if isinstance(trouble, Trouble)]  # type: ignore[attr-defined]


# -- efforts ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("moment", [0.0, -3.4e-23])
def test_no_effort_is_too_little_for_a_link_without_inertia(moment: float) -> None:
    hinge = lever(0.0).hinges[0]._replace(effort=34.0)
    weightless = Mechanism(
        "base", {"base": LinkBody("base"), "arm": LinkBody("arm", 0.0, inertia=ball(moment))}, (hinge,)
    )
    assert codes(effort_troubles(weightless, [POSITION])) == []


@pytest.mark.parametrize(
    ("limit", "expected"),
    [(98.0, ["UC915"]), (99.0, ["UC950"]), (103.0, ["UC950"]), (104.0, []), (200.0, [])],
)
def test_an_effort_limit_holds_the_weight_with_a_margin_of_a_twentieth(limit: float, expected: list[str]) -> None:
    assert codes(effort_troubles(lift(effort=limit), [POSITION])) == expected


@pytest.mark.parametrize(("limit", "expected"), [(9.0, ["UC950"]), (10.4, [])])
def test_the_weight_is_checked_in_the_worst_pose(limit: float, expected: list[str]) -> None:
    assert codes(effort_troubles(lever(effort=limit), [POSITION])) == expected
    assert worst_loads(lever(effort=limit), lever(effort=limit).hinges)["j"][0] == pytest.approx(9.81, rel=0.02)


@pytest.mark.parametrize(
    ("fields", "expected"),
    [
        ({"friction": 101.0}, []),
        ({"friction": 102.0}, ["UC951"]),
        ({"friction": 200.0}, ["UC951"]),
        ({"damping": 5300.0}, []),
        ({"damping": 5400.0}, ["UC951"]),
        ({"effort": 0.0}, []),
        ({"effort": None}, []),
    ],
)
def test_friction_and_damping_leave_enough_effort(fields: dict[str, float], expected: list[str]) -> None:
    """The test motion is 0.05 m in 2 s with a peak of 0.075 m/s, of which a half must be reached."""
    assert codes(effort_troubles(lift(**fields), [POSITION])) == expected


@pytest.mark.parametrize(("effort", "expected"), [(0.24, ["UC952"]), (0.26, [])])
def test_an_effort_must_cover_the_distance_in_time(effort: float, expected: list[str]) -> None:
    """10 kg cover 0.05 m in 2 s with 0.25 N."""
    assert codes(effort_troubles(lift(effort=effort, axis=LEFT), [POSITION])) == expected


def test_an_effort_limit_of_0_stops_only_a_joint_that_is_commanded_by_effort() -> None:
    assert codes(effort_troubles(lift(effort=0.0), [POSITION])) == []
    assert codes(effort_troubles(lift(effort=0.0), [EFFORT])) == ["UC952"]


@pytest.mark.parametrize(
    ("fields", "text"),
    [
        ({"friction": 200.0}, "has a friction of 200 N: with its effort limit of 200 N it moves not at all"),
        (
            {"friction": 110.0},
            "has a friction of 110 N and carries 98.1 N: with its effort limit of 200 N it moves not",
        ),
        ({"damping": 10000.0}, "has a damping of 10000: with its effort limit of 200 N it moves at most at 0.02 m/s"),
    ],
)
def test_the_message_names_what_uses_up_the_effort(fields: dict[str, float], text: str) -> None:
    (trouble,) = effort_troubles(lift(**fields), [POSITION])
    assert text in trouble.message


@pytest.mark.parametrize(("limit", "text"), [(100.0, "a margin of 2 %"), (101.0, "a margin of 3 %")])
def test_the_margin_is_told_in_per_cent(limit: float, text: str) -> None:
    (trouble,) = effort_troubles(lift(effort=limit), [POSITION])
    assert trouble.message.endswith(text)
    assert trouble.notes == ()


def test_what_is_missing_in_the_worst_pose_is_told_with_the_pose() -> None:
    (trouble,) = effort_troubles(lever(effort=5.0), [POSITION])
    assert trouble.message.endswith(" % too little")
    assert trouble.notes[0].startswith("with j at ")


def test_the_worst_pose_of_a_long_arm_is_found() -> None:
    """Five levers of 1 kg, each 1 m long, hang down; stretched out they weigh 5 + 4 + 3 + 2 + 1 times 9.81 N m."""
    hinges = []
    for n in range(5):
        place = (0.0, 0.0, -1.0 if n else 0.0)
        made = Hinge(f"j{n}", "revolute", parent=f"l{n}", child=f"l{n + 1}", pose=Pose(place), axis=LEFT)
        hinges.append(made._replace(lower=-2.0, upper=2.0, effort=150.0, velocity=1.0))
    bodies = {f"l{n}": LinkBody(f"l{n}", 1.0, centre=(0.0, 0.0, -1.0)) for n in range(1, 6)}
    arm = Mechanism("l0", {"l0": LinkBody("l0"), **bodies}, tuple(hinges))
    assert worst_loads(arm, arm.hinges)["j0"][0] == pytest.approx(15 * 9.81, rel=0.06)


# -- loops -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("d", "expected"), [(0.97, ["UC917"]), (1.03, [])])
def test_a_loop_needs_a_twentieth_of_the_critical_damping(d: float, expected: list[str]) -> None:
    """A mass of 1 kg m² on a gain of 100 swings at 10 rad/s: the damping ratio is d / 20."""
    arm = lever(axis=UP)
    arm = arm._replace(bodies={**arm.bodies, "arm": LinkBody("arm", 1.0, inertia=ball(1.0))})
    task = EFFORT._replace(gains=(PidGains(p=100.0, d=d),))
    assert codes(loop_troubles(arm, [task], 10000.0)) == expected


@pytest.mark.parametrize(("p", "expected"), [(1030.0, []), (950.0, ["UC966"])])
def test_a_joint_sags_by_a_tenth_of_its_range_at_most(p: float, expected: list[str]) -> None:
    task = EFFORT._replace(gains=(PidGains(p=p, d=200.0),))
    assert codes(loop_troubles(lift(), [task], 1000.0)) == expected


def test_the_integral_part_holds_a_weight_up_to_its_clamp() -> None:
    held = EFFORT._replace(gains=(PidGains(p=500.0, i=500.0, d=200.0, clamp=100.0),))
    clamped = EFFORT._replace(gains=(PidGains(p=500.0, i=500.0, d=200.0, clamp=10.0),))
    assert codes(loop_troubles(lift(), [held], 1000.0)) == []
    assert codes(loop_troubles(lift(), [clamped], 1000.0)) == ["UC966"]


# -- wheels ----------------------------------------------------------------------------------------------------------


WHEEL = Shape("cylinder", Pose(turn=of_angles(math.pi / 2, 0, 0)), (0.1, 0.04))
CASTER = Shape("sphere", Pose(), (0.05,))
PAIR = Drive(("l",), ("r",), radius=0.1, separation=0.4, base="base")


def rover(places: dict[str, tuple[float, float, float]], **fields: object) -> tuple[Mechanism, Shapes]:
    """Return a rover with a wheel at each place, and casters in front and behind."""
    bodies = {"base": LinkBody("base", 10.0, centre=(0.0, 0.0, 0.05))}
    hinges = []
    for name, place in places.items():
        made = Hinge(name, "continuous", parent="base", child=f"{name}_link", pose=Pose(place), axis=LEFT)
        hinges.append(made._replace(effort=20.0, velocity=20.0)._replace(**fields))  # type: ignore[arg-type]
        bodies[f"{name}_link"] = LinkBody(f"{name}_link", 0.5)
    known = {f"{name}_link": (WHEEL,) for name in places}
    casters = [CASTER._replace(pose=Pose((x, 0.0, -0.05))) for x in (-0.2, 0.2)]
    shapes = Shapes({**known, "base": tuple(casters)})
    return with_rims(Mechanism("base", bodies, tuple(hinges)), shapes), shapes


def driving(drive: Drive) -> ControllerTask:
    return ControllerTask("base", MotionFamily.DIFFERENTIAL, drive.wheels, "velocity", drive=drive)


BOTH = {"l": (0.0, 0.2, 0.0), "r": (0.0, -0.2, 0.0)}


def wheel_codes(
    drive: Drive, places: dict[str, tuple[float, float, float]] | None = None, **fields: object
) -> list[str]:
    return codes(drive_troubles(rover(places or BOTH, **fields)[0], [driving(drive)]))


@pytest.mark.parametrize(
    ("radius", "separation", "expected"),
    [
        (0.1, 0.4, []),
        (0.114, 0.4, []),
        (0.116, 0.4, ["UC913"]),
        (0.086, 0.4, []),
        (0.084, 0.4, ["UC913"]),
        (0.1, 0.459, []),
        (0.1, 0.461, ["UC913"]),
    ],
)
def test_the_measures_of_wheels_may_differ_by_a_seventh(radius: float, separation: float, expected: list[str]) -> None:
    assert wheel_codes(PAIR._replace(radius=radius, separation=separation)) == expected


def test_the_radius_multipliers_count() -> None:
    assert wheel_codes(PAIR._replace(radius=0.05, left_scale=2.0, right_scale=2.0)) == []
    assert wheel_codes(PAIR._replace(radius=0.05, left_scale=2.0)) == ["UC913"]


def test_swapped_sides_are_one_finding_and_a_single_wrong_wheel_another() -> None:
    assert wheel_codes(PAIR._replace(left=("r",), right=("l",))) == ["UC911"]
    four = {**BOTH, "ll": (-0.3, 0.2, 0.0), "rr": (-0.3, -0.2, 0.0)}
    skid = PAIR._replace(left=("l", "ll"), right=("r", "rr"))
    assert wheel_codes(skid, four) == []
    assert wheel_codes(skid._replace(left=("l",), right=("r", "rr", "ll")), four) == ["UC960"]


@pytest.mark.parametrize(("tilt", "expected"), [(0.77, []), (0.80, ["UC912", "UC912"]), (math.pi, ["UC912", "UC912"])])
def test_the_axis_of_a_wheel_points_to_the_left(tilt: float, expected: list[str]) -> None:
    axis = (math.sin(tilt), math.cos(tilt), 0.0)
    assert [code for code in wheel_codes(PAIR, axis=axis) if code == "UC912"] == expected


@pytest.mark.parametrize(("reach", "expected"), [(6.2, ["UC955", "UC955"]), (6.3, [])])
def test_a_wheel_turns_at_least_twice(reach: float, expected: list[str]) -> None:
    assert wheel_codes(PAIR, type="revolute", lower=-reach, upper=reach) == expected


@pytest.mark.parametrize(("velocity", "expected"), [(0.19, ["UC964"]), (0.21, [])])
def test_a_base_reaches_two_centimetres_a_second(velocity: float, expected: list[str]) -> None:
    assert wheel_codes(PAIR, velocity=velocity) == expected


@pytest.mark.parametrize(("effort", "expected"), [(0.081, ["UC962"]), (0.084, [])])
def test_wheels_accelerate_the_robot_within_two_seconds(effort: float, expected: list[str]) -> None:
    """11 kg reach 0.3 m/s in 2 s with 1.65 N, which two wheels of 0.1 m give with 0.0825 N m each."""
    assert wheel_codes(PAIR, effort=effort) == expected


STEERED = Drive(driven=("r", "l"), steered=("s",), radius=0.1, wheelbase=0.6, base="base")


@pytest.mark.parametrize(
    ("fields", "wheelbase", "expected"),
    [
        ({}, 0.6, []),
        ({}, 0.68, []),
        ({}, 0.70, ["UC913"]),
        ({"lower": -0.049}, 0.6, ["UC956"]),
        ({"lower": -0.051}, 0.6, []),
        ({"axis": (0.0, 0.0, -1.0)}, 0.6, ["UC961"]),
        ({"axis": (0.0, 0.71, 0.704)}, 0.6, []),
        ({"axis": (0.0, 0.72, 0.694)}, 0.6, ["UC961"]),
    ],
)
def test_steering(fields: dict[str, object], wheelbase: float, expected: list[str]) -> None:
    mechanism, _ = rover(BOTH)
    pivot = Hinge(
        "s", "revolute", parent="base", child="fork", pose=Pose((0.6, 0.0, 0.0)), axis=UP, lower=-0.5, upper=0.5
    )
    pivot = pivot._replace(**fields)  # type: ignore[arg-type]
    bodies = {**mechanism.bodies, "fork": LinkBody("fork")}
    mechanism = Mechanism("base", bodies, (*mechanism.hinges, pivot))
    assert codes(drive_troubles(mechanism, [driving(STEERED._replace(wheelbase=wheelbase))])) == expected


def test_the_list_of_two_driven_wheels_begins_with_the_right_one() -> None:
    assert wheel_codes(STEERED._replace(driven=("l", "r"), steered=("none",))) == ["UC960"]


def test_a_steering_controller_takes_the_first_of_two_wheels_as_the_right_one() -> None:
    mechanism, _ = rover(BOTH)
    steered = driving(STEERED._replace(driven=("l", "r"), track=0.6))
    assert assumed_sides(mechanism, steered, steered.drive or PAIR) == {"l": -0.3, "r": 0.3}
    bare = driving(STEERED._replace(driven=("l", "r")))
    assert assumed_sides(mechanism, bare, bare.drive or PAIR) == pytest.approx({"l": -0.2, "r": 0.2})
    assert assumed_sides(mechanism, driving(PAIR), PAIR) == pytest.approx({"l": 0.2, "r": -0.2})


# -- the ground ------------------------------------------------------------------------------------------------------


def ground_codes(places: dict[str, tuple[float, float, float]], centre: float = 0.0) -> list[str]:
    mechanism, shapes = rover(places)
    base = mechanism.bodies["base"]._replace(centre=(centre, 0.0, 0.05))
    mechanism = mechanism._replace(bodies={**mechanism.bodies, "base": base})
    return codes(ground_troubles(mechanism, shapes, [driving(PAIR)]))


def test_a_rover_stands_on_its_wheels_and_casters() -> None:
    mechanism, shapes = rover(BOTH)
    at_rest = rest_pose_of(mechanism, shapes)
    assert at_rest is not None
    assert at_rest.tilt < 0.001
    assert max(at_rest.heights.values()) < 0.001
    assert ground_codes(BOTH) == []


@pytest.mark.parametrize(("height", "expected"), [(0.001, []), (0.002, ["UC940"]), (0.05, ["UC940"])])
def test_a_wheel_that_is_mounted_too_high_does_not_touch_the_ground(height: float, expected: list[str]) -> None:
    """The robot leans on one of the two wheels: the other one is twice as high, and 3 mm count as touching."""
    assert ground_codes({"l": (0.0, 0.2, height), "r": (0.0, -0.2, height)}) == expected


def test_a_centre_of_mass_beyond_the_wheels_tips_the_robot_over() -> None:
    assert ground_codes(BOTH, 0.19) == []
    assert ground_codes(BOTH, 0.4) == ["UC931"]


def test_a_wheel_without_collision_geometry_does_not_touch_the_ground() -> None:
    mechanism, shapes = rover(BOTH)
    bare = Shapes({**shapes.known, "l_link": ()})
    assert codes(ground_troubles(mechanism, bare, [driving(PAIR)])) == ["UC940"]
    unknown = Shapes({**shapes.known, "l_link": ()}, frozenset({"l_link"}))
    assert codes(ground_troubles(mechanism, unknown, [driving(PAIR)])) == []


@pytest.mark.parametrize(
    ("shape", "radius", "place"),
    [
        (WHEEL, 0.1, 0.0),
        (Shape("sphere", Pose((0.0, 0.03, 0.0)), (0.1,)), 0.1, 0.03),
        (Shape("box", Pose(), (0.2, 0.04, 0.2)), math.hypot(0.1, 0.1), 0.0),
        (Shape("mesh", Pose(), (), ((0.1, 0.02, 0.0), (-0.1, 0.04, 0.0), (0.0, 0.0, 0.05))), 0.1, 0.03),
    ],
)
def test_the_rim_of_a_wheel_is_measured_on_its_shape(shape: Shape, radius: float, place: float) -> None:
    rim = rim_of((shape,), LEFT)
    assert rim is not None
    assert (rim.radius, rim.place) == pytest.approx((radius, place))


# -- a second implementation -----------------------------------------------------------------------------------------


def random_tree(seed: int) -> Mechanism:
    chance = random.Random(seed)  # noqa: S311 (no secret)

    def vector(size: float) -> tuple[float, float, float]:
        return chance.uniform(-size, size), chance.uniform(-size, size), chance.uniform(-size, size)

    bodies, hinges = {"l0": LinkBody("l0", 1.0, inertia=ball(0.01))}, []
    for n in range(1, 7):
        x, y, z = vector(1.0)
        length = math.sqrt(x * x + y * y + z * z)
        kind = chance.choice(["revolute", "prismatic", "continuous"])
        pose = Pose(vector(0.5), of_angles(*vector(3.0)))
        made = Hinge(f"j{n}", kind, parent=f"l{chance.randrange(n)}", child=f"l{n}", pose=pose, axis=UP)
        hinges.append(made._replace(axis=(x / length, y / length, z / length), lower=-2.0, upper=2.0))
        bodies[f"l{n}"] = LinkBody(
            f"l{n}", chance.uniform(0.1, 5.0), centre=vector(0.3), inertia=ball(chance.uniform(0.01, 0.1))
        )
    return Mechanism("l0", bodies, tuple(hinges))


@pytest.mark.parametrize("seed", range(8))
def test_weights_and_inertias_agree_with_those_of_mujoco(seed: int) -> None:
    mujoco = pytest.importorskip("mujoco")
    tree = random_tree(seed)
    compiler = '<mujoco><compiler fusestatic="false" balanceinertia="false" angle="radian"/></mujoco>'
    text = mechanism_urdf(tree).replace('<robot name="robot">', f'<robot name="robot">{compiler}', 1)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    positions = {f"j{n}": 0.3 * n - 1.0 for n in range(1, 7)}
    names = [mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_JOINT, n) for n in range(model.njnt)]
    data.qpos[:] = [positions[name] for name in names]
    mujoco.mj_inverse(model, data)
    expected = dict(zip(names, map(float, data.qfrc_inverse), strict=True))
    assert gravity_load(tree, positions) == pytest.approx(expected, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("seed", range(8))
def test_the_inertias_of_single_joints_are_the_diagonal_of_the_mass_matrix(seed: int) -> None:
    tree = random_tree(seed)
    matrix = mass_matrix(tree, tree.movable)
    expected = {hinge.name: matrix[n][n] for n, hinge in enumerate(tree.movable)}
    assert moved_inertias(tree) == pytest.approx(expected, rel=1e-9)
