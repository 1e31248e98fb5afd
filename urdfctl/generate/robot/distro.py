"""The distro and the simulator that files are generated for, if nothing names them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeVar

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import DISTROS
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.generate.robot.facts import RobotFacts

Made = TypeVar("Made")


def known_distro(settings: Settings, robot: RobotFacts | None) -> str | None:
    """Return the distro that an option, the configuration, the robot or the environment names."""
    return settings.distro or (robot.distro if robot else None) or settings.environ.get("ROS_DISTRO")


def made_for_newest(robot: RobotFacts | None, make: Callable[[str], Made]) -> tuple[Made, str]:
    """Return what is made for the newest distro that has all that was asked for, and a line about which one that is.

    make: makes it for a distro; raises UserError if the distro lacks something. UserError if no distro has it.
    """
    first: UserError | None = None
    for distro in _candidates(robot):
        try:
            made = make(distro)
        except UserError as error:
            first = first or error
            continue
        why = "the newest one that has all of this" if first else "the newest one"
        return made, f"ROS distro is unknown; using {distro}, {why}. Set it with --distro"
    raise UserError(f"{first}. No ROS distro is known, and none has all of this: set it with --distro") from None


def _candidates(robot: RobotFacts | None) -> Iterator[str]:
    """The possible distros: maintained ones first, the newest first; rolling is the last one."""
    possible = robot.distros if robot and robot.distros else tuple(distro.name for distro in DISTROS)
    generation = robot.ros if robot else None
    known = [distro for distro in reversed(DISTROS) if distro.name in possible and distro.name != "rolling"]
    fit = [distro for distro in known if distro.ros == generation or generation is None]
    order = sorted(fit, key=lambda distro: (-distro.ros, not distro.maintained))
    yield from (distro.name for distro in order)
    if "rolling" in possible and generation != 1:
        yield "rolling"


def simulator_of(distro: str, command: str, catalog: Catalog) -> str:
    """Return the simulator of a distro that gen-gazebo writes the plugin of; "none" for other generators."""
    if command != "gen-gazebo":
        return "none"
    hosts = {plugin.simulator for plugin in catalog.simulator_plugins(distro) if plugin.hosts_control}
    return next((name for name in ("gz", "gazebo-classic") if name in hosts), "none")
