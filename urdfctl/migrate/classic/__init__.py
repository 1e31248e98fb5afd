"""Steps from Gazebo Classic to gz."""

from __future__ import annotations

from urdfctl.migrate.step import Step

STEPS: tuple[Step, ...] = ()
