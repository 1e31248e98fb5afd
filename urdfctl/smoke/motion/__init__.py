"""The robot in a physics engine: each controller moves its joints, and motion and command are compared."""

from __future__ import annotations

from urdfctl.smoke.motion.engine_agreement import compared
from urdfctl.smoke.motion.engine_workers import EngineWorkers
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult

__all__ = ["EngineWorkers", "MotionPlan", "SimulationResult", "compared"]
