"""UC139."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, replaced, robot_in
from urdfctl.rules.urdf.numbers import Numbers, corrected, fault_of, is_subnormal, refusing
from urdfctl.rules.written import at_value


@rule(
    "UC139",
    severity=Severity.WARNING,
    runtime="warns",
    authority="urdfdom urdf_parser/src/link.cpp: 'Inertial: mass [...] is not a float', "
    "'Could not parse visual element for Link [...]'",
    bad=[
        {
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
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial>
                    <origin xyz="«0 0»" rpy="«0 0 z»"/>
                    <mass value="«1 kg»"/>
                    <inertia ixx="«a»" ixy="«b»" ixz="«c»" iyy="«d»" iyz="«e»" izz="«f»"/>
                  </inertial>
                  <visual>
                    <origin xyz="«0,0,0»"/>
                    <geometry><box size="«1 1»"/></geometry>
                  </visual>
                  <visual><geometry><cylinder length="«1m»" radius="«0,1»"/></geometry></visual>
                  <collision><geometry><sphere radius="«small»"/></geometry></collision>
                  <collision><geometry><mesh filename="file:///tool.stl" scale="«1 1»"/></geometry></collision>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "options": "--distro=jazzy --simulator=gz",
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="«1e-320»" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
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
    ],
)
def link_number_malformed(project: Project) -> Iterator[Finding]:
    """Malformed number or vector in a link.

    urdfdom prints an error, drops the <inertial>, <visual> or <collision> and everything after it in the link, and
    continues. It reads the inertial first, then the visuals, then the collisions. A number is a finite decimal without
    a unit or trailing space. A vector is three numbers separated by spaces, not tabs or commas.
    """
    robot = robot_in(project)
    if robot is None:
        return
    numbers = Numbers(robot)
    for link in robot.links:
        for field, part in numbers.of_link(link):
            field_label = f"{field.label} of {label('link', link.name)}"
            at = field.element.at
            if set(refusing(field)) & set(project.distros):
                correction = corrected(field)
                written = project.origin(at[field.attribute])
                fix = replaced(written, field.text, correction[0], safe=correction[1]) if correction else None
                message = f"{field_label} is '{field.shown}', so the <{part}> is dropped: {fault_of(field)}"
                yield at_value(project, at[field.attribute], message, fix=fix)
            elif is_subnormal(field) and project.may_be_simulated:
                message = f"{field_label} is '{field.shown}': Gazebo rejects numbers below 2.2e-308; write 0"
                yield Finding(at[field.attribute], message)
