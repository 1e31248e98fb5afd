"""The simulator plugins that a robot loads, with their catalogue entries, and the simulators its hardware runs in."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfctl.catalog.distros import ROS1, ROS2, since
from urdfctl.control.hardware.gazebo_plugins import DRIVES, LIBRARIES, MOVERS
from urdfctl.control.robots import robot_in
from urdfctl.model.project import Project
from urdfctl.model.robot import Plugin, Ros2Control, Tag
from urdfctl.source.opaque import is_known
from urdfctl.source.span import Place
from urdfctl.startup.per_object import once_for_the_last
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.catalog.hardware import PluginChild, SimulatorPlugin

IN_GAZEBO = {"gazebo-classic": "Gazebo Classic", "gz": "gz"}
"""The simulators whose plugin loads the hardware, with their names in messages."""


class LoadedPlugin(NamedTuple):
    """A plugin of the robot with its catalogue entries.

    plugin: the element. known: its entry in each of the project's distros, for the ROS version that its settings fit
    best. distros: the distros of both ROS versions that have the plugin. any: the last entry of `known`, or one of
    another distro. The last three are empty or None for an unknown plugin.
    """

    plugin: Plugin
    known: tuple[SimulatorPlugin, ...]
    distros: tuple[str, ...]
    any: SimulatorPlugin | None

    @property
    def library(self) -> str:
        """The library, without `lib` and `.so`."""
        from urdfctl.catalog.hardware import library_of

        return library_of(self.plugin.filename or "")

    @property
    def filename(self) -> str:
        """The file name as written."""
        return (self.plugin.filename or "").strip()

    @property
    def simulator(self) -> str | None:
        """The simulator that loads the plugin; None if it is not known."""
        if self.any is None:
            return "gazebo-classic" if any(self.library in libraries for libraries in LIBRARIES.values()) else None
        return self.any.simulator

    @property
    def hosts_control(self) -> bool:
        """Whether the plugin runs ros_control or ros2_control in the simulator."""
        return self.any is not None and self.any.hosts_control

    @property
    def drives(self) -> bool:
        """Whether the plugin drives a vehicle by its wheel joints."""
        return self.library in DRIVES

    @property
    def moves_joints(self) -> bool:
        """Whether the plugin commands joints itself."""
        return self.library in MOVERS

    @property
    def children(self) -> dict[str, PluginChild]:
        """The settings that the plugin reads in any of the project's distros; those in `<ros>` as `ros/namespace`."""
        return {name: child for known in self.known for name, child in known.children.items()}

    def settings(self) -> Iterator[tuple[str, Tag]]:
        """Yield the child elements with their names; those of `<ros>` as `ros/...`."""
        for tag in self.plugin.tag.children:
            if tag.name != "ros":
                yield tag.name, tag
                continue
            for inner in tag.children:
                yield f"ros/{inner.name}", inner

    def setting(self, name: str) -> Tag | None:
        """Return the first child element of a name; for a child of `<ros>`, the name is `ros/...`."""
        return next((tag for own, tag in self.settings() if own == name), None)


@once_for_the_last
def written_plugins(project: Project) -> tuple[LoadedPlugin, ...]:
    """Return the plugins of the whole robot, for any simulator."""
    robot = robot_in(project)
    return tuple(_loaded(project, plugin) for plugin in (robot.plugins if robot else ()))


@once_for_the_last
def loaded_plugins(project: Project) -> tuple[LoadedPlugin, ...]:
    """Return the plugins of the whole robot, without those of another simulator than the one the user names.

    Those of Gazebo Classic are left out of a robot for gz, too, whatever says that it is for gz.
    """
    plugins, wanted = written_plugins(project), project.named_simulator
    wanted = "gz" if project.simulator == "gz" else wanted
    return tuple(sim_plugin for sim_plugin in plugins if wanted is None or sim_plugin.simulator in (None, wanted))


def named_joints(sim_plugin: LoadedPlugin) -> Iterator[tuple[str, Place]]:
    """Yield the joints that a plugin's settings name, each with its place; one setting may list several."""
    children = sim_plugin.children
    for setting, tag in sim_plugin.settings():
        child = children.get(setting)
        if child and child.names == "joint":
            parts = [part.strip() for part in tag.text.split(",")]
            place = tag.at.content
            for name in parts:
                if name:
                    yield name, place


def of_sensors(project: Project) -> Iterator[LoadedPlugin]:
    """Yield the plugins of sensors, from `<gazebo reference="link"><sensor>`."""
    robot = robot_in(project)
    for gazebo in robot.gazebos if robot else ():
        for sensor in gazebo.tag.named("sensor"):
            for tag in sensor.named("plugin"):
                yield _loaded(project, Plugin(tag.attributes.get("name"), tag.attributes.get("filename"), tag.at, tag))


def control_plugins(project: Project) -> tuple[LoadedPlugin, ...]:
    """Return the plugins that run ros_control or ros2_control."""
    return tuple(sim_plugin for sim_plugin in loaded_plugins(project) if sim_plugin.hosts_control)


def _loaded(project: Project, plugin: Plugin) -> LoadedPlugin:
    filename = plugin.filename or ""
    if not filename.strip() or not is_known(filename):
        return LoadedPlugin(plugin, (), (), None)
    catalog = project.catalog
    distros = catalog.distros_of_library(filename)
    here = [distro for distro in project.distros if distro in distros]
    entries = [(distro, catalog.simulator_plugin(filename, distro)) for distro in here]
    by_ros = [tuple(entry for distro, entry in entries if entry and distro in family) for family in (ROS1, ROS2)]
    known = max(by_ros, key=lambda of_one_ros: _fit(plugin, of_one_ros))
    last = known[-1] if known else catalog.simulator_plugin(filename, distros[-1]) if distros else None
    return LoadedPlugin(plugin, known, distros, last)


def _fit(plugin: Plugin, known: tuple[SimulatorPlugin, ...]) -> int:
    """The number of a plugin's settings that a ROS version reads; -1 if it has no such plugin."""
    read = {name.partition("/")[0] for entry in known for name in entry.children}
    return sum(tag.name in read for tag in plugin.tag.children) if known else -1


def started_simulator(project: Project) -> str | None:
    """Return the simulator that the user names or the launch file starts: `gz`, `gazebo-classic`, or None."""
    launch = project.launch
    named = [project.named_simulator]
    named += [simulation.simulator for simulation in launch.simulations if simulation.sure] if launch else []
    return next((simulator for simulator in named if simulator in IN_GAZEBO), None)


def sure_simulator(project: Project) -> str | None:
    """Return the simulator that the robot certainly runs in: `gz`, `gazebo-classic`, or None.

    It is started, or a component has hardware that only this simulator has. A plugin in <gazebo> alone proves nothing:
    real robots have such plugins too.
    """
    found = (started_simulator(project), *(simulator_of(project, control) for control in components(project)))
    return next((simulator for simulator in found if simulator in IN_GAZEBO), None)


def components(project: Project) -> tuple[Ros2Control, ...]:
    """Return the components that name their hardware and are directly in the root element."""
    robot = robot_in(project)
    in_root = (control for control in robot.ros2_controls if control.parent == robot.element) if robot else ()
    return tuple(control for control in in_root if control.plugin)


def simulator_of(project: Project, control: Ros2Control) -> str | None:
    """Return the simulator of a component's hardware plugin, or `mock`, `topic` or `replay`.

    None if the hardware is real or not known.
    """
    name = control.plugin or ""
    if not name or not is_known(name):
        return None
    entries = (project.catalog.hardware(name, distro) for distro in (*project.distros, *_LATER))
    return next((entry.simulator for entry in entries if entry), None)


def has_other_hardware(project: Project) -> bool:
    """Return whether the robot has hardware, and none of it runs in a simulator: mocked, real or its own."""
    parts = components(project)
    known = all(is_known(control.plugin or "") for control in parts)
    return bool(parts) and known and not any(simulator_of(project, control) in IN_GAZEBO for control in parts)


_LATER = since("iron")
"""Distros that together have all hardware plugins for Gazebo."""


def namespace_of(text: str) -> str:
    """Return a namespace with a leading slash and without a trailing one; empty for the root."""
    inner = "/".join(part for part in text.strip().split("/") if part)
    return f"/{inner}" if inner else ""
