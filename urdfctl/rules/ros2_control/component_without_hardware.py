"""UC305."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import written_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_conditional
from urdfctl.rules.insertions import inserted
from urdfctl.rules.ros2_control.common import component, components
from urdfctl.source.span import Place


@rule(
    "UC305",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp leaves the class empty; pluginlib: "the '
    'class with base class type hardware_interface::SystemInterface does not exist"',
    bad=[
        {
            "robot.urdf": """
                «<ros2_control name="arm" type="system">»
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
def component_without_hardware(project: Project) -> Iterator[Finding]:
    """Component without `<hardware>`.

    Nothing names the class that drives the component, so it cannot be loaded. The controller manager then has no
    hardware at all. If conditions choose the hardware, the given arguments select none.
    """
    for control in components(project):
        if control.hardware or not is_all_there(project, control.tag):
            continue
        if is_conditional(control.at):
            message = f"{component(control)} has no <hardware> with these arguments"
            yield Finding(control.at, message, severity=Severity.INFO)
        else:
            message = f"{component(control)} has no <hardware>; add one whose <plugin> names the class to load"
            yield Finding(control.at, message, fix=_fix(project, control.at))


def _fix(project: Project, at: Place) -> Fix | None:
    """The fix that adds the hardware of the simulator whose plugin the robot loads; None if it loads none."""
    hosts = [plugin.any for plugin in written_plugins(project) if plugin.any is not None and plugin.hosts_control]
    names = {host.default_hardware for host in hosts if host.default_hardware}
    if len(names) != 1:
        return None
    element = f"<hardware>\n      <plugin>{names.pop()}</plugin>\n    </hardware>"
    return Fix(
        f"add {''.join(line.strip() for line in element.splitlines())}",
        inserted(at, element),
        doubt="the robot may have other hardware",
    )
