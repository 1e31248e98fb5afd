"""Plain velocity controllers on the wheels of a base: they drive it, whatever sides the wheels are mounted on."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Rover
from smoking import codes, smoked, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.model.geometry import Pose, Vector, of_angles
from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.robot.shapes import Shape, Shapes, with_rims
from urdfctl.smoke.tasks.inferred_drives import with_inferred_drives
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily

BOTH = """
controller_manager:
  ros__parameters:
    update_rate: 100
    wheels: {type: velocity_controllers/JointGroupVelocityController}
wheels:
  ros__parameters: {joints: [left_wheel, right_wheel]}
"""
EACH = """
controller_manager:
  ros__parameters:
    update_rate: 100
    left: {type: forward_command_controller/ForwardCommandController}
    right: {type: forward_command_controller/ForwardCommandController}
left:
  ros__parameters: {joints: [left_wheel], interface_name: velocity}
right:
  ros__parameters: {joints: [right_wheel], interface_name: velocity}
"""


def of(folder: Path, urdf: str, yaml: str, engine: str) -> RobotResult:
    return whole(target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml}), engine, distro="jazzy")


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("axis", ["0 0 1", "0 0 -1"])
def test_one_controller_of_two_wheels_drives_the_base(tmp_path: Path, engine: str, axis: str) -> None:
    made = of(tmp_path, Rover(axis=axis).urdf(), BOTH, engine)
    assert codes(made) == []
    assert [result.tested for result in made.controllers] == [("started", "drove", "turned")]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_controller_for_each_wheel_drives_the_base_too(tmp_path: Path, engine: str) -> None:
    made = of(tmp_path, Rover().urdf(), EACH, engine)
    assert codes(made) == []
    assert verdicts(made) == {"left": "passed deactivate", "right": "passed deactivate"}


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_mirrored_wheels_are_a_warning_and_drive(tmp_path: Path, engine: str) -> None:
    assert codes(of(tmp_path, Rover().urdf(left="0 0 -1"), BOTH, engine)) == ["UC959"]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_wheels_that_are_too_weak_fail_only_the_controller_that_drives(tmp_path: Path, engine: str) -> None:
    made = of(tmp_path, Rover().urdf(effort="0.00001"), EACH, engine)
    assert codes(made) == ["UC941", "UC962"]
    assert verdicts(made) == {"left": "failed move", "right": "skipped activate"}


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_plain_wheels_that_do_not_reach_the_ground_are_found(tmp_path: Path, engine: str) -> None:
    lifted = Rover().urdf().replace('<origin xyz="0 0.15 0"', '<origin xyz="0 0.15 0.05"')
    assert "UC940" in codes(of(tmp_path, lifted, BOTH, engine))


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_wheels_of_a_robot_that_is_fixed_to_the_world_turn_in_the_air(tmp_path: Path, engine: str) -> None:
    fixed = Rover().urdf().replace('"base_footprint"', '"world"')
    made = of(tmp_path, fixed, BOTH, engine)
    assert codes(made) == []
    assert [result.tested for result in made.controllers] == [("started", "moved")]


def test_without_an_engine_the_wheels_are_checked_once_for_the_base(tmp_path: Path) -> None:
    files = {"robot.urdf": Rover().urdf(effort="0.00001"), "controllers.yaml": EACH}
    diagnostics = smoked(target_of(tmp_path, files), distro="jazzy").linted.outcome.diagnostics
    assert [finding.code for finding in diagnostics] == ["UC962"]


# -- which wheels form a drive -----------------------------------------------------------------------------------------

LEFT, RIGHT = (0.0, 1.0, 0.0), (0.0, -1.0, 0.0)
PAIR = {"l": ((0.0, 0.2, 0.0), LEFT), "r": ((0.0, -0.2, 0.0), LEFT)}
TURNS = ControllerTask("wheels", MotionFamily.FORWARD, ("l", "r"), "velocity")


def drive_of(
    wheels: dict[str, tuple[Vector, Vector]],
    *tasks: ControllerTask,
    radii: dict[str, float] | None = None,
    root: str = "base",
    caster: float = 0.05,
    kind: str = "continuous",
) -> Drive | None:
    """Return the drive that tasks get: of a base with wheels of 0.1 m at some places and axes, and four balls."""
    hinges, known = [], {}
    for name, (place, axis) in wheels.items():
        made = Hinge(name, kind, parent=root, child=f"{name}_link", pose=Pose(place), axis=axis)
        hinges.append(made._replace(lower=-20.0, upper=20.0))
        size = ((radii or {}).get(name, 0.1), 0.04)
        known[f"{name}_link"] = (Shape("cylinder", Pose(turn=of_angles(1.5707963, 0, 0)), size),)
    corners = [(x, y) for x in (-0.2, 0.2) for y in (-0.1, 0.1)]
    known[root] = tuple(Shape("sphere", Pose((x, y, caster - 0.1)), (caster,)) for x, y in corners)
    bodies = {root: LinkBody(root, 10.0), **{hinge.child: LinkBody(hinge.child, 0.5) for hinge in hinges}}
    shapes = Shapes(known)
    made_tasks = with_inferred_drives(
        with_rims(Mechanism(root, bodies, tuple(hinges)), shapes), shapes, tasks or (TURNS,)
    )
    return made_tasks[0].drive


def test_wheels_on_both_sides_form_a_drive_with_the_measures_of_the_robot() -> None:
    found = drive_of(PAIR)
    assert found is not None
    assert (found.left, found.right, found.is_inferred) == (("l",), ("r",), True)
    assert (found.radius, found.separation) == pytest.approx((0.1, 0.4))
    assert (found.left_scale, found.right_scale) == (1.0, 1.0)


def test_the_wheels_of_one_side_may_be_mirrored_but_not_one_of_them() -> None:
    mirrored = drive_of({**PAIR, "r": ((0.0, -0.2, 0.0), RIGHT)})
    assert mirrored is not None
    assert (mirrored.left_scale, mirrored.right_scale) == (1.0, -1.0)
    four = {**PAIR, "l2": ((-0.3, 0.2, 0.0), RIGHT), "r2": ((-0.3, -0.2, 0.0), LEFT)}
    assert drive_of(four, TURNS._replace(joints=tuple(four))) is None
    assert drive_of({**four, "l2": ((-0.3, 0.2, 0.0), LEFT)}, TURNS._replace(joints=tuple(four))) is not None


@pytest.mark.parametrize(("height", "drives"), [(0.104, True), (0.106, False)])
def test_the_wheels_of_a_drive_have_one_radius(height: float, drives: bool) -> None:
    assert (drive_of(PAIR, radii={"l": height}) is not None) == drives


@pytest.mark.parametrize(("place", "drives"), [(0.006, True), (0.004, False), (-0.2, False)])
def test_the_wheels_of_a_drive_are_on_both_sides(place: float, drives: bool) -> None:
    assert (drive_of({**PAIR, "l": ((0.0, place, 0.0), LEFT)}) is not None) == drives


def test_a_third_wheel_in_the_middle_leaves_no_drive() -> None:
    three = {**PAIR, "m": ((0.3, 0.0, 0.0), LEFT)}
    assert drive_of(three, TURNS._replace(joints=tuple(three))) is None


def test_wheels_in_the_air_drive_nothing() -> None:
    assert drive_of({name: ((x, y, 0.05), axis) for name, ((x, y, _), axis) in PAIR.items()}) is None


@pytest.mark.parametrize(
    ("task", "others"),
    [
        (TURNS._replace(interface="position"), ()),
        (TURNS._replace(family=MotionFamily.VELOCITY_PID), ()),
        (TURNS._replace(joints=("l", "r", "arm")), ()),
        (TURNS._replace(joints=("l",)), ()),
        (ControllerTask("states", MotionFamily.NOTHING), (TURNS,)),
        (
            TURNS,
            (ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=Drive(("l",), ("r",))),),
        ),
    ],
    ids=["positions", "loops", "another joint", "one side", "a broadcaster", "a base with a controller"],
)
def test_only_velocities_of_all_wheels_and_of_nothing_else_drive(
    task: ControllerTask, others: tuple[ControllerTask, ...]
) -> None:
    assert drive_of(PAIR, task, *others) is None


def test_wheels_of_a_robot_that_is_fixed_or_that_have_limits_are_no_drive() -> None:
    assert drive_of(PAIR, root="world") is None
    assert drive_of(PAIR, kind="revolute") is None
