"""UC353."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.distros import in_words as in_distros
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.ros2_control.common import component, components, folded, mended
from urdfctl.suggest import is_slip

_CORE = ("mock_components", "fake_components")
"""Packages that come with ros2_control."""
_WHOLE = (*_CORE, "gz_ros2_control", "ign_ros2_control", "gazebo_ros2_control")
"""Packages all of whose plugins are in the catalogue."""


@rule(
    "UC353",
    severity=Severity.ERROR,
    distros=ROS2,
    authority='pluginlib class_loader: "According to the loaded plugin descriptions the class '
    "mock_component/GenericSystem with base class type hardware_interface::SystemInterface does not "
    'exist."',
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware>«<plugin>»mock_component/GenericSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
)
def hardware_plugin_unknown(project: Project) -> Iterator[Finding]:
    """A component's plugin does not exist in this distro, or is spelt nearly like one that does.

    The component is not loaded, and the description refused. Where a distro has no release of the plugin it may be
    built from its source; a name that is like none that is known may be one of your own.
    """
    for control in components(project):
        for hardware in control.hardware[-1:]:
            for plugin in hardware.plugins[:1]:
                name = plugin.past_comments
                fault = _fault(project, name, component(control)) if name and is_known(name) else None
                if fault is not None:
                    meant, message, severity = fault
                    fix = mended(plugin, meant) if meant else None
                    yield Finding(plugin.at, message, fix=fix, severity=severity)


Fault = tuple[str | None, str, Severity]


def _fault(project: Project, name: str, owner: str) -> Fault | None:
    """What is most likely meant, what is wrong, and how bad it is; None where nothing is known to be."""
    distros = [distro for distro in project.distros if distro in ROS2]
    having = {distro: found for distro in ROS2 if (found := project.catalog.hardware(name, distro))}
    if not having:
        return _slip(project, name, owner)
    if having.keys() & set(distros):
        return None
    meant = project.catalog.hardware_replacement(name, distros[-1])
    hint = f"; use '{meant}'" if meant else ""
    # when real robots' drivers were released is known from their branches alone
    simulated = any(found.simulator for found in having.values())
    severity = Severity.ERROR if name.startswith(_CORE) else Severity.WARNING if simulated else Severity.INFO
    where = f"is not in {in_distros(distros)}, but in {in_distros(having)}"
    return meant, f"the plugin '{name}' of {owner} {where}{hint}", severity


def _slip(project: Project, name: str, owner: str) -> Fault | None:
    """The same for a name that no distro knows."""
    if "${" in name or "$(" in name:
        return None, f"the plugin of {owner} is '{name}', a xacro expression that nothing expands", Severity.ERROR
    known = {each for distro in project.distros for each in project.catalog.known_hardware(distro)}
    package = re.split("/|::", name)[0]
    of_package = sorted(each for each in known if re.split("/|::", each)[0] == package) if package in _WHOLE else []
    meant = {folded(each): each for each in known}.get(folded(name)) or _of_whole(name, known)
    sure = meant is not None or name.startswith(_CORE)
    meant = meant or next((each for each in sorted(known) if is_slip(name, each)), None)
    sure = sure or (meant is not None and meant.startswith(_WHOLE))
    meant = meant or (of_package[0] if of_package else None)
    if meant is None:
        return None
    severity = Severity.ERROR if sure else Severity.WARNING
    return meant, f"unknown plugin '{name}' of {owner}; did you mean '{meant}'?", severity


def _of_whole(name: str, known: Iterable[str]) -> str | None:
    """The plugin whose package a name leaves out."""
    return next((each for each in sorted(known) if each.startswith(_WHOLE) and each.endswith("/" + name)), None)
