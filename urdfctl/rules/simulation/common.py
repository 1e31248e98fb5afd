"""Shared by the rules on simulator plugins: the plugins that a robot loads, with their catalogue entries."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfctl.catalog.hardware import PluginChild
from urdfctl.control.hardware.gazebo_plugins import BECAME
from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, control_plugins, loaded_plugins
from urdfctl.model.robot import Tag
from urdfctl.names import folded, is_slip
from urdfctl.rule import Project
from urdfctl.rules.common import is_all_there, is_known
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.model.controllers import FileReference

ROS_2 = 2


def number(text: str) -> float | None:
    """Return a text as a number; None if it is not a number."""
    try:
        return float(text)
    except ValueError:
        return None


# -- settings --------------------------------------------------------------------------------------------------------


class Unread(NamedTuple):
    """A setting that its plugin does not read in any of the project's distros.

    meant: the setting that was probably meant, or where the value belongs now; None if not known.
    same: whether both differ only in case and underscores.
    """

    sim_plugin: LoadedPlugin
    name: str
    tag: Tag
    meant: str | None
    same: bool

    @property
    def moved(self) -> bool:
        """Whether the value belongs outside of the plugin now."""
        return self.meant is not None and " " in self.meant

    @property
    def shown(self) -> str:
        """The setting that was meant, as a message shows it."""
        meant = self.meant or ""
        if not meant.startswith("ros/"):
            return f"<{meant}>" if meant in self.sim_plugin.children else meant
        inner, text = meant.removeprefix("ros/"), self.tag.text
        if inner == "remapping":
            text = f"{'odom' if 'odom' in self.name.lower() else 'cmd_vel'}:={text}"
        return f"<ros><{inner}>{text}</{inner}></ros>"

    @property
    def harmless(self) -> bool:
        """Whether nothing is lost: the value belongs outside of the plugin, or is the plugin's default."""
        child = self.sim_plugin.children.get(self.meant or "")
        if self.moved or child is None or child.name == "ros/remapping":
            return self.moved or self.tag.text.strip("/") in ("cmd_vel", "odom")
        value = number(self.tag.text)
        return self.tag.text == str(child.default) or (value is not None and value == child.default)


def unread_settings(project: Project) -> Iterator[Unread]:
    """Yield the settings that known plugins do not read."""
    for sim_plugin in loaded_plugins(project):
        children = sim_plugin.children if sim_plugin.known else {}
        if not children:
            continue
        read = {*children, *(alias for child in children.values() for alias in child.aliases)}
        given = {name for name, _ in sim_plugin.settings()}
        for name, tag in sim_plugin.settings():
            if name not in read and is_known(name) and ":" not in name:
                meant, same = _meant(name, children)
                yield Unread(sim_plugin, name, tag, None if meant in given else meant, same)


def _meant(name: str, children: dict[str, PluginChild]) -> tuple[str | None, bool]:
    """The setting that was probably meant, and whether both differ only in case and underscores."""
    by_folded = {folded(known): known for known in children}
    key = folded(name.removeprefix("ros/"))
    same = by_folded.get(key) or by_folded.get(f"ros/{key}")
    if same:
        return same, True
    for new_name in BECAME.get(key, ()):
        if new_name in children or (" " in new_name and "ros/namespace" in children):
            return new_name, False
    return next((known for other, known in by_folded.items() if is_slip(key, other)), None), False


def is_written_empty(tag: Tag) -> bool:
    """Return whether an element is empty in the source itself, and not because of an empty argument."""
    return not tag.text and tag.at.content.start == tag.at.start


def default_joints(project: Project, sim_plugin: LoadedPlugin) -> Iterator[tuple[str, str]]:
    """Yield the missing settings of a plugin that have a joint as their default, with that joint."""
    if not sim_plugin.moves_joints or not is_all_there(project, sim_plugin.plugin.tag):
        return
    misspelt = {unread.meant for unread in unread_settings(project) if unread.sim_plugin.plugin is sim_plugin.plugin}
    for name, child in sim_plugin.children.items():
        optional = child.names != "joint" or not isinstance(child.default, str) or name == "steering_wheel_joint"
        if not optional and sim_plugin.setting(name) is None and name not in misspelt:
            yield name, str(child.default)


def wheel_measures(sim_plugin: LoadedPlugin) -> Iterator[tuple[str, float]]:
    """Yield the settings for the size and separation of a drive's wheels, with their defaults in m."""
    for name, child in sim_plugin.children.items():
        if isinstance(child.default, float) and folded(name).endswith(_MEASURES):
            yield name, child.default


_MEASURES = ("wheelseparation", "wheeldiameter", "wheelradius", "wheelbase")


# -- controller files -----------------------------------------------------------------------------------------------


def controllers_files(project: Project) -> Iterator[tuple[LoadedPlugin, Tag, FileReference]]:
    """Yield the controller files that the plugins name, each after its plugin and element."""
    references = project.controllers.references if project.controllers else ()
    by_place = {(reference.at.source.path, reference.at.start): reference for reference in references}
    for sim_plugin in control_plugins(project):
        for tag in sim_plugin.plugin.tag.named("parameters"):
            at = tag.at.content
            reference = by_place.get((at.source.path, at.start))
            if reference is not None and reference.text == tag.text:
                yield sim_plugin, tag, reference
