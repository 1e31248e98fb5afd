"""UC321."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, component, components, leading_integer


@rule(
    "UC321",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="ros2_control hardware_interface/src/component_parser.cpp: 'Could not parse rw_rate tag in "
    '"ros2_control". Got "-1", but expected a positive integer.\'',
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" rw_rate="«100 Hz»">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" rw_rate="100">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def rw_rate_malformed(project: Project) -> Iterator[Finding]:
    """Read/write rate of a component is not an integer.

    Since jazzy, the controller manager rejects a value that does not start with an integer, is negative, or is greater
    than 2147483647. Otherwise it reads only the leading digits: 10.5 becomes 10, and 1e2 becomes 1.
    """
    for control in components(project):
        text = control.tag.attributes.get("rw_rate")
        if text is None or not is_known(text) or re.fullmatch(r"[0-9]{1,9}", text.strip()):
            continue
        at = control.at["rw_rate"]
        read = leading_integer(text)
        if read is None or not 0 <= read < 2**31:
            message = f"'rw_rate' of {component(control)} must be an integer in Hz, 0 or more, not '{text}'"
            yield Finding(at, message, severity=severity_where(project, JAZZY))
        elif text.strip() != str(read):
            message = f"'rw_rate' of {component(control)} is '{text}', which is read as {read}; use an integer in Hz"
            yield Finding(at, message, severity=Severity.WARNING)
