"""UC139."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, replaced, robot_in
from urdfctl.rules.urdf.numbers import Numbers, fault_of, is_subnormal, mended, refusing


@rule(
    "UC139",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/link.cpp: 'Inertial: mass [...] is not a float', "
    "'Could not parse visual element for Link [...]'",
    bad={
        "robot.urdf": """
            <link name="tool">
              <inertial>
                <mass value="«1,5»"/>
                <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
              </inertial>
            </link>
            <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="tool">
              <inertial>
                <mass value="1.5"/>
                <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
              </inertial>
            </link>
            <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
        """,
    },
)
def link_number_malformed(project: Project) -> Iterator[Finding]:
    """What a link gives as a number or vector is not read as one.

    urdfdom prints an error and drops the <inertial>, <visual> or <collision>, and what follows in the link, but goes on:
    first the inertial is read, then the visuals, then the collisions. It reads finite decimals without units or spaces
    behind them, and vectors of three with spaces, not tabs or commas, between.
    """
    robot = robot_in(project)
    if robot is None:
        return
    numbers = Numbers(robot)
    for link in robot.links:
        for field, part in numbers.of_link(link):
            what = f"{field.label} of {label('link', link.name)}"
            at = field.element.at
            if set(refusing(field)) & set(project.distros):
                better = mended(field)
                fix = replaced(at[field.attribute], field.text, better[0], safe=better[1]) if better else None
                message = f"{what} is '{field.shown}': it {fault_of(field)}; the <{part}> is dropped"
                yield Finding(at[field.attribute], message, fix=fix)
            elif is_subnormal(field) and project.may_be_simulated:
                message = f"{what} is '{field.shown}': it is smaller than 2.2e-308, which Gazebo refuses; write 0"
                yield Finding(at[field.attribute], message)
