"""The interface behind which all physics engines are, and which of them are installed."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec
from typing import Protocol

from urdfctl.errors import UserError
from urdfctl.model.geometry import Vector
from urdfctl.names import did_you_mean
from urdfctl.smoke.robot import friction_of
from urdfctl.startup.records import NamedTuple

STEP = 0.001
"""The duration of one simulation step, in s."""
_MODULES = {"pybullet": "pybullet_engine", "mujoco": "mujoco_engine"}
NAMES = tuple(_MODULES)
CHOICES = ("auto", *NAMES, "both", "none")
"""The names of engines, and what else a user may choose."""


class RobotRejected(Exception):
    """An engine rejects a robot; the text quotes the engine."""


class EngineSetup(NamedTuple):
    """The input of an engine.

    urdf: the text of the URDF.
    root: its root link.
    fixed: whether the root link is fixed to the world.
    start: the movable joints with their positions at spawn.
    weightless: the links without gravity.
    wheels: the links of wheels.
    gui: whether to show a window.
    resist: the friction of joints, in N m or N, and their damping, in N m s/rad or N s/m.
    stiff: the joints that are damped more strongly than a step of the engine bears.
    skidding: the links of wheels that slip sideways when the base turns, with their axes.
    grips: the friction of links for which the description gives one.
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


class BasePose(NamedTuple):
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

    def place(self, joint: str, position: float) -> None:
        """Put a joint at a position, at rest."""
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

    def base_pose(self) -> BasePose:
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


def engines_named(name: str) -> tuple[str, ...]:
    """Return the engines that one of `CHOICES` means. UserError if it means none, or one that is not installed."""
    if name not in CHOICES:
        raise UserError(f"unknown engine '{name}'{did_you_mean(name, CHOICES)}; known are {', '.join(CHOICES)}")
    if name == "none":
        return ()
    available = installed()
    wanted = NAMES if name == "both" else available[:1] if name == "auto" else (name,)
    if not wanted or not set(wanted) <= set(available):
        missing = "no physics engine" if name == "auto" else "not every engine" if name == "both" else f"'{name}'"
        is_there = "is installed" if name in ("auto", "both") else "is not installed"
        raise UserError(
            f"{missing} {is_there}: pip install 'urdfctl[smoke]', or use --engine none to test without moving anything"
        )
    return wanted


def open_engine(name: str, setup: EngineSetup) -> Engine:
    """Return a robot in an engine. Raise RobotRejected if the engine rejects it."""
    engine: Engine = import_module(f"{__package__}.{_MODULES[name]}").open_engine(setup)
    return engine
