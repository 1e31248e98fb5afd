"""UC703."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, in_words
from urdfctl.model.ros2_control import Ros2Control
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.migration.common import severity_of_old
from urdfctl.rules.simulation.common import components


@rule(
    "UC703",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control doc/migration.rst: fake_components are mock_components, removed in jazzy; gz_ros2_control "
    "src/gz_system.cpp: 'The ign_ros2_control plugin got renamed to gz_ros2_control.'",
    options=["--distro=humble"],
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware>«<plugin>»fake_components/GenericSystem</plugin></hardware>
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
def hardware_deprecated(project: Project) -> Iterator[Finding]:
    """A component's hardware has another name by now.

    This distro still loads it under the old one, and a later one will not. Where no distro is named, this is told where
    the new name is right in all that are maintained.
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
        content = text.at.content.span
        edits = (
            (Edit(content, right.type), *_of_parameters(project, control, right.type)) if content.text == name else ()
        )
        notes = (Note(f"the old name is gone from all but {in_words(there)}"),)
        message = f"'{name}' is the old name of '{right.type}'"
        yield Finding(text.at, message, notes, Fix(f"write '{right.type}'", edits), severity)


def _of_parameters(project: Project, control: Ros2Control, right: str) -> Iterator[Edit]:
    """The edits that give parameters the names that the new one reads them by."""
    found = [hardware for distro in project.distros if (hardware := project.catalog.hardware(right, distro))]
    known = found[-1].hardware_parameters or {} if found else {}
    for parameter in control.hardware[-1].parameters:
        now = known.get(parameter.name or "")
        at = parameter.at["name"]
        if now is not None and now.deprecated and now.replacement and at.span.text == parameter.name:
            yield Edit(at.span, now.replacement)
