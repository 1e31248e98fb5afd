"""All steps, in the order in which they are applied: ROS 1, Gazebo Classic, then distro to distro."""

from __future__ import annotations

from urdfctl.migrate import classic, distro, ros1
from urdfctl.migrate.step import Step

STEPS: tuple[Step, ...] = (*ros1.STEPS, *classic.STEPS, *distro.STEPS)
