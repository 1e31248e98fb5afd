"""What is to be moved for each controller, by what the catalogue says that it claims: joints, gains, wheels."""

from __future__ import annotations

import math
from collections.abc import Mapping
from enum import Enum

from urdfctl.catalog.values import elements, is_known
from urdfctl.control.session import Configured
from urdfctl.control.values import Values
from urdfctl.hints import Any
from urdfctl.record import NamedTuple


class Family(Enum):
    """How a controller makes its joints move."""

    NOTHING = "it commands nothing"
    FORWARD = "a command goes to the joints as it is"
    POSITION_PID = "a PID loop holds positions"
    VELOCITY_PID = "a PID loop holds velocities"
    TRAJECTORY = "joints follow a trajectory, through PID loops where they are not commanded by position"
    DIFFERENTIAL = "wheels left and right"
    STEERED = "driven wheels and steered ones"
    STRUCTURAL = "it is not simulated"


class Gains(NamedTuple):
    """Of a PID loop; `clamp` bounds the integral part, in the units of the command, and `feed` is how much of the
    wanted velocity goes to a velocity command as it is."""

    p: float = 0.0
    i: float = 0.0
    d: float = 0.0
    clamp: float = math.inf
    feed: float = 0.0


class Drive(NamedTuple):
    """A mobile base's wheels; radius, separation and wheelbase in m, as the controller is told (0: it looks at the
    robot)."""

    left: tuple[str, ...] = ()
    right: tuple[str, ...] = ()
    driven: tuple[str, ...] = ()
    steered: tuple[str, ...] = ()
    radius: float = 0.0
    separation: float = 0.0
    wheelbase: float = 0.0
    base: str = ""


def _drive_from(given: Any) -> Drive | None:
    parts: Any = [tuple(one) if isinstance(one, list) else one for one in given or ()]
    return Drive(*parts) if given else None


class Task(NamedTuple):
    """What one controller is to move: the joints with the interface of each, in the words of ROS 2; why not, where it
    is not simulated. `rolling` are the wheels of one whose drive is not simulated, and yet must turn forward."""

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
        """From plain data."""
        gains = tuple(Gains(*one) for one in data["gains"])
        drives = {name: _drive_from(data[name]) for name in ("drive", "rolling")}
        family, joints = Family[data["family"]], tuple(data["joints"])
        return cls(**{**data, **drives, "family": family, "gains": gains, "joints": joints})

    def to_json(self) -> dict[str, Any]:
        """As plain data."""
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
"""How the classes move their joints; what is not here is not simulated."""
_ROLLING = ("MecanumDriveController",)
_COMMANDED = {
    "PositionJointInterface": "position",
    "VelocityJointInterface": "velocity",
    "EffortJointInterface": "effort",
}
_QUANTITIES = ("position", "velocity", "effort")


def task_of(one: Configured) -> Task:
    """What a controller is to move."""
    if one.type is None or one.type.claims is None:
        return Task(one.name, Family.STRUCTURAL, why="what it claims is not known")
    claims = one.claims.command
    if not claims:
        broadcasts = one.type.broadcaster or not one.type.claims.command
        return Task(one.name, Family.NOTHING) if broadcasts else _not_simulated(one, "it claims no joint")
    kind = one.type.type.rpartition("/")[2]
    family = _BY_CLASS.get(kind)
    if kind in _ROLLING:
        return _rolling(one, kind)
    if family is None:
        return _not_simulated(one, f"a {kind} is not simulated")
    if not one.claims.complete:
        return _not_simulated(one, "not all of its parameters are known")
    interfaces = [_quantity(claim.interface) for claim in claims]
    joints = tuple(dict.fromkeys(claim.component for claim in claims))
    if any("/" in joint for joint in joints) or not all(one in _QUANTITIES for one in interfaces):
        return _not_simulated(one, "it commands no joints, but other controllers or devices")
    values = Values(one.type, one.values)
    if family in (Family.DIFFERENTIAL, Family.STEERED):
        return Task(one.name, family, joints, interfaces[0], drive=_drive(family, values))
    interface = interfaces[0]
    family = _loop(family, kind, one.type.type, interface, values)
    gains = tuple(_gains(one.values, joint) for joint in joints)
    return Task(one.name, family, joints, interface, gains)


def _rolling(one: Configured, kind: str) -> Task:
    """A controller of wheels with rollers: only the way that they turn can be told."""
    joints = tuple(dict.fromkeys(claim.component for claim in one.claims.command))
    drive = Drive(driven=joints, base=_text(one.values.get("base_frame_id")))
    why = f"of a {kind} only the way that its wheels turn is looked at"
    return Task(one.name, Family.STRUCTURAL, joints, "velocity", why=why, rolling=drive)


def _not_simulated(one: Configured, why: str) -> Task:
    return Task(one.name, Family.STRUCTURAL, why=why)


def _quantity(interface: str) -> str:
    return _COMMANDED.get(interface.rpartition("/")[2], interface)


def _loop(family: Family, kind: str, whole: str, interface: str, values: Mapping[str, object]) -> Family:
    """Whether a controller closes a loop of its own: where it is to hold another quantity than the one it commands."""
    if kind == "PidController":
        held = elements(values.get("reference_and_state_interfaces"))
        return Family.VELOCITY_PID if held[:1] == ("velocity",) else Family.POSITION_PID
    if family is Family.FORWARD and not whole.startswith("forward_command"):
        if "Position" in kind and interface != "position":
            return Family.POSITION_PID
        if "Velocity" in kind and interface != "velocity":
            return Family.VELOCITY_PID
    return family


def _gains(given: Mapping[str, object], joint: str) -> Gains:
    """The gains of a joint, wherever the controller reads them: per joint, or for its only one."""
    feeds = (given.get(f"gains.{joint}.{name}") for name in ("ff_velocity_scale", "feedforward_gain"))
    feed = next((_float(one) for one in (*feeds, given.get(f"velocity_ff.{joint}")) if _float(one)), 0.0)
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
    found = (elements(values.get(name)) for name in names)
    return next((tuple(map(str, one)) for one in found if one), ())


def _text(value: object) -> str:
    return value if isinstance(value, str) and is_known(value) else ""


def _float(value: object) -> float:
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else 0.0
