"""UC167."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.degrees import are_limits_in_degrees, limit_meant, limits_in_words, written_in_radians
from urdfctl.model.robot import Limit
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.written import at_value

_WRIST = """
    <link name="tool">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="wrist" type="revolute">
      <parent link="fore"/><child link="tool"/><axis xyz="0 0 1"/>
      <limit %s effort="10" velocity="2"/>
    </joint>
"""


@rule(
    "UC167",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="REP 103: angles are in radians; urdf: <limit> lower and upper are in radians",
    bad=[
        {"robot.urdf": _WRIST % 'lower="«-126»" upper="126"'},
        {"robot.urdf": _WRIST % 'lower="«0»" upper="180.0"'},
    ],
    good=[
        {"robot.urdf": _WRIST % 'lower="-2.2" upper="2.2"'},
        {"robot.urdf": _WRIST % 'lower="-18.8496" upper="18.8496"'},
    ],
)
def limit_in_degrees(project: Project) -> Iterator[Finding]:
    """Joint limits that are most likely in degrees.

    The joint is taken to turn several times around: planners and commands go through its mechanical end. A joint that
    really turns several times, like a winch, has limits like these: suppress the finding there. The smoke test finds the
    same as UC978.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        limit = joint.limit
        numbers = [number for number in (limit.lower, limit.upper) if number] if limit else []
        values = [number.value for number in numbers if number.value is not None]
        if limit is None or len(values) < len(numbers) or not are_limits_in_degrees(joint.type, values):
            continue
        low, high = values[0], values[-1]
        message = limits_in_words(joint.name or "", low, high)
        yield at_value(project, numbers[0].at, message, fix=_in_radians(project, limit))


def _in_radians(project: Project, limit: Limit) -> Fix | None:
    """Write the limits in rad where they are written as numbers; nothing where one of them is calculated."""
    edits = []
    for number in (limit.lower, limit.upper):
        if number is None or number.value is None or limit_meant(number.value) == number.value:
            continue
        at = project.origin(number.at)
        if at.span.text.strip() != number.text.strip():
            return None
        edits.append(Edit(at.span, written_in_radians(number.text.strip(), in_xacro=at.source.is_xacro)))
    return Fix("write the limits in radians", tuple(edits)) if edits else None
