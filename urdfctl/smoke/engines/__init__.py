"""The physics engines, all behind one small interface, and which of them are installed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec
from typing import Protocol

from urdfctl.startup.records import NamedTuple

STEP = 0.001
"""The duration of one simulation step, in s."""
SLIDES, GRIPS = 0.1, 1.0
"""The friction of parts that slide on the ground, like casters, and of wheels."""
_MODULES = {"pybullet": "bullet", "mujoco": "mujoco_engine"}
NAMES = tuple(_MODULES)


class Refused(Exception):
    """An engine rejects a robot; the text quotes the engine."""


class Setup(NamedTuple):
    """The input of an engine.

    `urdf` is the text of the URDF. `root` is its root link, and `fixed` whether that is fixed to the world. `start`
    holds the movable joints with their positions at spawn. `weightless` are the links without gravity, and `wheels` the
    links of wheels.
    `gui` shows a window.
    """

    urdf: str
    root: str
    fixed: bool
    start: Mapping[str, float]
    weightless: Sequence[str] = ()
    wheels: Sequence[str] = ()
    gui: bool = False


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
