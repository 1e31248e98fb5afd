"""UC703."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, in_words
from urdfctl.control.hardware.simulator_plugins import components
from urdfctl.model.robot import Ros2Control
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.migration.common import is_chosen, severity_of_old


@rule(
    "UC703",
    runtime="works",
    because="later distros do not load it",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control doc/migration.rst: fake_components are mock_components, removed in jazzy; gz_ros2_control "
    "src/gz_system.cpp: 'The ign_ros2_control plugin got renamed to gz_ros2_control.'",
    options=["--distro=humble"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»fake_components/GenericSystem</plugin></hardware>
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
    ],
)
def hardware_deprecated(project: Project) -> Iterator[Finding]:
    """Old name of a hardware plugin.

    This distro still loads the hardware under its old name, but later distros do not. If the distro is unknown, the
    rule reports a name only if all maintained distros have the new one. A file in which conditions choose between both
    names is right.
    """
    for control in components(project):
        name = control.plugin or ""
        known = {distro: project.catalog.hardware(name, distro) for distro in ROS2} if is_known(name) else {}
        there = {distro: hardware for distro, hardware in known.items() if hardware}
        if not there or not set(there) & set(project.distros):
            continue
        old_in = [distro for distro, hardware in known.items() if hardware is None or hardware.deprecated]
        severity = severity_of_old(project, old_in)
        right = list(there.values())[-1].replacement
        if severity is None or right is None or not any(hardware.deprecated for hardware in there.values()):
            continue
        text = control.hardware[-1].plugins[0]
        if is_chosen(text.at, right.type):
            continue
        content = text.at.content.span
        edits = (
            (Edit(content, right.type), *_of_parameters(project, control, right.type)) if content.text == name else ()
        )
        notes = (Note(f"the old name exists only in {in_words(there)}"),)
        message = f"hardware plugin '{name}' was renamed to '{right.type}'"
        yield Finding(text.at, message, notes, Fix(f"write '{right.type}'", edits), severity)


def _of_parameters(project: Project, control: Ros2Control, right: str) -> Iterator[Edit]:
    """Yield the edits that rename parameters to the names that the new plugin reads."""
    entries = [hardware for distro in project.distros if (hardware := project.catalog.hardware(right, distro))]
    known = entries[-1].hardware_parameters or {} if entries else {}
    for parameter in control.hardware[-1].parameters:
        now = known.get(parameter.name or "")
        at = parameter.at["name"]
        if now is not None and now.deprecated and now.replacement and at.span.text == parameter.name:
            yield Edit(at.span, now.replacement)
