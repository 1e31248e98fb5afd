"""The physics engines, all behind one small interface, and which of them are installed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec

from urdfctl.model.geometry import Vector
from urdfctl.startup.hints import Protocol
from urdfctl.startup.records import NamedTuple

STEP = 0.001
"""The duration of one simulation step, in s."""
SLIDES, GRIPS = 0.1, 1.0
"""The friction on the ground of parts that slide, like casters, and of wheels, if the description gives none. The
ground has the friction 1, and the lower one of two surfaces counts, as in ODE."""
_MODULES = {"pybullet": "bullet", "mujoco": "mujoco_engine"}
NAMES = tuple(_MODULES)


def friction_of(given: float | None, *, is_wheel: bool) -> float:
    """Return the friction of a part on the ground, given that of the description."""
    return min(GRIPS, given) if given is not None else GRIPS if is_wheel else SLIDES


class Refused(Exception):
    """An engine rejects a robot; the text quotes the engine."""


class Setup(NamedTuple):
    """The input of an engine.

    `urdf` is the text of the URDF. `root` is its root link, and `fixed` whether that is fixed to the world. `start`
    holds the movable joints with their positions at spawn. `weightless` are the links without gravity, and `wheels` the
    links of wheels.
    `resist` holds the friction of joints, in N m or N, and their damping, in N m s/rad or N s/m; the `stiff`
    joints are damped more strongly than a step of the engine bears. `skidding` holds the links of wheels that slip
    sideways when the base turns, with their axes; `grips` the friction of links for which the description gives
    one. `gui` shows a window.
    """

    urdf: str
    root: str
    fixed: bool
    start: Mapping[str, float]
    weightless: Sequence[str] = ()
    wheels: Sequence[str] = ()
    gui: bool = False
    resist: Mapping[str, tuple[float, float]] = {}
    stiff: Sequence[str] = ()
    skidding: Mapping[str, Vector] = {}
    grips: Mapping[str, float] = {}

    def friction_of(self, link: str) -> float:
        """Return the friction of a link on the ground."""
        return friction_of(self.grips.get(link), is_wheel=link in self.wheels)


class Motor(NamedTuple):
    """A motor that drives a joint against its friction and damping.

    At a velocity v the friction F and the damping D take F + D |v| of the motor's effort, or help it to brake. So the
    joint reaches the velocity at which nothing is left, without an explicit damping force, which would be unstable.
    """

    friction: float
    damping: float

    def top(self, effort: float) -> float:
        """Return the greatest velocity that an effort reaches."""
        left = max(0.0, effort - self.friction)
        return left / self.damping if self.damping else math.inf if left else 0.0

    def left(self, effort: float, wanted: float, velocity: float) -> float:
        """Return the effort that is left to change the velocity towards the wanted one."""
        taken = self.friction + self.damping * abs(velocity)
        brakes = (wanted - velocity) * velocity < 0
        return effort + taken if brakes else max(0.0, effort - taken)


FREE_MOTOR = Motor(0.0, 0.0)


class Standing(NamedTuple):
    """The place of the base in m, and its rotation in rad."""

    x: float
    y: float
    z: float
    roll: float
    pitch: float
    yaw: float


class Engine(Protocol):
    """A robot in a simulation. A command holds until the next one for the same joint."""

    def position(self, joint: str) -> float:
        """Return the position of a joint, in rad or m."""
        raise NotImplementedError

    def velocity(self, joint: str) -> float:
        """Return the velocity of a joint, in rad/s or m/s."""
        raise NotImplementedError

    def effort(self, joint: str) -> float:
        """Return the effort with which its motor drove a joint in the last step, in N m or N."""
        raise NotImplementedError

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        """Drive a joint to a position, with a maximum effort and velocity."""
        raise NotImplementedError

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        """Drive a joint at a velocity, with a maximum effort."""
        raise NotImplementedError

    def with_effort(self, joint: str, effort: float) -> None:
        """Push a joint with an effort, in N m or N."""
        raise NotImplementedError

    def step(self) -> None:
        """Simulate STEP seconds."""
        raise NotImplementedError

    def standing(self) -> Standing:
        """Return the place and rotation of the base."""
        raise NotImplementedError

    def touching(self) -> set[str]:
        """Return the links that touch the ground."""
        raise NotImplementedError

    def close(self) -> None:
        """End the simulation."""
        raise NotImplementedError


def installed() -> tuple[str, ...]:
    """Return the engines that are installed, the preferred one first."""
    return tuple(name for name in NAMES if find_spec(name) is not None)


def open_engine(name: str, setup: Setup) -> Engine:
    """Return a robot in an engine. Raise Refused if the engine rejects it."""
    engine: Engine = import_module(f"{__name__}.{_MODULES[name]}").open_engine(setup)
    return engine
