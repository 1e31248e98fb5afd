"""UC306."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Hardware, Ros2Control
from urdfctl.names import nearest
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_conditional
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC306",
    runtime="crashes",
    severity=Severity.ERROR,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "Missing <plugin> tag of <hardware> '
    'element in your URDF.", "text not specified in the hardware plugin tag"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  «<hardware>»
                    <class_type>mock_components/GenericSystem</class_type>
                  </hardware>
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
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def hardware_without_plugin(project: Project) -> Iterator[Finding]:
    """`<hardware>` without a plugin.

    The controller manager rejects the description. In foxy, galactic and iron it crashes if `<plugin>` is missing.
    """
    for control in components(project):
        hardware = control.hardware[-1] if control.hardware else None
        if hardware is None or hardware.plugin:
            continue
        if hardware.plugins:
            yield Finding(
                hardware.plugins[0].at, f"<plugin> of {component(control)} is empty; it must name the class to load"
            )
        elif is_all_there(project, hardware.tag):
            yield from _without(control, hardware)


def _without(control: Ros2Control, hardware: Hardware) -> Iterator[Finding]:
    what = f"<hardware> of {component(control)} has no <plugin>"
    if is_conditional(hardware.at):
        yield Finding(hardware.at, f"{what} with these arguments", severity=Severity.INFO)
        return
    for other in hardware.others:
        if "class" in other.name.lower() or nearest(other.name, ("plugin",)):
            message = f"{what}; <{other.name}> is ignored"
            yield Finding(hardware.at, message, fix=Fix(f"write <plugin>{other.text}</plugin> instead"))
            return
    yield Finding(hardware.at, f"{what}; add one that names the class to load")
