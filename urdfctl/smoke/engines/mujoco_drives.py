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

        self._numpy, self._model, self._data = np, model, data
        count = int(model.nv)
        self._places = np.array([places.get(way, 0) for way in range(count)], dtype=int)
        # the rows of the lower half of the mass matrix, each of which ends on the diagonal
        self._diagonal = model.M_rowadr + model.M_rownnz - 1
        self._damping = model.dof_damping.copy()
        self._kinds = np.zeros(count, dtype=int)
        self._values, self._most_efforts, self._fastest, self._efforts = (np.zeros(count) for _ in range(4))
        self._friction = self._resistance = np.zeros(count)
        self._has_motors = False

    def add_motors(self, motors: Mapping[int, Motor]) -> None:
        """Let the motors of some joints, by way, work against friction and damping."""
        ways = range(len(self._kinds))
        none = Motor(0.0, 0.0)
        self._friction = self._numpy.array([motors.get(way, none).friction for way in ways])
        self._resistance = self._numpy.array([motors.get(way, none).damping for way in ways])
        self._has_motors = bool(motors)

    def command(self, way: int, kind: int, value: float, effort: float, velocity: float) -> None:
        """Drive a joint, with a maximum effort and velocity, until the next command."""
        self._kinds[way], self._values[way] = kind, value
        self._most_efforts[way], self._fastest[way] = effort, velocity

    def effort(self, way: int) -> float:
        """Return the effort of a joint's motor in the last step, in N m or N."""
        return float(self._efforts[way])

    def apply(self) -> None:
        """Give the engine the effort and the damping of each driven joint for the next step."""
        np, data = self._numpy, self._data
        push, damping = self._servos()
        is_pushed = self._kinds == EFFORT
        np.copyto(push, self._values, where=is_pushed)
        # what a servo damps is its motor's work too; a pushed joint's damping is its own
        self._efforts = np.where(is_pushed, push, push - damping * data.qvel)
        np.copyto(damping, self._damping, where=is_pushed)
        is_driven = self._kinds > 0
        np.copyto(data.qfrc_applied, push, where=is_driven)
        np.copyto(self._model.dof_damping, damping, where=is_driven)

    def _servos(self) -> tuple[Any, Any]:
        """The effort and the damping that drive each joint at a velocity; the engine keeps damping stable."""
        np, data = self._numpy, self._data
        velocity, weight = data.qvel, data.qfrc_bias
        approach = np.minimum(self._fastest, STIFF * (self._values - data.qpos[self._places]))
        wanted = np.where(self._kinds == POSITION, np.maximum(-self._fastest, approach), self._values)
        effort = self._most_efforts
        if self._has_motors:
            wanted, effort = self._against_resistance(wanted, velocity)
        away = np.abs(wanted - velocity)
        left = effort - np.abs(weight)
        grip = data.M[self._diagonal] / STEP * GRIP
        np.minimum(grip, np.divide(left, away, out=np.full(len(away), np.inf), where=away > 0), out=grip)
        is_weak = left <= 0
        push = np.where(is_weak, np.copysign(effort, weight), grip * wanted + weight)
        return push, np.where(is_weak, 0.0, grip)

    def _against_resistance(self, wanted: Any, velocity: Any) -> tuple[Any, Any]:
        """The velocities that motors reach, and the efforts that their friction and damping leave; see `Motor`."""
        np, effort = self._numpy, self._most_efforts
        left = np.maximum(0.0, effort - self._friction)
        free = np.where(left > 0, np.inf, 0.0)
        top = np.divide(left, self._resistance, out=free, where=self._resistance > 0)
        wanted = np.maximum(-top, np.minimum(top, wanted))
        taken = self._friction + self._resistance * np.abs(velocity)
        brakes = (wanted - velocity) * velocity < 0
        return wanted, np.where(brakes, effort + taken, np.maximum(0.0, effort - taken))
