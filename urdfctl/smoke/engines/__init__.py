"""The physics engines that move a robot, each behind one small interface, and which of them are installed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec
from typing import Protocol

from urdfctl.record import NamedTuple

STEP = 0.001
"""Seconds of one step of simulation."""
SLIDES, GRIPS = 0.1, 1.0
"""The friction of what slides on the ground, as casters do, and of wheels."""
_MODULES = {"pybullet": "bullet", "mujoco": "mujoco_engine"}
NAMES = tuple(_MODULES)


class Refused(Exception):
    """An engine does not take a robot; the text says why, in its own words."""


class Setup(NamedTuple):
    """What an engine is given: the URDF's text, its root link, whether that is fixed, the robot's movable joints with
    the position of each at spawn, the links that gravity passes over, and those that are wheels; `gui` shows a
    window."""

    urdf: str
    root: str
    fixed: bool
    start: Mapping[str, float]
    weightless: Sequence[str] = ()
    wheels: Sequence[str] = ()
    gui: bool = False


class Standing(NamedTuple):
    """Where the base is, in m, and how it is turned, in rad."""

    x: float
    y: float
    z: float
    roll: float
    pitch: float
    yaw: float


class Engine(Protocol):
    """A robot in a simulation. A command holds until the next one of its joint."""

    def position(self, joint: str) -> float:
        """Where a joint is, in rad or m."""
        raise NotImplementedError

    def velocity(self, joint: str) -> float:
        """How fast it moves, in rad/s or m/s."""
        raise NotImplementedError

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        """Drive a joint to a position, with no more than some effort and velocity."""
        raise NotImplementedError

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        """Turn a joint at a velocity, with no more than some effort."""
        raise NotImplementedError

    def with_effort(self, joint: str, effort: float) -> None:
        """Push a joint, in N m or N."""
        raise NotImplementedError

    def step(self) -> None:
        """Let STEP seconds pass."""
        raise NotImplementedError

    def standing(self) -> Standing:
        """Where the base is."""
        raise NotImplementedError

    def touching(self) -> set[str]:
        """The links that touch the ground."""
        raise NotImplementedError

    def close(self) -> None:
        """End the simulation."""
        raise NotImplementedError


def installed() -> tuple[str, ...]:
    """The engines that are installed, the one to be preferred first."""
    return tuple(name for name in NAMES if find_spec(name) is not None)


def opened(name: str, setup: Setup) -> Engine:
    """A robot in an engine. Refused where it does not take it."""
    made: Engine = import_module(f"{__name__}.{_MODULES[name]}").opened(setup)
    return made
