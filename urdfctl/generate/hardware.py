"""Which plugins run a robot's joints: the hardware's, and the simulator's that hosts the controller manager."""

from __future__ import annotations

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.hardware import HardwareType, SimulatorPlugin
from urdfctl.errors import UserError
from urdfctl.generate.options import Options
from urdfctl.suggest import did_you_mean

_SHORT = {"mock": "mock", "topic-based": "topic", "mujoco": "mujoco", "gz": "gz", "gazebo-classic": "gazebo-classic"}


def host(options: Options, catalog: Catalog) -> SimulatorPlugin:
    """The simulator plugin that runs the controllers. UserError where the distro has none for the simulator."""
    fit = [one for one in catalog.simulator_plugins(options.distro) if one.hosts_control]
    fit = [one for one in fit if one.simulator == options.simulator]
    if not fit:
        raise UserError(f"{options.distro} has no plugin that runs controllers in '{options.simulator}'")
    return next((one for one in fit if not one.deprecated), fit[0])


def hardware(options: Options, catalog: Catalog) -> HardwareType:
    """The hardware plugin: as named, else of the simulator, else mock. UserError where the distro has none."""
    wanted = options.hardware or (options.simulator if options.simulated else "mock")
    if wanted not in _SHORT:
        found = catalog.hardware(wanted, options.distro)
        if found is None and catalog.hardware_replacement(wanted, options.distro):
            raise UserError(
                f"{options.distro} has no '{wanted}'; take '{catalog.hardware_replacement(wanted, options.distro)}'"
            )
        if found is None and "/" not in wanted and "::" not in wanted:
            raise UserError(f"unknown hardware '{wanted}'{did_you_mean(wanted, _SHORT)}; known are {', '.join(_SHORT)}")
        return found or HardwareType(wanted, options.distro, wanted.partition("/")[0], ("system",))
    if wanted in ("gz", "gazebo-classic"):
        name = host(options._replace(simulator=wanted), catalog).default_hardware or ""
        found = catalog.hardware(name, options.distro)
        if found is not None:
            return found
    known = (catalog.hardware(name, options.distro) for name in catalog.known_hardware(options.distro))
    fit = [one for one in known if one and one.simulator == _SHORT[wanted] and "system" in one.component_types]
    if not fit:
        raise UserError(f"{options.distro} has no '{wanted}' hardware")
    return next((one for one in fit if not one.deprecated), fit[0])
