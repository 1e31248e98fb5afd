"""UC334."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.parts import Number
from urdfctl.model.robot import Limit
from urdfctl.model.ros2_control import Interface, Parameter
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.ros2_control.common import called, is_number, parts

_ROUNDING = 5e-4
"""In rad or m: nobody writes pi in full."""


@rule(
    "UC334",
    severity=Severity.INFO,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp update_interface_limits(): the larger min "
    "and the smaller max of tag and URDF count",
    bad={
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
    good={
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
)
def interface_limits_wider_than_urdf(project: Project) -> Iterator[Finding]:
    """A command interface's limit goes beyond that of the URDF's joint.

    From jazzy on the narrower of the two counts, so this one says nothing. Before, hardware that limits commands at
    all takes the tag's: the robot may be sent where its joint cannot go.
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
                given = " and ".join(f"'{parameter.name}' of {parameter.value}" for parameter, _ in beyond)
                there = " and ".join(dict.fromkeys(f"'{number.attribute}' of {number.text}" for _, number in beyond))
                of = f"{called(interface)} of {label('joint', part.name)}"
                note = Note("the URDF's limit is here", beyond[0][1].at)
                yield Finding(beyond[0][0].at, f"{of} has {given}, beyond the URDF's {there}", (note,), _fix(beyond))


def _fix(beyond: list[tuple[Parameter, Number]]) -> Fix:
    """The URDF's own limits, in the places of all that go beyond."""
    right = [
        f"-{number.text}" if parameter.name == "min" and number.attribute != "lower" else number.text
        for parameter, number in beyond
    ]
    title = " and ".join(f"'{parameter.name}' {text}" for (parameter, _), text in zip(beyond, right, strict=True))
    spans = [(parameter.tag.at.content.span, parameter.value) for parameter, _ in beyond]
    is_literal = all(span.text == value for span, value in spans)
    edits = tuple(Edit(span, text) for (span, _), text in zip(spans, right, strict=True))
    return Fix(f"write {title}, as the URDF does", edits if is_literal else ())


def _beyond(interface: Interface, limit: Limit) -> Iterator[tuple[Parameter, Number]]:
    """The limits that go beyond the URDF's, each with the one there."""
    velocity, effort = limit.velocity, limit.effort
    pairs = {"position": (limit.lower, limit.upper), "velocity": (velocity, velocity), "effort": (effort, effort)}
    name = (interface.name or "").strip()
    for bound, written in zip(("min", "max"), pairs.get(name, ()), strict=False):
        parameter = interface.parameter(bound)
        if parameter is None or written is None or not written.value or not is_number(parameter.value):
            continue
        there = -abs(written.value) if bound == "min" and name != "position" else written.value
        given = float(parameter.value)
        if (given < there - _ROUNDING) if bound == "min" else (given > there + _ROUNDING):
            yield parameter, written
