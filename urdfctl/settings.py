"""What the user may set for a run, however it was set."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field

from urdfctl.catalog.distros import ALL, SIMULATORS
from urdfctl.errors import UserError
from urdfctl.suggest import did_you_mean

PASSED_ON = ("ROS_", "AMENT_", "COLCON_", "CMAKE_PREFIX_PATH")
PASSED_ON_NAMES = ("HOME", "LANG")


@dataclass(frozen=True, slots=True)
class Settings:
    """The options of every command that reads a robot; times in seconds, memory in bytes."""

    distro: str | None = None
    simulator: str | None = None
    started: tuple[str, ...] | None = None
    workspace: str | None = None
    package_paths: tuple[str, ...] = ()
    environ: Mapping[str, str] = field(default_factory=dict)
    trust: bool = False
    timeout: float = 20.0
    memory: int = 2 << 30

    def __post_init__(self) -> None:
        if self.distro is not None and self.distro not in ALL:
            raise UserError(f"unknown distro '{self.distro}'{did_you_mean(self.distro, ALL)}")
        if self.simulator is not None and self.simulator not in SIMULATORS:
            known = ", ".join(SIMULATORS)
            raise UserError(f"unknown simulator '{self.simulator}': one of {known}")
        for folder in (*self.package_paths, *([self.workspace] if self.workspace else [])):
            if not os.path.isdir(folder):
                raise UserError(f"no such folder: '{folder}'")


def passed_on(environ: Mapping[str, str], named: tuple[str, ...] = ()) -> dict[str, str]:
    """The part of the environment that a robot's description may see."""
    return {
        name: value
        for name, value in environ.items()
        if name.startswith(PASSED_ON) or name in PASSED_ON_NAMES or name in named
    }
