"""The drives of all joints in MuJoCo, reckoned at once: one by one they would take longer than the engine's steps."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from urdfctl.smoke.engines.engine import STEP, Motor

STIFF = 60.0
"""The rate at which a driven joint approaches its target position, in 1/s."""
GRIP = 10.0
"""The stiffness of holding a velocity: a free joint nearly reaches it in one step."""
POSITION: Final = 1
VELOCITY: Final = 2
EFFORT: Final = 3


class Drives:
    """What drives each joint of a model: nothing at first, and from a command on what that says.

    A way is the number of a joint among the velocities of the model, a place the one among its positions.
    """

    def __init__(self, model: Any, data: Any, places: Mapping[int, int]) -> None:
        import numpy as np

        self._numpy, self._data = np, data
        count = int(model.nv)
        self._places = np.array([places.get(way, 0) for way in range(count)], dtype=int)
        # the rows of the lower half of the mass matrix, each of which ends on the diagonal
        self._diagonal = model.M_rowadr + model.M_rownnz - 1
        self._damping = model.dof_damping.copy()
        # the engine's own arrays: asking it for them takes as long as reckoning with them
        self._at, self._moving, self._weights, self._masses = data.qpos, data.qvel, data.qfrc_bias, data.M
        self._pushes, self._dampings = data.qfrc_applied, model.dof_damping
        self._kinds = np.zeros(count, dtype=int)
        self._values, self._most_efforts, self._fastest, self._efforts = (np.zeros(count) for _ in range(4))
        self._friction = self._resistance = self._tops = np.zeros(count)
        self._has_motors = False
        self._sort()

    def _sort(self) -> None:
        """Keep which joints are driven, and how."""
        self._is_pushed, self._is_placed = self._kinds == EFFORT, self._kinds == POSITION
        self._is_driven, self._slowest = self._kinds > 0, -self._fastest
        self._has_servos = bool((self._is_driven & ~self._is_pushed).any())
        if self._has_motors:
            self._tops = self._top_speeds()

    def add_motors(self, motors: Mapping[int, Motor]) -> None:
        """Let the motors of some joints, by way, work against friction and damping."""
        ways = range(len(self._kinds))
        none = Motor(0.0, 0.0)
        self._friction = self._numpy.array([motors.get(way, none).friction for way in ways])
        self._resistance = self._numpy.array([motors.get(way, none).damping for way in ways])
        self._has_motors = bool(motors)
        self._sort()

    def command(self, way: int, kind: int, value: float, effort: float, velocity: float) -> None:
        """Drive a joint, with a maximum effort and velocity, until the next command."""
        self._values[way] = value
        if self._kinds[way] != kind or self._fastest[way] != velocity or self._most_efforts[way] != effort:
            self._kinds[way], self._fastest[way], self._most_efforts[way] = kind, velocity, effort
            self._sort()

    def effort(self, way: int) -> float:
        """Return the effort of a joint's motor in the last step, in N m or N."""
        return float(self._efforts[way])

    def apply(self) -> None:
        """Give the engine the effort and the damping of each driven joint for the next step."""
        np, is_pushed = self._numpy, self._is_pushed
        if not self._has_servos:
            self._efforts = np.where(is_pushed, self._values, 0.0)
            np.copyto(self._pushes, self._values, where=is_pushed)
            np.copyto(self._dampings, self._damping, where=is_pushed)
            return
        push, damping = self._servos()
        np.copyto(push, self._values, where=is_pushed)
        # what a servo damps is its motor's work too; a pushed joint's damping is its own
        self._efforts = np.where(is_pushed, push, push - damping * self._moving)
        np.copyto(damping, self._damping, where=is_pushed)
        np.copyto(self._pushes, push, where=self._is_driven)
        np.copyto(self._dampings, damping, where=self._is_driven)

    def _servos(self) -> tuple[Any, Any]:
        """The effort and the damping that drive each joint at a velocity; the engine keeps damping stable."""
        np, velocity, weight = self._numpy, self._moving, self._weights
        approach = np.minimum(self._fastest, STIFF * (self._values - self._at[self._places]))
        wanted = np.where(self._is_placed, np.maximum(self._slowest, approach), self._values)
        effort = self._most_efforts
        if self._has_motors:
            wanted, effort = self._against_resistance(wanted, velocity)
        away = np.abs(wanted - velocity)
        left = effort - np.abs(weight)
        grip = self._masses[self._diagonal] / STEP * GRIP
        np.minimum(grip, np.divide(left, away, out=np.full(len(away), np.inf), where=away > 0), out=grip)
        is_weak = left <= 0
        push = np.where(is_weak, np.copysign(effort, weight), grip * wanted + weight)
        return push, np.where(is_weak, 0.0, grip)

    def _against_resistance(self, wanted: Any, velocity: Any) -> tuple[Any, Any]:
        """The velocities that motors reach, and the efforts that their friction and damping leave; see `Motor`."""
        np, effort, top = self._numpy, self._most_efforts, self._tops
        wanted = np.maximum(-top, np.minimum(top, wanted))
        taken = self._friction + self._resistance * np.abs(velocity)
        brakes = (wanted - velocity) * velocity < 0
        return wanted, np.where(brakes, effort + taken, np.maximum(0.0, effort - taken))

    def _top_speeds(self) -> Any:
        """The velocity at which the damping of each joint takes all that its friction leaves of its motor's effort."""
        np = self._numpy
        left = np.maximum(0.0, self._most_efforts - self._friction)
        return np.divide(left, self._resistance, out=np.where(left > 0, np.inf, 0.0), where=self._resistance > 0)
