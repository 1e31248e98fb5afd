"""Settings of a run, from options, the configuration and the environment."""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.catalog.distros import ALL, ROS1, ROS2, SIMULATORS
from urdfctl.errors import UserError
from urdfctl.names import did_you_mean
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.config.file import Config

PASSED_ON = ("ROS_", "AMENT_", "COLCON_", "CMAKE_PREFIX_PATH")
PASSED_ON_NAMES = ("HOME", "LANG")
MOST_SECONDS = 86_400
MOST_BYTES = 1 << 40
ALL_STARTED = ("all",)
"""The value of `Settings.started` for all controllers that the files declare."""


class Settings(NamedTuple):
    """Settings of every command that reads a robot.

    started: the controllers that are started together; None if unknown.
    workspace: the folder outside of which nothing is read; None to detect it.
    package_paths: folders with packages, searched first.
    environ: the environment variables that a description may read.
    trust: True to read any file and evaluate any expression.
    timeout: seconds for one robot.
    memory: bytes for one robot.
    additions: the project's own controllers and hardware.
    distro_from, simulator_from: where the value comes from, if not from an option.
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
    named_files: tuple[str, ...] = ()
    nodes: tuple[tuple[str, Mapping[str, Mapping[str, Any]]], ...] = ()
    """Names of nodes, each with the definitions of its parameters in the form of the catalogue."""

    def to_json(self) -> dict[str, Any]:
        """Return the settings as plain data."""
        return {**self._asdict(), "environ": dict(self.environ), "additions": self.additions._asdict()}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Settings:
        """Return the settings that `to_json` made `data` from."""
        plain: dict[str, Any] = {
            name: tuple(value) if isinstance(value, list) else value for name, value in data.items()
        }
        plain["nodes"] = tuple((name, parameters) for name, parameters in data.get("nodes", ()))
        additions = {kind: tuple(entries) for kind, entries in data.get("additions", {}).items()}
        return cls(**{**plain, "additions": Additions(**additions) if any(additions.values()) else NO_ADDITIONS})


def settings_with(config: Config, given: Settings) -> Settings:
    """Return the settings of a run: those given, then those of the configuration. UserError if one is invalid."""
    return validate_settings(
        given._replace(
            distro=given.distro or config.distro,
            simulator=given.simulator or config.simulator,
            package_paths=given.package_paths or config.package_paths,
            additions=config.additions,
            distro_from=None if given.distro else config.distro_from,
            simulator_from=None if given.simulator else config.simulator_from,
        )
    )


def validate_settings(settings: Settings) -> Settings:
    """Return the settings. UserError if one is invalid."""
    if settings.distro is not None and settings.distro not in ALL:
        raise UserError(_unknown_distro(settings.distro))
    if settings.simulator is not None and settings.simulator not in SIMULATORS:
        near = did_you_mean(settings.simulator, SIMULATORS)
        raise UserError(f"unknown simulator '{settings.simulator}'{near}; known are {', '.join(SIMULATORS)}")
    for folder in (*settings.package_paths, *([] if settings.workspace is None else [settings.workspace])):
        if not os.path.isdir(folder):
            raise UserError(f"folder '{folder}' does not exist")
    if not 0 < settings.timeout <= MOST_SECONDS:
        raise UserError(f"--timeout must be a number of seconds up to {MOST_SECONDS}, not {settings.timeout:g}")
    if not 0 < settings.memory <= MOST_BYTES:
        raise UserError(f"--memory must be a number of MiB up to {MOST_BYTES >> 20}, not {settings.memory >> 20}")
    return settings


_OF_UBUNTU = {
    **dict.fromkeys(("20.04", "focal"), ("noetic", "foxy", "galactic")),
    **dict.fromkeys(("22.04", "jammy"), ("humble", "iron")),
    **dict.fromkeys(("24.04", "noble"), ("jazzy", "kilted")),
    **dict.fromkeys(("18.04", "bionic"), ("melodic",)),
    **dict.fromkeys(("16.04", "xenial"), ("kinetic",)),
}


def _unknown_distro(name: str) -> str:
    """The error for a name that is no distro, with the distros that may be meant."""
    lowered = name.lower().removeprefix("ubuntu").strip(" -_")
    of_ros = {"ros": ALL, "ros1": ROS1, "ros 1": ROS1, "ros2": ROS2, "ros 2": ROS2}.get(name.lower())
    meant = of_ros or _OF_UBUNTU.get(lowered)
    hint = did_you_mean(name, ALL)
    if meant and not of_ros:
        return f"unknown distro '{name}': it is a release of Ubuntu, for which there is {' or '.join(meant)}"
    return f"unknown distro '{name}'{hint}" if hint else f"unknown distro '{name}'; known are {', '.join(meant or ALL)}"


def passed_on(environ: Mapping[str, str], named: tuple[str, ...] = ()) -> dict[str, str]:
    """Return the environment variables that a description may read: those of ROS, and the named ones."""
    return {
        name: value
        for name, value in environ.items()
        if name.startswith(PASSED_ON) or name in PASSED_ON_NAMES or name in named
    }
