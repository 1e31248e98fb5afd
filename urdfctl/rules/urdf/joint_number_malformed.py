"""UC127."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, replaced, robot_in, severity_where
from urdfctl.rules.urdf.numbers import Numbers, fault_of, is_subnormal, mended, refusing


@rule(
    "UC127",
    severity=Severity.ERROR,
    authority="urdfdom urdf_parser/src/joint.cpp: 'lower value (...) is not a valid float'; "
    "urdfdom_headers urdf_model/pose.h: 'Parser found <n> elements but 3 expected while parsing vector [...]'",
    bad={
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
    good={
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
)
def joint_number_malformed(project: Project) -> Iterator[Finding]:
    """What a joint gives as a number or vector is not read as one.

    urdfdom gives no model for the whole robot. It reads finite decimals without units or spaces behind them, and vectors
    of three with spaces, not tabs or commas, between. Up to lunar it took inf and nan, and no space before a number.
    """
    robot = robot_in(project)
    if robot is None:
        return
    numbers = Numbers(robot)
    for joint in robot.joints:
        for field in numbers.of_joint(joint):
            what = f"{field.label} of {label('joint', joint.name)}"
            at = field.element.at
            refused = refusing(field)
            if set(refused) & set(project.distros):
                better = mended(field)
                fix = replaced(at[field.attribute], field.text, better[0], safe=better[1]) if better else None
                message = f"{what} is '{field.shown}': it {fault_of(field)}"
                yield Finding(at[field.attribute], message, fix=fix, severity=severity_where(project, refused))
            elif is_subnormal(field) and project.may_be_simulated:
                message = f"{what} is '{field.shown}': it is smaller than 2.2e-308, which Gazebo refuses; write 0"
                yield Finding(at[field.attribute], message, severity=Severity.WARNING)
