"""UC322."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, component, components, is_positive_integer


@rule(
    "UC322",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="ros2_control hardware_interface/src/component_parser.cpp: 'Could not parse thread_priority tag in "
    '"ros2_control". Got "0", but expected a non-zero positive integer.\'',
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="true" thread_priority="«0»">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="true" thread_priority="50">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def thread_priority_malformed(project: Project) -> Iterator[Finding]:
    """Thread priority of a component is not a positive integer.

    Since jazzy, the controller manager rejects the description. If the component is not asynchronous, the attribute is
    ignored.
    """
    for control in components(project):
        text = control.tag.attributes.get("thread_priority")
        if text is None or not is_known(text, control.tag.attributes.get("is_async")) or is_positive_integer(text):
            continue
        message = f"'thread_priority' of {component(control)} must be a positive integer, not '{text}'"
        if control.tag.attributes.get("is_async", "").strip().lower() == "true":
            yield Finding(control.at["thread_priority"], message, severity=severity_where(project, JAZZY))
        else:
            message += '; it is read only with is_async="true"'
            yield Finding(control.at["thread_priority"], message, severity=Severity.WARNING)
