"""What the rules on simulator plugins share: which plugins a robot loads, and what is known of them."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1, ROS2
from urdfctl.catalog.hardware import PluginChild, SimulatorPlugin, library_of
from urdfctl.hints import TYPE_CHECKING
from urdfctl.memory import once_for_the_last
from urdfctl.model.parts import Tag
from urdfctl.model.robot import Plugin
from urdfctl.model.ros2_control import Ros2Control
from urdfctl.record import NamedTuple
from urdfctl.rule import Project
from urdfctl.rules.common import is_all_there, is_known, robot_in
from urdfctl.rules.simulation.facts import BECAME, DRIVES, LIBRARIES, MOVERS
from urdfctl.source.span import Place
from urdfctl.suggest import folded, is_slip

if TYPE_CHECKING:
    from urdfctl.model.controllers import FileReference

ROS_2 = 2
IN_GAZEBO = {"gazebo-classic": "Gazebo Classic", "gz": "gz"}
"""The simulators whose plugin loads the hardware, and what messages call them."""


class Loaded(NamedTuple):
    """A plugin of the robot, with what the catalogue tells of it: as each distro has it that the project may be for, of
    the one generation of ROS that its settings are written for; and which distros of both generations have it. Both are
    empty where it is not known."""

    plugin: Plugin
    known: tuple[SimulatorPlugin, ...]
    distros: tuple[str, ...]
    any: SimulatorPlugin | None

    @property
    def library(self) -> str:
        """Its library, without `lib` and `.so`."""
        return library_of(self.plugin.filename or "")

    @property
    def filename(self) -> str:
        """Its file, as it is written."""
        return (self.plugin.filename or "").strip()

    @property
    def simulator(self) -> str | None:
        """The simulator that loads it; None where it is not known."""
        if self.any is None:
            return "gazebo-classic" if any(self.library in of for of in LIBRARIES.values()) else None
        return self.any.simulator

    @property
    def hosts_control(self) -> bool:
        """Whether it runs ros_control or ros2_control in the simulator."""
        return self.any is not None and self.any.hosts_control

    @property
    def drives(self) -> bool:
        """Whether it drives a vehicle by the joints of its wheels."""
        return self.library in DRIVES

    @property
    def moves_joints(self) -> bool:
        """Whether it commands joints itself."""
        return self.library in MOVERS

    @property
    def children(self) -> dict[str, PluginChild]:
        """What it reads in any of the project's distros; `ros/namespace` is a child of its child."""
        return {name: child for each in self.known for name, child in each.children.items()}

    def settings(self) -> Iterator[tuple[str, Tag]]:
        """Its children with their names; those of `<ros>` as `ros/...`."""
        for tag in self.plugin.tag.children:
            if tag.name != "ros":
                yield tag.name, tag
                continue
            for inner in tag.children:
                yield f"ros/{inner.name}", inner

    def setting(self, name: str) -> Tag | None:
        """Its first child of a name; `ros/...` of a child of `<ros>`."""
        return next((tag for own, tag in self.settings() if own == name), None)


@once_for_the_last
def loaded(project: Project) -> tuple[Loaded, ...]:
    """The plugins of the robot as a whole, but for those that only another simulator loads than the user names."""
    robot = robot_in(project)
    found = (_loaded(project, plugin) for plugin in (robot.plugins if robot else ()))
    wanted = project.named_simulator
    return tuple(one for one in found if wanted is None or one.simulator in (None, wanted))


def of_sensors(project: Project) -> Iterator[Loaded]:
    """The plugins of sensors, which stand in `<gazebo reference="link"><sensor>`."""
    robot = robot_in(project)
    for gazebo in robot.gazebos if robot else ():
        for sensor in gazebo.tag.named("sensor"):
            for tag in sensor.named("plugin"):
                yield _loaded(project, Plugin(tag.attributes.get("name"), tag.attributes.get("filename"), tag.at, tag))


def control_plugins(project: Project) -> tuple[Loaded, ...]:
    """The plugins that run ros_control or ros2_control."""
    return tuple(one for one in loaded(project) if one.hosts_control)


def _loaded(project: Project, plugin: Plugin) -> Loaded:
    filename = plugin.filename or ""
    if not filename.strip() or not is_known(filename):
        return Loaded(plugin, (), (), None)
    catalog = project.catalog
    distros = catalog.distros_of_library(filename)
    here = [distro for distro in project.distros if distro in distros]
    found = [(distro, catalog.simulator_plugin(filename, distro)) for distro in here]
    by_ros = [tuple(each for distro, each in found if each and distro in family) for family in (ROS1, ROS2)]
    known = max(by_ros, key=lambda one: _fit(plugin, one))
    last = known[-1] if known else catalog.simulator_plugin(filename, distros[-1]) if distros else None
    return Loaded(plugin, known, distros, last)


def _fit(plugin: Plugin, known: tuple[SimulatorPlugin, ...]) -> int:
    """How many of a plugin's settings a generation of ROS reads; less than none where it has no such plugin."""
    read = {name.partition("/")[0] for each in known for name in each.children}
    return sum(tag.name in read for tag in plugin.tag.children) if known else -1


def components(project: Project) -> tuple[Ros2Control, ...]:
    """The components that name their hardware, and stand where they are read."""
    robot = robot_in(project)
    found = (control for control in robot.ros2_controls if control.parent == robot.element) if robot else ()
    return tuple(control for control in found if control.plugin)


def simulator_of(project: Project, control: Ros2Control) -> str | None:
    """What a component's hardware plugin simulates with, `mock`, `topic` and `replay` too; None where it is real, or
    not known."""
    name = control.plugin or ""
    if not name or not is_known(name):
        return None
    found = (project.catalog.hardware(name, distro) for distro in (*project.distros, *_LATER))
    return next((each.simulator for each in found if each), None)


_LATER = ("iron", "jazzy", "rolling")
"""Distros whose hardware plugins, taken together, are all that run in Gazebo."""


def namespace_of(text: str) -> str:
    """A namespace as ROS takes it: with a leading slash and without one at its end; empty at the root."""
    inner = "/".join(part for part in text.strip().split("/") if part)
    return f"/{inner}" if inner else ""


def number(text: str) -> float | None:
    """The number that all of a text is; None where it is none."""
    try:
        return float(text)
    except ValueError:
        return None


# -- settings --------------------------------------------------------------------------------------------------------


class Unread(NamedTuple):
    """A setting that its plugin does not read in any distro that the project may be for; `meant` is the one that was
    meant, or where its meaning went, None where that is not known. `same`: it is that but for case and underscores."""

    one: Loaded
    name: str
    tag: Tag
    meant: str | None
    same: bool

    @property
    def moved(self) -> bool:
        """Whether what it says is said outside of the plugin now."""
        return self.meant is not None and " " in self.meant

    @property
    def shown(self) -> str:
        """What is meant, as a message shows it."""
        meant = self.meant or ""
        if not meant.startswith("ros/"):
            return f"<{meant}>" if meant in self.one.children else meant
        inner, text = meant.removeprefix("ros/"), self.tag.text
        if inner == "remapping":
            text = f"{'odom' if 'odom' in self.name.lower() else 'cmd_vel'}:={text}"
        return f"<ros><{inner}>{text}</{inner}></ros>"

    @property
    def harmless(self) -> bool:
        """Whether nothing is lost: it is said outside of the plugin, or is what the plugin takes without it."""
        child = self.one.children.get(self.meant or "")
        if self.moved or child is None or child.name == "ros/remapping":
            return self.moved or self.tag.text.strip("/") in ("cmd_vel", "odom")
        value = number(self.tag.text)
        return self.tag.text == str(child.default) or (value is not None and value == child.default)


def unread_settings(project: Project) -> Iterator[Unread]:
    """The settings that known plugins do not read."""
    for one in loaded(project):
        children = one.children if one.known else {}
        if not children:
            continue
        read = {*children, *(alias for child in children.values() for alias in child.aliases)}
        given = {name for name, _ in one.settings()}
        for name, tag in one.settings():
            if name not in read and is_known(name) and ":" not in name:
                meant, same = _meant(name, children)
                yield Unread(one, name, tag, None if meant in given else meant, same)


def _meant(name: str, children: dict[str, PluginChild]) -> tuple[str | None, bool]:
    """What was meant by a setting, and whether it is that but for case and underscores."""
    by_folded = {folded(known): known for known in children}
    key = folded(name.removeprefix("ros/"))
    same = by_folded.get(key) or by_folded.get(f"ros/{key}")
    if same:
        return same, True
    for became in BECAME.get(key, ()):
        if became in children or (" " in became and "ros/namespace" in children):
            return became, False
    return next((known for other, known in by_folded.items() if is_slip(key, other)), None), False


def is_written_empty(tag: Tag) -> bool:
    """Whether the source leaves an element empty, and not an argument that another caller gives."""
    return not tag.text and tag.at.content.start == tag.at.start


def named_joints(one: Loaded) -> Iterator[tuple[str, Place]]:
    """The joints that a plugin's settings name, each with its place; one setting may list several."""
    children = one.children
    for setting, tag in one.settings():
        child = children.get(setting)
        if child and child.names == "joint":
            parts = [part.strip() for part in tag.text.split(",")]
            place = tag.at.content
            for name in parts:
                if name:
                    yield name, place


def default_joints(project: Project, one: Loaded) -> Iterator[tuple[str, str]]:
    """The settings that a plugin lacks and that name a joint by default, with that default."""
    if not one.moves_joints or not is_all_there(project, one.plugin.tag):
        return
    near = {unread.meant for unread in unread_settings(project) if unread.one.plugin is one.plugin}
    for name, child in one.children.items():
        optional = child.names != "joint" or not isinstance(child.default, str) or name == "steering_wheel_joint"
        if not optional and one.setting(name) is None and name not in near:
            yield name, str(child.default)


def wheel_measures(one: Loaded) -> Iterator[tuple[str, float]]:
    """The settings that measure a drive's wheels, in m, with their defaults."""
    for name, child in one.children.items():
        if isinstance(child.default, float) and folded(name).endswith(_MEASURES):
            yield name, child.default


_MEASURES = ("wheelseparation", "wheeldiameter", "wheelradius", "wheelbase")


# -- the controllers' files ------------------------------------------------------------------------------------------


def controllers_files(project: Project) -> Iterator[tuple[Loaded, Tag, FileReference]]:
    """The controllers' files that the plugins name, each with its plugin and element."""
    references = project.controllers.references if project.controllers else ()
    by_place = {(reference.at.source.path, reference.at.start): reference for reference in references}
    for one in control_plugins(project):
        for tag in one.plugin.tag.named("parameters"):
            at = tag.at.content
            reference = by_place.get((at.source.path, at.start))
            if reference is not None and reference.text == tag.text:
                yield one, tag, reference
