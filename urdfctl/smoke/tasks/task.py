"""The task of each controller: the joints and wheels that it moves, and how."""

from __future__ import annotations

import math
from enum import Enum
from typing import Any

from urdfctl.startup.records import NamedTuple

FREE = 1e9
"""The limit of a controller that sets none."""


class MotionFamily(Enum):
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


class PidGains(NamedTuple):
    """The gains of a PID loop.

    clamp: limits the integral part, in the unit of the command.
    feed: the fraction of the target velocity that is added to the command.
    prefix: the beginning of the names of their parameters.
    """

    p: float = 0.0
    i: float = 0.0
    d: float = 0.0
    clamp: float = math.inf
    feed: float = 0.0
    prefix: str = ""


class Drive(NamedTuple):
    """The wheel joints of a mobile base, with measures in m as the controller's parameters give them.

    A measure of 0 means that the controller measures the robot.

    left, right, driven, steered: the joints, as far as the controller tells the sides apart.
    left_scale, right_scale: multiply the radius on one side.
    track, steering_track: the distances between driven and between steered wheels.
    roles: the wheels for which the controller has names, each with 1 for front or -1 for rear, and 1 for left or -1 for
        right.
    reach: half their wheelbase plus half their track.
    angles: the directions from the centre to the wheels of an omnidirectional base, in rad.
    arm: the distance of these from the centre.
    speed, turning, acceleration: the controller's own limits, in m/s, rad/s and m/s².
    is_inferred: whether no controller knows the base: velocity controllers turn the wheels.
    is_folded: whether the controller multiplies the separation by 0.
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
    is_inferred: bool = False
    is_folded: bool = False

    def radius_of(self, name: str) -> float:
        """Return the radius that the controller uses for a wheel, in m; less than 0 if it turns the other way round."""
        scale = self.left_scale if name in self.left else self.right_scale if name in self.right else 1.0
        return self.radius * scale

    @property
    def wheels(self) -> tuple[str, ...]:
        """The joints of the driven wheels."""
        return (*self.left, *self.right, *self.driven)

    @property
    def is_skidding(self) -> bool:
        """Whether a base turns by letting wheels slip: it has more than two, and none is steered."""
        return len(self.wheels) > 2 and not self.steered  # noqa: PLR2004


def _drive_from(given: Any) -> Drive | None:
    fields: Any = [_tuple(field) for field in given or ()]
    return Drive(*fields) if given else None


def _tuple(value: Any) -> Any:
    return tuple(map(_tuple, value)) if isinstance(value, list) else value


class ControllerTask(NamedTuple):
    """The joints and wheels that one controller should move.

    controller: its name.
    family: the way it moves them.
    joints: their names.
    interface: the command interface of its joints, with its name in ROS 2.
    gains: those of each joint, if it closes loops.
    drive: the wheels of a base that engines simulate.
    why: the reason why the controller is not simulated.
    rolling: the wheels of a base on rollers, which engines do not model.
    through: the controllers that it commands, through which it moves the joints.
    left_out: what of the controller is not simulated, by name, with the reason.
    """

    controller: str
    family: MotionFamily
    joints: tuple[str, ...] = ()
    interface: str = ""
    gains: tuple[PidGains, ...] = ()
    drive: Drive | None = None
    why: str = ""
    rolling: Drive | None = None
    through: tuple[str, ...] = ()
    left_out: tuple[tuple[str, str], ...] = ()

    @property
    def base(self) -> Drive | None:
        """The wheels of a mobile base, whether they are simulated or not."""
        return self.drive or self.rolling

    @property
    def driven_joints(self) -> tuple[str, ...]:
        """The joints of the driven wheels of a mobile base."""
        return self.base.wheels if self.base else ()

    @property
    def is_loop(self) -> bool:
        """Whether the controller closes a control loop by commanding efforts."""
        closed = self.family in (MotionFamily.POSITION_PID, MotionFamily.VELOCITY_PID, MotionFamily.TRAJECTORY)
        return closed and self.interface == "effort"

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> ControllerTask:
        """Return the task that plain data holds."""
        gains = tuple(PidGains(*gains) for gains in data["gains"])
        drives = {name: _drive_from(data[name]) for name in ("drive", "rolling")}
        lists = {name: _tuple(data[name]) for name in ("joints", "through", "left_out")}
        return cls(**{**data, **drives, **lists, "family": MotionFamily[data["family"]], "gains": gains})

    def to_json(self) -> dict[str, Any]:
        """Return the task as plain data."""
        return {**self._asdict(), "family": self.family.name}
