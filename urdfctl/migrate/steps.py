"""All steps, in the order in which they are applied: robots, the packages around them, then distro to distro."""

from __future__ import annotations

from urdfctl.migrate import classic, distro, ros1
from urdfctl.migrate.step import Step

STEPS: tuple[Step, ...] = (
    *ros1.ROBOT_STEPS,
    *classic.ROBOT_STEPS,
    *ros1.PACKAGE_STEPS,
    *classic.PACKAGE_STEPS,
    *distro.STEPS,
)
