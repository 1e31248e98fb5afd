"""Steps from ROS 1 to ROS 2."""

from __future__ import annotations

from urdfctl.migrate.step import Step

STEPS: tuple[Step, ...] = ()
