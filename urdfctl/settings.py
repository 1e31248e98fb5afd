"""What the user may set for a run, however it was set."""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.catalog.distros import ALL, SIMULATORS
from urdfctl.errors import UserError
from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.suggest import did_you_mean

PASSED_ON = ("ROS_", "AMENT_", "COLCON_", "CMAKE_PREFIX_PATH")
PASSED_ON_NAMES = ("HOME", "LANG")
MOST_SECONDS = 86_400
MOST_BYTES = 1 << 40
ALL_STARTED = ("all",)
"""What to say where all controllers are started that the files declare."""


class Settings(NamedTuple):
    """The options of every command that reads a robot; times in seconds, memory in bytes.

    `distro_from` and `simulator_from` tell what set those, where it was not an option.
    """

    distro: str | None = None
    simulator: str | None = None
    started: tuple[str, ...] | None = None
    workspace: str | None = None
    package_paths: tuple[str, ...] = ()
    environ: Mapping[str, str] = MappingProxyType({})
    trust: bool = False
    timeout: float = 20.0
    memory: int = 2 << 30
    additions: Additions = NO_ADDITIONS
    distro_from: str | None = None
    simulator_from: str | None = None

    def to_json(self) -> dict[str, Any]:
        """As plain data."""
        return {**self._asdict(), "environ": dict(self.environ), "additions": self.additions._asdict()}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Settings:
        """From plain data."""
        plain: dict[str, Any] = {n: tuple(value) if isinstance(value, list) else value for n, value in data.items()}
        additions = {kind: tuple(entries) for kind, entries in data.get("additions", {}).items()}
        return cls(**{**plain, "additions": Additions(**additions) if any(additions.values()) else NO_ADDITIONS})


def checked(settings: Settings) -> Settings:
    """The settings, if they mean something. UserError where they do not."""
    if settings.distro is not None and settings.distro not in ALL:
        raise UserError(f"unknown distro '{settings.distro}'{did_you_mean(settings.distro, ALL)}")
    if settings.simulator is not None and settings.simulator not in SIMULATORS:
        near = did_you_mean(settings.simulator, SIMULATORS)
        raise UserError(f"unknown simulator '{settings.simulator}'{near}; known are {', '.join(SIMULATORS)}")
    for folder in (*settings.package_paths, *([] if settings.workspace is None else [settings.workspace])):
        if not os.path.isdir(folder):
            raise UserError(f"no such folder: '{folder}'")
    if not 0 < settings.timeout <= MOST_SECONDS:
        raise UserError(f"--timeout is a number of seconds up to {MOST_SECONDS}, not {settings.timeout:g}")
    if not 0 < settings.memory <= MOST_BYTES:
        raise UserError(f"--memory is a number of MiB up to {MOST_BYTES >> 20}, not {settings.memory >> 20}")
    return settings


def passed_on(environ: Mapping[str, str], named: tuple[str, ...] = ()) -> dict[str, str]:
    """The part of the environment that a robot's description may see."""
    return {
        name: value
        for name, value in environ.items()
        if name.startswith(PASSED_ON) or name in PASSED_ON_NAMES or name in named
    }
