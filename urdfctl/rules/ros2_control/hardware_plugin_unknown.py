"""UC353."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.distros import in_words as in_distros
from urdfctl.names import is_slip
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.ros2_control.common import component, components, corrected, folded
from urdfctl.rules.ros2_control.kinds import other_kind

_CORE = ("mock_components", "fake_components")
"""Packages that are part of ros2_control."""
_WHOLE = (*_CORE, "gz_ros2_control", "ign_ros2_control", "gazebo_ros2_control")
"""Packages whose plugins are all in the catalogue."""


@rule(
    "UC353",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='pluginlib class_loader: "According to the loaded plugin descriptions the class '
    "mock_component/GenericSystem with base class type hardware_interface::SystemInterface does not "
    'exist."',
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»mock_component/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»fake_component/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gz_ros2_control/GazeboSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»mock_components/System</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gazebo_ros2_control/System</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»ign_ros2_control/System</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»fake_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gazebo_ros2_control/GazeboSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»${plugin}</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»joint_trajectory_controller/JointTrajectoryController</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»transmission_interface/SimpleTransmission</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gazebo_ros_control/DefaultRobotHWSim</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gz_ros2_control-system</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»libarm_driver.so</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_driver/ArmSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def hardware_plugin_unknown(project: Project) -> Iterator[Finding]:
    """Hardware plugin is misspelt or not available in this distro.

    The component is not loaded, and the description is rejected. A plugin without a release for a distro may still be
    built from source. A name that resembles no known plugin may be your own, and is not reported.
    """
    for control in components(project):
        for hardware in control.hardware[-1:]:
            for plugin in hardware.plugins[:1]:
                name = plugin.past_comments
                fault = _fault(project, name, component(control)) if name and is_known(name) else None
                if fault is not None:
                    meant, message, severity = fault
                    fix = corrected(plugin, meant)._replace(safe=is_slip(name, meant)) if meant else None
                    yield Finding(plugin.at, message, fix=fix, severity=severity)


Fault = tuple[str | None, str, Severity]


def _fault(project: Project, name: str, owner: str) -> Fault | None:
    """The most likely plugin, the message and the severity; None if the plugin may be right."""
    distros = [distro for distro in project.distros if distro in ROS2]
    by_distro = {distro: known for distro in ROS2 if (known := project.catalog.hardware(name, distro))}
    if name.strip() in project.own.hardware:
        return None
    if not by_distro:
        return _slip(project, name, owner)
    if by_distro.keys() & set(distros):
        return None
    meant = project.catalog.hardware_replacement(name, distros[-1])
    hint = f"; use '{meant}'" if meant else ""
    # releases of drivers for real robots are known only from their branches
    simulated = any(known.simulator for known in by_distro.values())
    severity = Severity.ERROR if name.startswith(_CORE) else Severity.WARNING if simulated else Severity.INFO
    where = f"is not available in {in_distros(distros)}, only in {in_distros(by_distro)}"
    return meant, f"plugin '{name}' of {owner} {where}{hint}", severity


def _slip(project: Project, name: str, owner: str) -> Fault | None:
    """The same for a name that is in no distro."""
    if "${" in name or "$(" in name:
        return None, f"plugin of {owner} is the xacro expression '{name}', which is not expanded", Severity.ERROR
    other = other_kind(project, name)
    if other is not None:
        return None, f"{owner} names '{name}', which is {other}, not hardware", Severity.ERROR
    known = {each for distro in project.distros for each in project.catalog.known_hardware(distro)}
    own = next((each for each in project.own.hardware if is_slip(name, each)), None)
    if own is not None:
        return own, f"{owner} names unknown plugin '{name}'; did you mean '{own}'?", Severity.ERROR
    package = re.split("/|::", name)[0]
    of_package = sorted(each for each in known if re.split("/|::", each)[0] == package) if package in _WHOLE else []
    meant = {folded(each): each for each in known}.get(folded(name)) or _of_whole(name, known)
    sure = meant is not None or name.startswith(_CORE)
    meant = meant or next((each for each in sorted(known) if is_slip(name, each)), None)
    sure = sure or bool(of_package) or (meant is not None and meant.startswith(_WHOLE))
    meant = meant or (of_package[0] if of_package else None)
    meant = meant or _of_other_package(project, name)
    if meant is None:
        return None
    severity = Severity.ERROR if sure else Severity.WARNING
    return meant, f"{owner} names unknown plugin '{name}'; did you mean '{meant}'?", severity


def _of_other_package(project: Project, name: str) -> str | None:
    """The workspace's class of the same name, if the package that it is looked for in is no dependency."""
    package, _, last = name.partition("/")
    around = project.launch.package if project.launch else None
    if not last or around is None or package == around.name or around.reaches(package):
        return None
    return next((each for each in project.own.hardware if each.partition("/")[2] == last), None)


def _of_whole(name: str, known: Iterable[str]) -> str | None:
    """The plugin that a name means without its package."""
    return next((each for each in sorted(known) if each.startswith(_WHOLE) and each.endswith("/" + name)), None)
