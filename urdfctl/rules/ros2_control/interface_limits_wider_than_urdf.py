"""UC334."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import HardwareParameter, Interface, Limit, Number
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.ros2_control.common import called, is_number, parts

_ROUNDING = 5e-4
"""The tolerance in rad or m, for a rounded pi."""


@rule(
    "UC334",
    runtime="ignores",
    because="the narrower limit applies",
    severity=Severity.INFO,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp update_interface_limits(): the larger min "
    "and the smaller max of tag and URDF apply",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position">
                      «<param name="min">»-3.14</param>
                      <param name="max">1</param>
                    </command_interface>
                    <state_interface name="position"/>
                  </joint>
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
                    <command_interface name="position">
                      <param name="min">-0.5</param>
                      <param name="max">1</param>
                    </command_interface>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def interface_limits_wider_than_urdf(project: Project) -> Iterator[Finding]:
    """Limit of a command interface is wider than the limit in the URDF.

    Since jazzy, the narrower limit applies, and this one has no effect. In earlier distros, hardware that limits
    commands uses this one. The robot may then be commanded to where its joint cannot go.
    """
    robot = robot_in(project)
    joints = {joint.name: joint for joint in reversed(robot.joints)} if robot else {}
    for _, part in parts(project, "joint"):
        joint = joints.get((part.name or "").strip())
        if joint is None or joint.limit is None or joint.type not in ("revolute", "prismatic"):
            continue
        for interface in part.commands:
            beyond = list(_beyond(interface, joint.limit))
            if beyond:
                given = " and ".join(f"'{parameter.name}' {parameter.value}" for parameter, _ in beyond)
                in_urdf = " and ".join(dict.fromkeys(f"'{number.attribute}' {number.text}" for _, number in beyond))
                of = f"{called(interface)} of {label('joint', part.name)}"
                note = Note("the URDF's limit is set here", beyond[0][1].at)
                yield Finding(beyond[0][0].at, f"{of} has {given}, beyond the URDF's {in_urdf}", (note,), _fix(beyond))


def _fix(beyond: list[tuple[HardwareParameter, Number]]) -> Fix:
    """Replace the wider limits with those of the URDF."""
    texts = [
        f"-{number.text}" if parameter.name == "min" and number.attribute != "lower" else number.text
        for parameter, number in beyond
    ]
    title = " and ".join(f"'{parameter.name}' {text}" for (parameter, _), text in zip(beyond, texts, strict=True))
    spans = [(parameter.tag.at.content.span, parameter.value) for parameter, _ in beyond]
    is_literal = all(span.text == value for span, value in spans)
    edits = tuple(Edit(span, text) for (span, _), text in zip(spans, texts, strict=True))
    return Fix(f"write {title}, as in the URDF", edits if is_literal else ())


def _beyond(interface: Interface, limit: Limit) -> Iterator[tuple[HardwareParameter, Number]]:
    """The limits that are wider than in the URDF, each with the limit of the URDF."""
    velocity, effort = limit.velocity, limit.effort
    pairs = {"position": (limit.lower, limit.upper), "velocity": (velocity, velocity), "effort": (effort, effort)}
    name = (interface.name or "").strip()
    for bound, in_urdf in zip(("min", "max"), pairs.get(name, ()), strict=False):
        parameter = interface.parameter(bound)
        if parameter is None or in_urdf is None or not in_urdf.value or not is_number(parameter.value):
            continue
        limit_value = -abs(in_urdf.value) if bound == "min" and name != "position" else in_urdf.value
        given = float(parameter.value)
        if (given < limit_value - _ROUNDING) if bound == "min" else (given > limit_value + _ROUNDING):
            yield parameter, in_urdf
