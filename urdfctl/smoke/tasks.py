"""The task of each controller, from its claims in the catalogue: joints, gains and wheels."""

from __future__ import annotations

import math
from collections.abc import Mapping
from enum import Enum

from urdfctl.catalog.values import elements, is_known
from urdfctl.control.session import Configured
from urdfctl.control.values import Values
from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple

FREE = 1e9
"""The limit of a controller that sets none."""


class Family(Enum):
    """The way a controller moves its joints."""

    NOTHING = "commands nothing"
    FORWARD = "forwards its command to the joints"
    POSITION_PID = "holds positions with PID loops"
    VELOCITY_PID = "holds velocities with PID loops"
    TRAJECTORY = "follows a trajectory, with PID loops unless it commands positions"
    DIFFERENTIAL = "drives wheels on the left and right"
    STEERED = "drives wheels and steers wheels"
    ROLLERS = "turns wheels with rollers"
    STRUCTURAL = "is not simulated"


class Gains(NamedTuple):
    """The gains of a PID loop.

    `clamp` limits the integral part, in the unit of the command. `feed` is the fraction of the target velocity that is
    added to the command.
    """

    p: float = 0.0
    i: float = 0.0
    d: float = 0.0
    clamp: float = math.inf
    feed: float = 0.0


class Drive(NamedTuple):
    """The wheel joints of a mobile base, with measures in m as the controller's parameters give them.

    A measure of 0 means that the controller measures the robot. `left_scale` and `right_scale` multiply the radius on
    one side. `track` and `steering_track` are the distances between driven and between steered wheels. `roles` holds
    the wheels for which the controller has names, each with 1 for front or -1 for rear, and 1 for left or -1 for right;
    `reach` is half their wheelbase plus half their track. `angles` holds the directions from the centre to the wheels
    of an omnidirectional base, in rad, and `arm` their distance. `speed`, `turning` and `acceleration` are the
    controller's own limits, in m/s, rad/s and m/s². `plain` drives have no controller that knows the base: velocity
    controllers turn the wheels.
    """

    left: tuple[str, ...] = ()
    right: tuple[str, ...] = ()
    driven: tuple[str, ...] = ()
    steered: tuple[str, ...] = ()
    radius: float = 0.0
    separation: float = 0.0
    wheelbase: float = 0.0
    base: str = ""
    left_scale: float = 1.0
    right_scale: float = 1.0
    track: float = 0.0
    steering_track: float = 0.0
    roles: tuple[tuple[str, int, int], ...] = ()
    reach: float = 0.0
    angles: tuple[float, ...] = ()
    arm: float = 0.0
    speed: float = FREE
    turning: float = FREE
    acceleration: float = FREE
    plain: bool = False

    def radius_of(self, name: str) -> float:
        """Return the radius that the controller uses for a wheel, in m; less than 0 if it turns the other way round."""
        scale = self.left_scale if name in self.left else self.right_scale if name in self.right else 1.0
        return self.radius * scale

    @property
    def wheels(self) -> tuple[str, ...]:
        """The joints of the driven wheels."""
        return (*self.left, *self.right, *self.driven)


def _drive_from(given: Any) -> Drive | None:
    fields: Any = [_tuple(field) for field in given or ()]
    return Drive(*fields) if given else None


def _tuple(value: Any) -> Any:
    return tuple(map(_tuple, value)) if isinstance(value, list) else value


class Task(NamedTuple):
    """The joints and wheels that one controller should move.

    `interface` is the command interface of its joints, with its name in ROS 2. `why` is the reason why the controller
    is not simulated. `rolling` holds the wheels of a drive on rollers, which engines do not model.
    """

    controller: str
    family: Family
    joints: tuple[str, ...] = ()
    interface: str = ""
    gains: tuple[Gains, ...] = ()
    drive: Drive | None = None
    why: str = ""
    rolling: Drive | None = None

    @property
    def base(self) -> Drive | None:
        """The wheels of a mobile base, whether they are simulated or not."""
        return self.drive or self.rolling

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Task:
        """Return the task that plain data holds."""
        gains = tuple(Gains(*gains) for gains in data["gains"])
        drives = {name: _drive_from(data[name]) for name in ("drive", "rolling")}
        family, joints = Family[data["family"]], tuple(data["joints"])
        return cls(**{**data, **drives, "family": family, "gains": gains, "joints": joints})

    def to_json(self) -> dict[str, Any]:
        """Return the task as plain data."""
        return {**self._asdict(), "family": self.family.name}


def is_skidding(drive: Drive) -> bool:
    """Return whether a base turns by letting wheels slip: it has more than two, and none is steered."""
    return len(drive.wheels) > 2 and not drive.steered  # noqa: PLR2004


def driven_of(task: Task) -> tuple[str, ...]:
    """Return the joints of the driven wheels of a mobile base."""
    return task.base.wheels if task.base else ()


def is_loop(task: Task) -> bool:
    """Return whether a controller closes a control loop by commanding efforts."""
    closed = task.family in (Family.POSITION_PID, Family.VELOCITY_PID, Family.TRAJECTORY)
    return closed and task.interface == "effort"


_BY_CLASS = {
    "ForwardCommandController": Family.FORWARD,
    "MultiInterfaceForwardCommandController": Family.FORWARD,
    "JointGroupPositionController": Family.FORWARD,
    "JointGroupVelocityController": Family.FORWARD,
    "JointGroupEffortController": Family.FORWARD,
    "JointPositionController": Family.FORWARD,
    "JointVelocityController": Family.FORWARD,
    "JointEffortController": Family.FORWARD,
    "JointTrajectoryController": Family.TRAJECTORY,
    "ScaledJointTrajectoryController": Family.TRAJECTORY,
    "GripperActionController": Family.TRAJECTORY,
    "PidController": Family.POSITION_PID,
    "DiffDriveController": Family.DIFFERENTIAL,
    "AckermannSteeringController": Family.STEERED,
    "BicycleSteeringController": Family.STEERED,
    "TricycleSteeringController": Family.STEERED,
    "TricycleController": Family.STEERED,
}
"""The way each class moves its joints; other classes are not simulated."""
_ROLLING = ("MecanumDriveController", "OmniWheelDriveController")
_ROLES = (("front_left", 1, 1), ("front_right", 1, -1), ("rear_left", -1, 1), ("rear_right", -1, -1))
_COMMANDED = {
    "PositionJointInterface": "position",
    "VelocityJointInterface": "velocity",
    "EffortJointInterface": "effort",
}
_QUANTITIES = ("position", "velocity", "effort")


def task_of(configured: Configured) -> Task:
    """Return what a controller should move."""
    name, kind = configured.name, configured.type
    if kind is None or kind.claims is None:
        return _not_simulated(name, "its claims are unknown")
    claims = configured.claims.command
    if not claims:
        broadcasts = kind.broadcaster or not kind.claims.command
        return Task(name, Family.NOTHING) if broadcasts else _not_simulated(name, "it claims no joint")
    class_name = kind.type.rpartition("/")[2]
    family = _BY_CLASS.get(class_name)
    if class_name in _ROLLING:
        return _rolling(configured, class_name)
    if family is None:
        return _not_simulated(name, f"urdfctl cannot simulate a {class_name}")
    if not configured.claims.complete:
        return _not_simulated(name, "not all of its parameters are known")
    interfaces = [_quantity(claim.interface) for claim in claims]
    joints = tuple(dict.fromkeys(claim.component for claim in claims))
    if any("/" in joint for joint in joints) or not all(interface in _QUANTITIES for interface in interfaces):
        return _not_simulated(name, "it commands other controllers or devices, not joints")
    values = Values(kind, configured.values)
    interface = interfaces[0]
    if family in (Family.DIFFERENTIAL, Family.STEERED):
        return _of_base(Task(name, family, joints, interface, drive=_drive(family, values)))
    family = _loop(family, class_name, kind.type, interface, values)
    gains = tuple(_gains(configured.values, joint) for joint in joints)
    return Task(name, family, joints, interface, gains)


def _rolling(configured: Configured, class_name: str) -> Task:
    """A controller of wheels with rollers: what they make of the base is computed, not simulated."""
    joints = tuple(dict.fromkeys(claim.component for claim in configured.claims.command))
    kind = configured.type
    values = Values(kind, configured.values) if kind else configured.values
    base = _text(values.get("base_frame_id"))
    if class_name.startswith("Omni"):
        count, offset = max(1, len(joints)), _float(values.get("wheel_offset"))
        angles = tuple(offset + 2 * math.pi * n / count for n in range(count))
        radius, arm = _float(values.get("wheel_radius")), _float(values.get("robot_radius"))
        drive = Drive(driven=joints, base=base, radius=radius, arm=arm, angles=angles)
    else:
        named = [(values.get(f"{role}_wheel_command_joint_name"), ahead, aside) for role, ahead, aside in _ROLES]
        drive = Drive(
            driven=joints,
            base=base,
            radius=_float(values.get("kinematics.wheels_radius")),
            reach=_float(values.get("kinematics.sum_of_robot_center_projection_on_X_Y_axis")),
            roles=tuple((_text(name), ahead, aside) for name, ahead, aside in named if _text(name)),
        )
    offset = any(_float(values.get(f"kinematics.base_frame_offset.{name}")) for name in ("x", "y", "theta"))
    known = drive.radius and (drive.arm or drive.reach) and len(drive.roles or drive.angles) == len(joints)
    why = "its base_frame_offset is not modelled" if offset else "" if known else "its measures are unknown"
    family = Family.STRUCTURAL if why else Family.ROLLERS
    return Task(configured.name, family, joints, "velocity", why=why, rolling=drive)


def _not_simulated(name: str, why: str) -> Task:
    return Task(name, Family.STRUCTURAL, why=why)


def _quantity(interface: str) -> str:
    return _COMMANDED.get(interface.rpartition("/")[2], interface)


def _loop(family: Family, class_name: str, type_name: str, interface: str, values: Mapping[str, object]) -> Family:
    """The family of a controller: it closes a loop if it holds another quantity than the one that it commands."""
    if class_name == "PidController":
        held = elements(values.get("reference_and_state_interfaces"))
        return Family.VELOCITY_PID if held[:1] == ("velocity",) else Family.POSITION_PID
    if family is Family.FORWARD and not type_name.startswith("forward_command"):
        if "Position" in class_name and interface != "position":
            return Family.POSITION_PID
        if "Velocity" in class_name and interface != "velocity":
            return Family.VELOCITY_PID
    return family


def _gains(given: Mapping[str, object], joint: str) -> Gains:
    """The gains of a joint, from any place where controllers read them: per joint, or for their only joint."""
    feeds = (given.get(f"gains.{joint}.{name}") for name in ("ff_velocity_scale", "feedforward_gain"))
    feed = next((_float(value) for value in (*feeds, given.get(f"velocity_ff.{joint}")) if _float(value)), 0.0)
    for place in (f"gains.{joint}.", f"{joint}.pid.", "pid.", "gains.", ""):
        if any(isinstance(given.get(f"{place}{name}"), int | float) for name in "pid"):
            p, i, d = (_float(given.get(f"{place}{name}")) for name in "pid")
            clamps = (given.get(f"{place}{name}") for name in ("i_clamp", "i_clamp_max"))
            clamp = next((abs(_float(value)) for value in clamps if _float(value)), math.inf)
            return Gains(p, i, d, clamp, feed)
    return Gains(feed=feed)


def _of_base(task: Task) -> Task:
    if task.base and task.base.wheels:
        return task
    return _not_simulated(task.controller, "its parameters name no wheels that it drives")


def _drive(family: Family, values: Mapping[str, object]) -> Drive:
    if family is Family.DIFFERENTIAL:
        scale = _float(values.get("wheel_separation_multiplier")) or 1.0
        return Drive(
            _names(values, "left_wheel_names", "left_wheel"),
            _names(values, "right_wheel_names", "right_wheel"),
            radius=_float(values.get("wheel_radius")),
            separation=_float(values.get("wheel_separation")) * scale,
            base=_text(values.get("base_frame_id")),
            left_scale=_scale(values, "left_wheel_radius_multiplier"),
            right_scale=_scale(values, "right_wheel_radius_multiplier"),
            speed=_limit(values, "linear.x", "velocity"),
            turning=_limit(values, "angular.z", "velocity"),
            acceleration=_limit(values, "linear.x", "acceleration"),
        )
    front = bool(values.get("front_steering", True))
    driven = _names(
        values,
        "traction_joints_names",
        "traction_joint_name",
        "rear_wheels_names" if front else "front_wheels_names",
        "rear_wheel",
    )
    steered = _names(
        values,
        "steering_joints_names",
        "steering_joint_name",
        "front_wheels_names" if front else "rear_wheels_names",
        "front_steer",
    )
    radius = (
        "traction_wheels_radius",
        "traction_wheel_radius",
        "rear_wheels_radius" if front else "front_wheels_radius",
        "wheel_radius",
    )
    return Drive(
        driven=driven,
        steered=steered,
        radius=_first(values, *radius),
        wheelbase=_first(values, "wheelbase", "wheel_separation_h"),
        base=_text(values.get("base_frame_id")),
        track=_first(
            values, "traction_track_width", "wheel_track", "rear_wheel_track" if front else "front_wheel_track"
        ),
        steering_track=_first(values, "steering_track_width", "front_wheel_track" if front else "rear_wheel_track"),
        speed=_limit(values, "linear", "velocity"),
    )


def _first(values: Mapping[str, object], *names: str) -> float:
    """The first of some parameters that is not 0."""
    return next((number for name in names if (number := _float(values.get(name)))), 0.0)


def _scale(values: Mapping[str, object], *names: str) -> float:
    return _first(values, *names, "wheel_radius_multiplier") or 1.0


def _limit(values: Mapping[str, object], way: str, quantity: str) -> float:
    """A limit of a controller on its own command; a flag says in older releases whether it is used."""
    if values.get(f"{way}.has_{quantity}_limits") is False:
        return FREE
    limit = abs(_float(values.get(f"{way}.max_{quantity}")))
    return limit if 0 < limit < FREE else FREE


def _names(values: Mapping[str, object], *names: str) -> tuple[str, ...]:
    lists = (elements(values.get(name)) for name in names)
    return next((tuple(map(str, joints)) for joints in lists if joints), ())


def _text(value: object) -> str:
    return value if isinstance(value, str) and is_known(value) else ""


def _float(value: object) -> float:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else 0.0
