"""Steps from one ROS 2 distro to a later one."""

from __future__ import annotations

from urdfctl.migrate.distro.old_names import OLD_NAMES
from urdfctl.migrate.step import Step

STEPS: tuple[Step, ...] = (OLD_NAMES,)
