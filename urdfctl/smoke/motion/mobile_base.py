"""Mobile bases in an engine: they drive forward and turn on the ground, or turn their wheels in the air."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from urdfctl.smoke.motion.checks import SLIPPING, Journey, forward_troubles, turn_troubles
from urdfctl.smoke.motion.motions import WheelMotion
from urdfctl.smoke.motion.rollers import Twist, commands, motion_of_base, roller_troubles, wheel_speeds
from urdfctl.smoke.motion.simulation import RobotSimulation
from urdfctl.smoke.results import Curve, Trouble
from urdfctl.smoke.robot import Mechanism, wheels_of
from urdfctl.smoke.tasks import FREELY, ControllerTask, Drive, effort_of, speed_of, turning_of
from urdfctl.startup.records import NamedTuple

ROLLING = 0.5
"""The time for which wheels with rollers turn for each motion, in s."""


class MotionOutcome(NamedTuple):
    """The result of moving one controller's joints or base. why_not: why it could not be tested, or empty."""

    troubles: tuple[Trouble, ...] = ()
    curves: tuple[Curve, ...] = ()
    why_not: str = ""


def drive_base(simulation: RobotSimulation, task: ControllerTask) -> MotionOutcome:
    """Return what a base does when its controller drives it forward and turns it left."""
    mechanism, plan = simulation.mechanism, simulation.plan
    drive = with_measured_wheels(mechanism, task.drive or Drive())
    turns = drive.separation if drive.left else drive.wheelbase if drive.steered else 1.0
    if not turns or not all(map(drive.radius_of, drive.wheels)):
        return MotionOutcome(why_not="not simulated: the radius or separation of its wheels is unknown")
    slipping = SLIPPING if plan.engine == "mujoco" else 0.0
    hinges = simulation.hinges
    speed = speed_of(drive, (hinges.get(name) for name in drive.wheels))
    straight = wheel_motion_of(simulation, task, drive, speed, 0.0)
    journey, curve = _journey(simulation, straight, task, drive, "ahead")
    troubles, curves = list(forward_troubles(task, journey, slipping)), [curve]
    if not troubles:
        forward = speed if drive.steered else 0.0
        turning = wheel_motion_of(simulation, task, drive, forward, turning_of(drive, speed))
        journey, curve = _journey(simulation, turning, task, drive, "yaw")
        troubles += turn_troubles(task, drive, journey, slipping)
        curves.append(curve)
    stop_wheels(simulation, drive)
    return MotionOutcome(tuple(troubles), tuple(curves))


def wheel_motion_of(
    simulation: RobotSimulation, task: ControllerTask, drive: Drive, forward: float, turning: float
) -> WheelMotion:
    """Return the wheels of a base that drives forward, in m/s, and turns left, in rad/s."""
    sides = assumed_sides(simulation.mechanism, task, drive)
    wheels = WheelMotion(simulation.engine, simulation.hinges, drive, forward, turning, sides=sides)
    gains = dict(zip(task.joints, task.gains, strict=False)) if not drive.is_inferred else {}
    loops = {name: gain for name, gain in gains.items() if name in drive.wheels}
    if loops:
        wheels.close_loops(loops, task.interface)
    return wheels


def assumed_sides(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> dict[str, float]:
    """Return how far to the left of the base each wheel is for its controller, in m.

    A steering controller takes two wheels as the right and the left one, with the track width that it is given.
    """
    sides = {wheel.hinge.name: wheel.place[1] for wheel in wheels_of(mechanism, task.joints, drive.base)}
    for names, track in ((drive.driven, drive.track), (drive.steered, drive.steering_track or drive.track)):
        if drive.steered and len(names) == 2 and sides.keys() >= set(names):  # noqa: PLR2004
            half = (track or abs(sides[names[0]] - sides[names[1]])) / 2
            sides[names[0]], sides[names[1]] = -half, half
    return sides


def _journey(
    simulation: RobotSimulation, wheels: WheelMotion, task: ControllerTask, drive: Drive, quantity: str
) -> tuple[Journey, Curve]:
    engine, period = simulation.engine, simulation.period
    before = now = engine.base_pose()
    start, facing = _rolled(simulation, drive), facing_of(simulation.mechanism, drive)
    yaw, yaws, ahead, wanted = 0.0, [], [], []
    for update in range(round(simulation.plan.duration / period)):
        wheels.update(update * period, period)
        simulation.update()
        last, now = now, engine.base_pose()
        yaw += (now.yaw - last.yaw + math.pi) % (2 * math.pi) - math.pi
        yaws.append(yaw)
        ahead.append(Journey(before, now, yaw, wheels.distance, wheels.angle, facing=facing).ahead)
        wanted.append(wheels.distance if quantity == "ahead" else wheels.angle)
    curve = simulation.curve(task.controller, "base", quantity, wanted, ahead if quantity == "ahead" else yaws)
    rolled = (_rolled(simulation, drive) - start) / wheels.distance if wheels.distance else 1.0
    return Journey(before, now, yaw, wheels.distance, wheels.angle, facing=facing, rolled=rolled), curve


def _rolled(simulation: RobotSimulation, drive: Drive) -> float:
    """How far the driven wheels of a base have rolled on average by their controller's radius, in m."""
    return sum(simulation.engine.position(name) * drive.radius_of(name) for name in drive.wheels) / len(drive.wheels)


def stop_wheels(simulation: RobotSimulation, drive: Drive) -> None:
    """Stop the wheels of a base."""
    for name in drive.wheels:
        simulation.engine.at_velocity(name, 0.0, FREELY)
    simulation.run_for(0.1)


def facing_of(mechanism: Mechanism, drive: Drive) -> float:
    """Return the direction of the frame that a controller drives, from the root's x axis, in rad."""
    pose = mechanism.poses(mechanism.start()).get(drive.base)
    return math.atan2(pose.turn[1][0], pose.turn[0][0]) if pose else 0.0


def with_measured_wheels(mechanism: Mechanism, drive: Drive) -> Drive:
    """Return a drive with the measures that its controller lacks taken from the robot, as in ROS 1."""
    poses = mechanism.poses(mechanism.start())
    wheels = [hinge for name in drive.wheels if (hinge := mechanism.hinge(name)) is not None]
    radius = drive.radius or next((r for hinge in wheels if (r := mechanism.bodies[hinge.child].radius)), 0.0)
    separation = drive.separation
    if drive.left and drive.right and not separation:
        sides = [
            poses[hinge.child].place[1] for name in (drive.left[0], drive.right[0]) if (hinge := mechanism.hinge(name))
        ]
        separation = abs(sides[0] - sides[-1])
    return drive._replace(radius=radius, separation=separation)


# -- wheels with rollers ---------------------------------------------------------------------------------------------


def turn_rollers(simulation: RobotSimulation, task: ControllerTask) -> MotionOutcome:
    """Return what a base with rollers would do, while its wheels turn in the air for each of three motions."""
    drive = task.rolling or Drive()
    if not simulation.plan.fixed:
        return MotionOutcome(why_not="not simulated: the robot stands on other driven wheels too")
    troubles, curves = list[Trouble](), list[Curve]()
    for twist in commands(simulation.mechanism, drive):
        wanted, actual, of_wheels = _turned(simulation, task, drive, twist)
        if actual is None:
            return MotionOutcome(why_not="not simulated: its wheels cannot move it in all directions")
        troubles += roller_troubles(task, wanted, actual)
        curves += of_wheels if twist.ahead else []
    stop_wheels(simulation, drive)
    return MotionOutcome(tuple(troubles), tuple(curves))


def _turned(
    simulation: RobotSimulation, task: ControllerTask, drive: Drive, twist: Twist
) -> tuple[Twist, Twist | None, list[Curve]]:
    """The commanded and the actual motion of the base, and the curves of its wheels."""
    engine, speeds = simulation.engine, wheel_speeds(drive, twist)
    before = _angles(simulation, drive)
    tracks: dict[str, list[float]] = {name: [] for name in drive.driven}
    updates = max(4, round(ROLLING / simulation.period))
    for _ in range(updates):
        for name, speed in speeds.items():
            engine.at_velocity(name, speed, effort_of(simulation.hinges[name]))
        simulation.update()
        for name, track in tracks.items():
            track.append(engine.velocity(name))
    after = _angles(simulation, drive)
    wanted = Twist(*(value * updates * simulation.period for value in twist))
    actual = motion_of_base(simulation.mechanism, drive, {name: after[name] - before[name] for name in after})
    curves = [
        simulation.curve(task.controller, name, "velocity", [speeds[name]] * updates, track)
        for name, track in tracks.items()
    ]
    return wanted, actual, curves


def _angles(simulation: RobotSimulation, drive: Drive) -> Mapping[str, float]:
    return {name: simulation.engine.position(name) for name in drive.driven}


def wheels_of_drives(tasks: tuple[ControllerTask, ...]) -> Iterator[str]:
    """Yield the joints of all wheels that drive a base on the ground."""
    for task in tasks:
        if task.drive:
            yield from task.drive.wheels
