"""UC368."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.project import OwnHardware
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.ros2_control.common import components
from urdfctl.rules.ros2_control.facts import TYPES

_CATEGORY = "hardware_interface"
_ROBOT = """
                <ros2_control name="arm" type="%s">
                  <hardware>%s</hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
"""
_PLUGIN = "<plugin>arm/ArmSystem</plugin>"
_MARKED = _PLUGIN.replace("<plugin>", "«<plugin>»")
_DESCRIPTION = """
                <library path="arm">
                  <class name="arm/ArmSystem" type="arm::ArmSystem" base_class_type="hardware_interface::SystemInterface"/>
                </library>
"""
_EXPORT = "pluginlib_export_plugin_description_file(%s arm.xml)"
_SOURCE = '#include "arm.hpp"\nPLUGINLIB_EXPORT_CLASS(%s, hardware_interface::%s)\n'


def _files(
    plugin: str = _MARKED,
    *,
    export: str = _EXPORT % _CATEGORY,
    kind: str = "arm::ArmSystem",
    base: str = "SystemInterface",
    component: str = "system",
) -> dict[str, str]:
    build = "<export><build_type>ament_cmake</build_type></export>"
    return {
        "robot.urdf": _ROBOT % (component, plugin),
        "package.xml": f'<package format="3"><name>arm</name><depend>hardware_interface</depend>{build}</package>',
        "CMakeLists.txt": f"project(arm)\nfind_package(ament_cmake REQUIRED)\n{export}\nament_package()\n",
        "arm.xml": _DESCRIPTION,
        "src/arm.cpp": _SOURCE % (kind, base),
    }


@rule(
    "UC368",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    options=["--distro=jazzy"],
    authority="pluginlib class_loader_imp.hpp getPluginXmlPaths(): the resources 'hardware_interface__pluginlib__plugin', which "
    "pluginlib_export_plugin_description_file() registers; class_loader multi_library_class_loader.hpp: 'Could not create object of "
    "class type X as no factory exists for it.'",
    bad=[
        _files(export=""),
        _files(export=_EXPORT % "arm"),
        _files(kind="arm::ArmHardware"),
        _files(base="ActuatorInterface"),
        _files(component="actuator"),
    ],
    good=[
        _files(_PLUGIN),
        _files(_PLUGIN, export="include(cmake/plugins.cmake)"),
        {
            **_files(_PLUGIN, export=_EXPORT % "gz_ros2_control", base="GazeboSimSystemInterface"),
            "arm.xml": _DESCRIPTION.replace(
                "hardware_interface::SystemInterface", "gz_ros2_control::GazeboSimSystemInterface"
            ),
        },
    ],
)
def hardware_class_not_exported(project: Project) -> Iterator[Finding]:
    """Own hardware class is described, but pluginlib does not find or cannot create it.

    The plugin description, its export in CMakeLists.txt, PLUGINLIB_EXPORT_CLASS in the sources and the type of the
    component must agree. Hardware of a simulator is exported for the package of the simulator's base class. If one
    differs, the controller manager rejects the description, and nothing is controlled.
    """
    for control in components(project):
        for hardware in control.hardware[-1:]:
            for plugin in hardware.plugins[:1]:
                name = plugin.past_comments.strip()
                own = project.own.classes.get(name)
                fault = _fault(name, own, (control.type or "").strip()) if own is not None else None
                if fault is not None:
                    message, title = fault
                    yield Finding(plugin.at, message, fix=Fix(title))


def _fault(name: str, own: OwnHardware, kind: str) -> tuple[str, str] | None:
    """What is wrong with the export of a class, and what to write; None if nothing is, as far as is known."""
    category = own.base.partition("::")[0]
    export = f"pluginlib_export_plugin_description_file({category} {own.description})"
    where = f"CMakeLists.txt of package '{own.package}'"
    if own.category is not None and own.category != category:
        what = (
            f"exports '{own.description}' for '{own.category}'"
            if own.category
            else f"does not export '{own.description}'"
        )
        return f"pluginlib does not find '{name}': {where} {what}", f"write {export} there"
    base = own.base.rpartition("::")[2]
    expected = f"{kind.capitalize()}Interface"
    if kind in TYPES and category == _CATEGORY and base != expected:
        meant = base.removesuffix("Interface").lower()
        return f"'{name}' is a {base}, which a component of type '{kind}' cannot load", f'write type="{meant}"'
    bases = [
        one.rpartition("::")[2] for built, one in own.built if built.removeprefix("::") == own.kind.removeprefix("::")
    ]
    macro = f"PLUGINLIB_EXPORT_CLASS({own.kind}, {own.base})"
    if own.built and not bases:
        others = " and ".join(f"'{built}'" for built, _ in own.built[:2])
        return (
            f"'{name}' is class '{own.kind}', but the sources of package '{own.package}' export {others}",
            f"write {macro}",
        )
    if bases and base not in bases:
        return (
            f"'{own.description}' says that '{own.kind}' is a {base}, but the sources export it as {bases[0]}",
            f"write {macro}",
        )
    return None
