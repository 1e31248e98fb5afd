"""What the user may set for a run, however it was set."""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from urdfctl.catalog.distros import ALL, SIMULATORS
from urdfctl.errors import UserError
from urdfctl.suggest import did_you_mean

PASSED_ON = ("ROS_", "AMENT_", "COLCON_", "CMAKE_PREFIX_PATH")
PASSED_ON_NAMES = ("HOME", "LANG")


class Settings(NamedTuple):
    """The options of every command that reads a robot; times in seconds, memory in bytes."""

    distro: str | None = None
    simulator: str | None = None
    started: tuple[str, ...] | None = None
    workspace: str | None = None
    package_paths: tuple[str, ...] = ()
    environ: Mapping[str, str] = MappingProxyType({})
    trust: bool = False
    timeout: float = 20.0
    memory: int = 2 << 30


def checked(settings: Settings) -> Settings:
    """The settings, if they mean something. UserError where they do not."""
    if settings.distro is not None and settings.distro not in ALL:
        raise UserError(f"unknown distro '{settings.distro}'{did_you_mean(settings.distro, ALL)}")
    if settings.simulator is not None and settings.simulator not in SIMULATORS:
        known = ", ".join(SIMULATORS)
        raise UserError(f"unknown simulator '{settings.simulator}': one of {known}")
    for folder in (*settings.package_paths, *([settings.workspace] if settings.workspace else [])):
        if not os.path.isdir(folder):
            raise UserError(f"no such folder: '{folder}'")
    return settings


def passed_on(environ: Mapping[str, str], named: tuple[str, ...] = ()) -> dict[str, str]:
    """The part of the environment that a robot's description may see."""
    return {
        name: value
        for name, value in environ.items()
        if name.startswith(PASSED_ON) or name in PASSED_ON_NAMES or name in named
    }
