"""UC127."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, replaced, robot_in, severity_where
from urdfctl.rules.urdf.numbers import Numbers, corrected, fault_of, is_subnormal, refusing
from urdfctl.rules.written import at_value


@rule(
    "UC127",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp: 'lower value (...) is not a valid float'; "
    "urdfdom_headers urdf_model/pose.h: 'Parser found <n> elements but 3 expected while parsing vector [...]'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="«-90deg»" upper="1" effort="10" velocity="2"/>
                </joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>

                </link>
                <joint name="wrist" type="revolute">
                  <origin xyz="«0 0»" rpy="«0,0,0»"/>
                  <parent link="fore"/><child link="tool"/>
                  <axis xyz="«0 0 z»"/>
                  <limit lower="« -1»" upper="«1 »" effort="«10 Nm»" velocity="«2,5»"/>
                  <safety_controller k_velocity="«fast»" k_position="«»" soft_lower_limit="«1e999»" soft_upper_limit="«nan»"/>
                  <calibration rising="«one»" falling="«two»"/>
                  <mimic joint="elbow" multiplier="«x»" offset="«0x1»"/>
                  <dynamics damping="«${d}»" friction="«low»"/>
                </joint>
            """,
        },
        {
            "options": "--distro=kinetic",
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>

                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="« -1»" upper="1" effort="10" velocity="2"/>
                </joint>
            """,
        },
        {
            "options": "--distro=jazzy --simulator=gz",
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>

                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1" upper="1" effort="«1e-320»" velocity="2"/>
                </joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>

                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/><axis xyz="«0	0 1»"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1.57" upper="1" effort="10" velocity="2"/>
                </joint>
            """,
        },
        {
            "options": "--distro=kinetic",
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>

                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1" upper="inf" effort="10" velocity="2"/>
                </joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>

                </link>
                <joint name="wrist" type="fixed">
                  <parent link="fore"/><child link="tool"/>
                  <axis xyz="none"/>
                </joint>
            """,
        },
    ],
)
def joint_number_malformed(project: Project) -> Iterator[Finding]:
    """Malformed number or vector in a joint.

    urdfdom rejects the whole robot. A number is a finite decimal without a unit or trailing space. A vector is three
    numbers separated by spaces, not tabs or commas. Up to lunar, urdfdom accepted inf and nan, but no leading space.
    """
    robot = robot_in(project)
    if robot is None:
        return
    numbers = Numbers(robot)
    for joint in robot.joints:
        for field in numbers.of_joint(joint):
            field_label = f"{field.label} of {label('joint', joint.name)}"
            at = field.element.at
            refused = refusing(field)
            if set(refused) & set(project.distros):
                correction = corrected(field)
                written = project.origin(at[field.attribute])
                fix = replaced(written, field.text, correction[0], safe=correction[1]) if correction else None
                message = f"{field_label} is '{field.shown}': {fault_of(field)}"
                severity = severity_where(project, refused)
                yield at_value(project, at[field.attribute], message, fix=fix, severity=severity)
            elif is_subnormal(field) and project.may_be_simulated:
                message = f"{field_label} is '{field.shown}': Gazebo rejects numbers below 2.2e-308; write 0"
                yield Finding(at[field.attribute], message, severity=Severity.WARNING)
