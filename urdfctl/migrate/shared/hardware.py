"""The plugins that a migrated robot gets: that of its hardware, and that of the simulator."""

from __future__ import annotations

import re
from collections.abc import Sequence

from urdfctl.catalog.catalog import catalog_with
from urdfctl.catalog.hardware import HardwareType, SimulatorPlugin
from urdfctl.generate.files.hardware import hardware, host
from urdfctl.generate.options import GeneratorOptions
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.source.workspaces.packages import package_name

HARDWARE_OPTION = "--hardware PLUGIN"


_HARDWARE = (b"<transmission", b"<ros2_control", b":ros2_control")
_INCLUDED = re.compile(rb"<(?:xacro:)?include\b[^<>]*\bfilename=['\"]\$\(find\s+([\w-]+)\s*\)")
_OF_SENSORS = re.compile(r"realsense|velodyne|hokuyo|sick|kinect|astra|zed|camera|lidar|laser|sensor|imu")
_HOSTS = (
    b"libgazebo_ros_control.so",
    b"libhwi_switch_gazebo_ros_control.so",
    b"libgazebo_ros2_control.so",
    b"gz_ros2_control-system",
    b"ign_ros2_control-system",
)


def simulated_by(packages: MigratedPackages) -> str:
    """Return the simulator that runs the controllers after the migration; `none` if no plugin of the robots does."""
    simulator = packages.simulator or "none"
    if simulator in ("gz", "gazebo-classic") and not packages.found(_has_host):
        return simulator if packages.found(described_elsewhere) else "none"
    return simulator


def described_elsewhere(packages: MigratedPackages) -> bool:
    """Return whether launch files put a robot into Gazebo whose hardware no description here has, or not all of it: its
    package, or one that it includes files of, is another one."""
    texts = [packages.read(path).data for path in packages.files(*OF_XML)]
    if packages.found(_has_host) or not any(
        b"spawn_model" in packages.read(path).data for path in packages.files(".launch", ".xml")
    ):
        return False
    return not any(mark in text for text in texts for mark in _HARDWARE) or _includes_others(packages, texts)


def _includes_others(packages: MigratedPackages, texts: Sequence[bytes]) -> bool:
    """Whether descriptions include files of packages that are not here, and may be more than sensors."""
    own = {name for path in packages.files("package.xml") if (name := package_name(path))}
    included = {found[1].decode() for text in texts for found in _INCLUDED.finditer(text)}
    return any(name not in own and not _OF_SENSORS.search(name) for name in included)


def _has_host(packages: MigratedPackages) -> bool:
    return any(host in packages.read(path).data for path in packages.files(*OF_XML) for host in _HOSTS)


def leaves_classic(packages: MigratedPackages) -> bool:
    """Return whether the packages leave Gazebo Classic."""
    return packages.simulator != "gazebo-classic" and (packages.simulator is not None or packages.crosses("jazzy"))


def goes_to_gz(packages: MigratedPackages) -> bool:
    """Return whether what is for Gazebo Classic becomes what gz reads."""
    return packages.simulator == "gz" or (packages.simulator is None and packages.crosses("jazzy"))


def started_by_launch_files(packages: MigratedPackages) -> str:
    """Return the simulator that launch files start where they started Gazebo Classic, whatever runs the controllers."""
    if goes_to_gz(packages):
        return "gz"
    return "none" if leaves_classic(packages) else "gazebo-classic"


def options_of(packages: MigratedPackages) -> GeneratorOptions:
    """Return the options of the generators for the migrated packages."""
    return GeneratorOptions(packages.options.target, simulated_by(packages), hardware=_named(packages))


def _named(packages: MigratedPackages) -> str | None:
    return packages.options.hardware if simulated_by(packages) == "none" else None


def system(packages: MigratedPackages) -> HardwareType:
    """Return the hardware plugin of the migrated robot: that of the simulator, the one that the user names, or mock."""
    return hardware(options_of(packages), catalog_with(packages.settings.additions))


def system_plugin(packages: MigratedPackages) -> str:
    """Return the name of the hardware plugin."""
    return system(packages).type


def host_plugin(packages: MigratedPackages) -> SimulatorPlugin | None:
    """Return the simulator plugin that runs the controllers; None without a simulator that needs one."""
    if simulated_by(packages) not in ("gz", "gazebo-classic"):
        return None
    return host(options_of(packages), catalog_with(packages.settings.additions))


def without_hardware(packages: MigratedPackages, component: str) -> str:
    """Return what a person must decide about the hardware plugin of a component; empty if it is known."""
    if simulated_by(packages) != "none" or packages.options.hardware is not None:
        return ""
    moves = f"{system_plugin(packages)}, which moves nothing"
    return f"component '{component}' uses {moves}: name the plugin of the real hardware in <plugin>"
