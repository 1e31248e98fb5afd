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


class Family(Enum):
    """The way a controller moves its joints."""

    NOTHING = "commands nothing"
    FORWARD = "forwards its command to the joints"
    POSITION_PID = "holds positions with PID loops"
    VELOCITY_PID = "holds velocities with PID loops"
    TRAJECTORY = "follows a trajectory, with PID loops unless it commands positions"
    DIFFERENTIAL = "drives wheels on the left and right"
    STEERED = "drives wheels and steers wheels"
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
    """The wheel joints of a mobile base, with radius, separation and wheelbase in m as the controller's parameters give
    them (0: the controller measures the robot)."""

    left: tuple[str, ...] = ()
    right: tuple[str, ...] = ()
    driven: tuple[str, ...] = ()
    steered: tuple[str, ...] = ()
    radius: float = 0.0
    separation: float = 0.0
    wheelbase: float = 0.0
    base: str = ""


def _drive_from(given: Any) -> Drive | None:
    fields: Any = [tuple(field) if isinstance(field, list) else field for field in given or ()]
    return Drive(*fields) if given else None


class Task(NamedTuple):
    """The joints and wheels that one controller should move.

    `interface` is the command interface of its joints, with its name in ROS 2. `why` is the reason why the controller
    is not simulated. `rolling` holds the wheels of a drive that is not simulated, but whose wheels must turn forward.
    """

    controller: str
    family: Family
    joints: tuple[str, ...] = ()
    interface: str = ""
    gains: tuple[Gains, ...] = ()
    drive: Drive | None = None
    why: str = ""
    rolling: Drive | None = None

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
_ROLLING = ("MecanumDriveController",)
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
        return Task(name, family, joints, interface, drive=_drive(family, values))
    family = _loop(family, class_name, kind.type, interface, values)
    gains = tuple(_gains(configured.values, joint) for joint in joints)
    return Task(name, family, joints, interface, gains)


def _rolling(configured: Configured, class_name: str) -> Task:
    """A controller of wheels with rollers: only the direction in which its wheels turn can be checked."""
    joints = tuple(dict.fromkeys(claim.component for claim in configured.claims.command))
    drive = Drive(driven=joints, base=_text(configured.values.get("base_frame_id")))
    why = f"for a {class_name}, only the direction of its wheels is checked"
    return Task(configured.name, Family.STRUCTURAL, joints, "velocity", why=why, rolling=drive)


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


def _drive(family: Family, values: Mapping[str, object]) -> Drive:
    if family is Family.DIFFERENTIAL:
        scale = _float(values.get("wheel_separation_multiplier")) or 1.0
        return Drive(
            _names(values, "left_wheel_names", "left_wheel"),
            _names(values, "right_wheel_names", "right_wheel"),
            radius=_float(values.get("wheel_radius")),
            separation=_float(values.get("wheel_separation")) * scale,
            base=_text(values.get("base_frame_id")),
        )
    front = bool(values.get("front_steering", True))
    driven = _names(
        values, "traction_joints_names", "traction_joint_name", "rear_wheels_names" if front else "front_wheels_names"
    )
    steered = _names(
        values, "steering_joints_names", "steering_joint_name", "front_wheels_names" if front else "rear_wheels_names"
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
        radius=next((_float(values.get(name)) for name in radius if _float(values.get(name))), 0.0),
        wheelbase=_float(values.get("wheelbase")),
        base=_text(values.get("base_frame_id")),
    )


def _names(values: Mapping[str, object], *names: str) -> tuple[str, ...]:
    lists = (elements(values.get(name)) for name in names)
    return next((tuple(map(str, joints)) for joints in lists if joints), ())


def _text(value: object) -> str:
    return value if isinstance(value, str) and is_known(value) else ""


def _float(value: object) -> float:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else 0.0
