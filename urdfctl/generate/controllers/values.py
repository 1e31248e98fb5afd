"""The values of `$name` in the recipes, for one controller."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from urdfctl.generate.controllers.gains import Gains, Loop, starting_gains
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.drive_limits import DRIVE_LIMITS, drive_limit
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.generate.robot.wheels import Measure, across, along, from_centre, radius
from urdfctl.startup.records import NamedTuple


class Left(NamedTuple):
    """The answer for a parameter that is left out."""


LEFT_OUT = Left()
TODO = "TODO"


class Answer(NamedTuple):
    """A value, and a comment on how it was determined."""

    value: object
    how: str = ""


class Task(NamedTuple):
    """A controller to create: its joints, by role if it is a drive, and the interfaces that it commands and reads.

    `passive` are the wheels of a drive that are neither driven nor steered. `below` is the prefix of the commanded
    interfaces: the name of another controller and a slash. `fit` are the interfaces that such a controller can command.
    """

    kind: str
    interfaces: tuple[str, ...]
    joints: tuple[JointFacts, ...]
    robot: RobotFacts
    options: GeneratorOptions
    states: tuple[str, ...]
    left: tuple[JointFacts, ...] = ()
    right: tuple[JointFacts, ...] = ()
    traction: tuple[JointFacts, ...] = ()
    steering: tuple[JointFacts, ...] = ()
    passive: tuple[JointFacts, ...] = ()
    below: str = ""
    fit: tuple[str, ...] = ()

    @property
    def interface(self) -> str:
        """The first interface that it commands."""
        return self.interfaces[0]

    @property
    def is_drive(self) -> bool:
        """Whether its joints are wheels."""
        return bool(self.left or self.traction)


def answer(name: str, task: Task, joint: JointFacts | None) -> Answer | Left:
    """Return the value of a `$name`. Gains and limits are those of one joint."""
    if name in _OF_JOINT:
        return _OF_JOINT[name](task, joint or task.joints[0])
    if name in _MEASURED:
        measure = _MEASURED[name](task)
        return (
            Answer(*measure) if measure.value is not None else Answer(_STAND_INS.get(name, 0.1), f"{TODO}: measure it")
        )
    return _OTHERS[name](task)


def gains(task: Task, joint: JointFacts) -> Gains:
    """Return the gains of a joint, from the controller's reference and its command interface."""
    loop = Loop(1 / rate_of(task), len(task.joints), grips=task.kind == "gripper")
    return starting_gains(joint, reference(task), task.interface, loop)


def rate_of(task: Task) -> int:
    """Return the update rate that a controller needs, in Hz, unless the user gives one."""
    if task.options.ros == 1:  # gazebo_ros_control updates at every step of the simulation
        return _FAST
    return task.options.rate or (_FAST if closes_loop(task) else _USUAL)


_FAST, _USUAL = 1000, 100


def closes_loop(task: Task) -> bool:
    """Return whether a controller holds positions or velocities by commanding efforts."""
    return task.interface == "effort" and task.kind in ("trajectory", "position", "velocity", "gripper", "pid")


def reference(task: Task) -> str:
    """Return the controller's reference, `position` or `velocity`."""
    if task.kind in ("velocity", "diff_drive") or (task.kind == "pid" and "position" not in task.states):
        return "velocity"
    return "position"


def _gain(letter: str) -> Callable[[Task, JointFacts], Answer | Left]:
    def found(task: Task, joint: JointFacts) -> Answer | Left:
        if task.interface == "position" or (task.kind in ("velocity", "effort") and task.kind == task.interface):
            return LEFT_OUT
        value = getattr(gains(task, joint), letter)
        return LEFT_OUT if value is None else Answer(value)

    return found


def _tolerance(part: float, least: float = 0.0) -> Callable[[Task, JointFacts], Answer | Left]:
    """A part of a joint's range, or of a radian, as a tolerance of its position; at least some of it, in m."""

    def found(task: Task, joint: JointFacts) -> Answer | Left:
        del task
        if joint.slides:
            span = (joint.upper - joint.lower) if joint.lower is not None and joint.upper is not None else 0.1
            return Answer(float(f"{max(max(span, 0.01) * part, least):.2g}"), "m")
        return Answer(part, "rad")

    return found


def _bound(sign: float) -> Callable[[Task, JointFacts], Answer | Left]:
    """The limits of the integral part, where there is one."""

    def found(task: Task, joint: JointFacts) -> Answer | Left:
        clamp = LEFT_OUT if task.options.ros == 1 else _gain("i_clamp")(task, joint)
        return clamp if isinstance(clamp, Left) else Answer(sign * float(str(clamp.value)))

    return found


def _windup(task: Task, joint: JointFacts) -> Answer | Left:
    if gains(task, joint).i:
        return Answer("conditional_integration", "the integral part stops growing at the limits of the command")
    return Answer("none", "not needed while i is 0")


def _feed_forward(task: Task, joint: JointFacts) -> Answer | Left:
    del joint
    return Answer(1.0) if task.interface == "velocity" else LEFT_OUT


def _max_effort(task: Task, joint: JointFacts) -> Answer | Left:
    if task.interface == "position" and task.options.ros == 2:  # noqa: PLR2004
        return LEFT_OUT
    if joint.effort:
        return Answer(joint.effort, "the joint's limit")
    return Answer(10.0, f"{TODO}: the joint has no limit")


def _clamp(sign: float) -> Callable[[Task, JointFacts], Answer | Left]:
    def found(task: Task, joint: JointFacts) -> Answer | Left:
        limit = joint.effort if task.interface == "effort" else joint.velocity
        return Answer(sign * limit) if limit else LEFT_OUT

    return found


def _names(joints: Sequence[JointFacts], below: str = "") -> Answer:
    return Answer([f"{below}{joint.name}" for joint in joints])


def _sensor(task: Task) -> Answer:
    if task.options.sensor:
        return Answer(task.options.sensor)
    return Answer(_SENSORS.get(task.kind, "sensor"), f"{TODO}: set its name")


_SENSORS = {
    "imu_broadcaster": "imu_sensor",
    "force_torque_broadcaster": "force_torque_sensor",
    "admittance": "force_torque_sensor",
    "pose_broadcaster": "pose",
    "range_broadcaster": "range_sensor",
    "gps_broadcaster": "gps_sensor",
    "magnetometer_broadcaster": "magnetometer",
}


def _one(joint: JointFacts, task: Task) -> Answer:
    return Answer(f"{task.below}{joint.name}")


def _offers(task: Task, interface: str) -> bool:
    """Whether the sensor offers a state interface."""
    return any(part.name == task.options.sensor and interface in part.states for part in task.robot.parts)


def _full_states(task: Task) -> Answer:
    """The state interfaces of all joints. Full names stay unchanged."""
    return Answer([name for state in task.states for name in ([state] if "/" in state else _below_joints(task, state))])


def _tip(task: Task) -> Answer:
    """The tool's link: from the user, or the child link of the last joint."""
    if task.options.frame:
        return Answer(task.options.frame)
    last = task.joints[-1].link if task.joints else None
    return Answer(
        last or "tool0", f"{TODO}: check it; this is the last joint's link" if last else f"{TODO}: set its name"
    )


def _batteries(task: Task) -> Answer:
    found = [part.name for part in task.robot.parts if "battery_voltage" in part.states]
    return Answer(found) if found else Answer(["battery"], f"{TODO}: set its name")


def _below_joints(task: Task, state: str) -> list[str]:
    return [f"{joint.name}/{state}" for joint in task.joints]


def _of_gpio(commands: bool) -> Callable[[Task, JointFacts], Answer | Left]:  # noqa: FBT001
    """The interfaces of a gpio: those that the user gives by full name, or all that the robot offers."""

    def found(task: Task, gpio: JointFacts) -> Answer | Left:
        asked = [*task.options.interfaces, *(task.options.states or ())]
        if any("/" in name for name in asked):
            mine = task.options.interfaces if commands else task.options.states or ()
            names = [name.rpartition("/")[2] for name in mine if name.startswith(f"{gpio.name}/")]
            return Answer(names) if names else LEFT_OUT
        part = next((known for known in task.robot.of_kind("gpio") if known.name == gpio.name), None)
        if part is None:
            return Answer(["output"], f"{TODO}: set its interfaces") if commands else LEFT_OUT
        names = [*(part.commands if commands else part.states)]
        return Answer(names) if names else LEFT_OUT

    return found


def _extra(interface: str) -> Callable[[Task, JointFacts], Answer | Left]:
    """An additional command interface of a joint, if the robot has it."""

    def found(task: Task, joint: JointFacts) -> Answer | Left:
        there = interface in task.robot.interfaces.get(joint.name, ())
        return Answer(f"{joint.name}/{interface}") if there else LEFT_OUT

    return found


def _frame(task: Task) -> Answer:
    if task.options.frame:
        return Answer(task.options.frame)
    names = [task.options.sensor] if task.options.sensor else [part.name for part in task.robot.of_kind("sensor")[:1]]
    mounted = next((task.robot.sensor_links[name] for name in names if name in task.robot.sensor_links), None)
    if mounted:
        return Answer(mounted, "the sensor's link")
    return Answer(task.robot.root or "base_link", f"{TODO}: check it; this is the root link")


def _half(joints: Sequence[JointFacts], first: bool) -> Answer:  # noqa: FBT001
    """The two front joints, or the two rear joints, of four."""
    ordered = sorted(joints, key=lambda joint: -(joint.at or (0.0, 0.0, 0.0))[0])
    return _names(ordered[:2] if first else ordered[2:4])


def _mecanum(task: Task) -> Measure:
    sideways = across(task.left, task.right)
    lengthways = along((task.left[0], task.right[0]), (task.left[-1], task.right[-1]))
    if sideways.value is None or lengthways.value is None:
        return Measure(None, "")
    return Measure(round(sideways.value / 2 + lengthways.value / 2, 5), "measured between the joints")


def _tricycle(task: Task) -> Measure:
    return along(task.passive, task.steering) if task.passive else Measure(None, "")


_OF_JOINT: Mapping[str, Callable[[Task, JointFacts], Answer | Left]] = {
    "joint": lambda _, joint: Answer(joint.name),
    "p": _gain("p"),
    "i": _gain("i"),
    "d": _gain("d"),
    "path_tolerance": _tolerance(0.2),
    "grip_tolerance": _tolerance(0.05, least=0.001),
    "goal_tolerance": _tolerance(0.05),
    "i_clamp": _gain("i_clamp"),
    "i_clamp_max": _bound(1.0),
    "i_clamp_min": _bound(-1.0),
    "windup": _windup,
    "ff": _feed_forward,
    "max_effort": _max_effort,
    "gpio_commands": _of_gpio(commands=True),
    "gpio_states": _of_gpio(commands=False),
    "effort_limit": _extra("set_gripper_max_effort"),
    "velocity_limit": _extra("set_gripper_max_velocity"),
    "max_command": _clamp(1.0),
    "min_command": _clamp(-1.0),
}
_MEASURED: Mapping[str, Callable[[Task], Measure]] = {
    "wheel_radius": lambda task: radius((*task.left, *task.right)),
    "traction_radius": lambda task: radius(task.traction),
    "omni_radius": lambda task: radius(task.joints),
    "wheel_separation": lambda task: across(task.left, task.right),
    "wheelbase": lambda task: along(task.traction, task.steering),
    "tricycle_wheelbase": _tricycle,
    "traction_track": lambda task: across(task.traction[:1], task.traction[1:2]),
    "steering_track": lambda task: _between(task.steering),
    "robot_radius": lambda task: from_centre(task.joints)[0],
    "wheel_offset": lambda task: from_centre(task.joints)[1],
    "mecanum_sum": _mecanum,
}
_STAND_INS = {
    "wheel_separation": 0.5,
    "wheelbase": 0.5,
    "traction_track": 0.5,
    "steering_track": 0.5,
    "wheel_offset": 0.0,
}


def _between(pair: Sequence[JointFacts]) -> Measure:
    """The distance, across the robot, between two joints with vertical axes."""
    if len(pair) < 2 or pair[0].at is None or pair[1].at is None:  # noqa: PLR2004
        return Measure(None, "")
    gap = abs(pair[0].at[1] - pair[1].at[1])
    return Measure(round(gap, 5), "measured between the joints") if gap else Measure(None, "")


def _of_drive(name: str) -> Callable[[Task], Answer | Left]:
    """A limit of a drive: `max_...`, `min_...`, or `true_if_...` if there is one."""

    def found(task: Task) -> Answer | Left:
        sideways = task.kind == "mecanum"
        limit = drive_limit(name.rpartition("_")[2], task.left, task.right, sideways=sideways)
        if limit is None:
            return LEFT_OUT
        if name.startswith("true_if"):
            return Answer(value=True)
        return Answer(-limit.value if name.startswith("min") else limit.value, limit.how)

    return found


_OTHERS: Mapping[str, Callable[[Task], Answer | Left]] = {
    "joints": lambda task: _names(task.joints),
    "goal_time": lambda task: Answer(2.0 if closes_loop(task) else 1.0),
    "interface": lambda task: Answer(task.interface),
    "interfaces": lambda task: Answer([*task.interfaces]),
    "states": lambda task: Answer([*task.states]),
    "commanded": lambda task: _names(task.joints, task.below),
    "below": lambda task: _names(task.joints, task.below) if task.below else LEFT_OUT,
    "open_loop": lambda task: LEFT_OUT if task.states else Answer(value=True),
    "angles_first": lambda task: Answer("position" in task.states),
    "speeds_first": lambda task: Answer("position" in task.states and "velocity" not in task.states),
    "full_states": _full_states,
    "batteries": _batteries,
    "with_covariance": lambda task: Answer(value=True) if _offers(task, "latitude_covariance") else LEFT_OUT,
    "measured": lambda task: Answer([f"{joint.name}/{task.interface}" for joint in task.joints[:1]]),
    "filtered": lambda task: Answer([f"{joint.name}/filtered_{task.interface}" for joint in task.joints[:1]]),
    "left": lambda task: _names(task.left, task.below),
    "right": lambda task: _names(task.right, task.below),
    "traction": lambda task: _names(task.traction[::-1], task.below),
    "steering": lambda task: _names(task.steering[::-1], task.below),
    "one_traction": lambda task: _one(task.traction[0], task),
    "one_steering": lambda task: _one(task.steering[0], task),
    "front_left": lambda task: _one(task.left[0], task),
    "rear_left": lambda task: _one(task.left[-1], task),
    "front_right": lambda task: _one(task.right[0], task),
    "rear_right": lambda task: _one(task.right[-1], task),
    "front_traction": lambda task: _half(task.traction, first=True),
    "rear_traction": lambda task: _half(task.traction, first=False),
    "front_steering": lambda task: _half(task.steering, first=True),
    "rear_steering": lambda task: _half(task.steering, first=False),
    "base_frame": lambda task: Answer(task.robot.root or "base_link"),
    "tip": _tip,
    "sensor": _sensor,
    "frame": _frame,
    **{name: _of_drive(name) for name in DRIVE_LIMITS},
}
NAMES = frozenset({*_OF_JOINT, *_MEASURED, *_OTHERS})
