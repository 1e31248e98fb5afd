"""Choose the hardware plugin, and the simulator plugin that runs the controller manager."""

from __future__ import annotations

import os

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import since
from urdfctl.catalog.hardware import HardwareType, SimulatorPlugin
from urdfctl.errors import UserError
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.names import did_you_mean, enumerated

_PREFERRED = ("mujoco_ros2_control/MujocoSystemInterface",)
"""Of several hardware plugins for one simulator, the one whose node the launch files start."""
ANY_NAMESPACE = since("humble")
"""The distros of ROS 2 in which `/**/NAME` in a parameter file names a node in any namespace."""
_SHORT = {"mock": "mock", "topic-based": "topic", "mujoco": "mujoco", "gz": "gz", "gazebo-classic": "gazebo-classic"}


def host(options: GeneratorOptions, catalog: Catalog) -> SimulatorPlugin:
    """Return the simulator plugin that runs the controllers. UserError if the distro has none for the simulator."""
    hosts = [plugin for plugin in catalog.simulator_plugins(options.distro) if plugin.hosts_control]
    fit = [plugin for plugin in hosts if plugin.simulator == options.simulator]
    if not fit:
        there = dict.fromkeys(plugin.simulator for plugin in hosts if plugin.simulator)
        mujoco = [name for name in _PREFERRED if name in catalog.known_hardware(options.distro)]
        choices = enumerated([*there, *(["mujoco"] if mujoco else []), "none"], "or")
        raise UserError(
            f"{options.distro} has no plugin that runs controllers in '{options.simulator}'; use --simulator {choices}"
        )
    return min(fit, key=lambda plugin: (plugin.deprecated, plugin.id != options.simulator))  # not a manufacturer's


def has_host(robot: RobotFacts, options: GeneratorOptions, catalog: Catalog) -> bool:
    """Return whether a robot has a simulator plugin that runs controllers in a distro."""
    known = (catalog.simulator_plugin(name, options.distro) for name in robot.hosts)
    return any(plugin and plugin.hosts_control for plugin in known)


def loads_others(robot: RobotFacts, options: GeneratorOptions, catalog: Catalog) -> str:
    """Return that the plugin of a robot loads controllers of its own, not the generated ones; else an empty text."""
    hosted = options.ros == 2 and options.simulator in ("gz", "gazebo-classic") and has_host(robot, options, catalog)  # noqa: PLR2004
    if not hosted or not robot.hosted:
        return ""
    return (
        f"the simulator's plugin in the robot loads the controllers of '{hosted_file(robot)}', and not these: name a "
        "description without the plugin, or leave it out by an argument"
    )


def unplanned(robot: RobotFacts, options: GeneratorOptions, catalog: Catalog) -> str:
    """Return why MoveIt cannot use the controllers that the plugin of a robot runs, or an empty text."""
    hosted = options.simulator in ("gz", "gazebo-classic") and has_host(robot, options, catalog)
    if hosted and robot.space and "namespace" not in robot.arguments:
        return (
            f"the simulator's plugin in the robot runs its controllers in namespace '{robot.space}', and MoveIt's "
            "configuration has no namespace: leave it out by an argument of the robot"
        )
    return "" if options.own else loads_others(robot, options, catalog)


def hosted_file(robot: RobotFacts) -> str:
    """Return the path of the controllers that the plugin of a robot loads, for a message."""
    file = robot.hosted[0]
    return os.path.relpath(file) if os.path.isabs(file) else file


def simulates(robot: RobotFacts, distro: str, catalog: Catalog) -> bool:
    """Return whether the hardware of a robot may be that of a simulator: only then its plugin runs controllers."""
    known = [catalog.hardware(name, distro) for name in robot.plugins]
    return any(entry is None or entry.simulator in ("gz", "gazebo-classic") for entry in known)


def takes_namespace(robot: RobotFacts, options: GeneratorOptions, catalog: Catalog) -> bool:
    """Return whether the namespace of a robot can be chosen when it is started.

    Since humble, `/**/` in a controller file stands for any namespace (rclcpp #1839). The simulator plugin of the robot
    must take the namespace from an argument, as the generated ones do.
    """
    if options.ros == 2 and options.distro not in ANY_NAMESPACE:  # noqa: PLR2004
        return False
    hosted = options.simulator in ("gz", "gazebo-classic")
    return not hosted or "namespace" in robot.arguments or not has_host(robot, options, catalog)


def hardware(options: GeneratorOptions, catalog: Catalog) -> HardwareType:
    """Return the named hardware plugin, or that of the simulator, or mock hardware.

    UserError if the distro has none.
    """
    wanted = options.hardware or (options.simulator if options.simulated else "mock")
    if wanted not in _SHORT:
        found = catalog.hardware(wanted, options.distro)
        if found is None and catalog.hardware_replacement(wanted, options.distro):
            raise UserError(
                f"{options.distro} has no '{wanted}'; use '{catalog.hardware_replacement(wanted, options.distro)}'"
            )
        if found is None and "/" not in wanted and "::" not in wanted:
            raise UserError(f"unknown hardware '{wanted}'{did_you_mean(wanted, _SHORT)}; known: {', '.join(_SHORT)}")
        return found or HardwareType(wanted, options.distro, wanted.partition("/")[0], ("system",))
    if wanted in ("gz", "gazebo-classic"):
        name = host(options._replace(simulator=wanted), catalog).default_hardware or ""
        found = catalog.hardware(name, options.distro)
        if found is not None:
            return found
    known = [catalog.hardware(name, options.distro) for name in catalog.known_hardware(options.distro)]
    systems = [entry for entry in known if entry and "system" in entry.component_types]
    fit = [entry for entry in systems if entry.simulator == _SHORT[wanted]]
    if not fit:
        there = {entry.simulator for entry in systems}
        choices = ", ".join(short for short, simulator in _SHORT.items() if simulator in there)
        raise UserError(f"{options.distro} has no '{wanted}' hardware; choose from: {choices}")
    return min(fit, key=lambda plugin: (plugin.deprecated, plugin.type not in _PREFERRED))
