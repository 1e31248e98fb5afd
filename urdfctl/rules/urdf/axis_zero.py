"""UC126."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import sure_simulator
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in
from urdfctl.rules.urdf.numbers import VECTOR, Field
from urdfctl.rules.written import where_written


@rule(
    "UC126",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="sdformat src/JointAxis.cc: 'The norm of the xyz vector cannot be zero'; urdfdom accepts it",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous">
                  <parent link="fore"/><child link="tool"/>
                  <axis xyz="«0 0 0»"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous">
                  <parent link="fore"/><child link="tool"/>
                  <axis xyz="0 0 1"/>
                </joint>
            """,
        },
    ],
)
def axis_zero(project: Project) -> Iterator[Finding]:
    """Joint axis is 0 0 0.

    urdfdom accepts it, and reads an <axis> without `xyz` as 0 0 0. Without <axis>, the default is 1 0 0. The joint has
    no direction and does not move. gz rejects the robot, which is an error if the robot runs in gz.
    """
    robot = robot_in(project)
    severity = Severity.ERROR if sure_simulator(project) == "gz" else None
    for joint in robot.joints if robot else ():
        if not joint.moves or joint.type == "floating":
            continue
        axis = next(joint.tag.named("axis"), None)
        if axis is None:
            continue
        text = axis.attributes.get("xyz")
        if text is None:
            message = f"<axis> of {label('joint', joint.name)} has no 'xyz' and is read as 0 0 0; add a direction"
            yield Finding(axis.at, message, severity=severity)
        elif is_known(text) and Field(axis, "xyz", text, VECTOR).values == [0.0, 0.0, 0.0]:
            message = f"<axis> of {label('joint', joint.name)} is 0 0 0; give it a direction"
            yield Finding(where_written(axis.at["xyz"], text, None).at, message, severity=severity)
