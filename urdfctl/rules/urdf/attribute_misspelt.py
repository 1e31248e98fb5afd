"""UC155."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import attribute_respelt, robot_in
from urdfctl.rules.urdf.grammar import ATTRIBUTES, read_tags


@rule(
    "UC155",
    severity=Severity.WARNING,
    runtime="ignores",
    authority='urdfdom urdf_parser: Attribute("...") by exact name; unknown attributes are silently ignored',
    bad=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed">
                  <parent link="fore"/><child link="tool"/>
                  <origin xzy="«0 0 0.1»"/>
                </joint>
            """,
        },
        {
            "robot.urdf": """
                <link nmae="«tool»">
                  <inertial>
                    <origin xzy="«0 0 0»" ryp="«0 0 0»"/>
                    <mass vlaue="«1»"/>
                    <inertia iXx="«0.01»" iXy="«0»" iXz="«0»" iYy="«0.01»" iYz="«0»" iZz="«0.01»"/>
                  </inertial>
                  <visual>
                    <geometry><box szie="«1 1 1»"/></geometry>
                    <material nmae="«grey»"><color rgab="«0.5 0.5 0.5 1»"/><texture filname="«grey.png»"/></material>
                  </visual>
                  <visual><geometry><cylinder lenght="«1»" raduis="«1»"/></geometry></visual>
                  <visual><geometry><sphere raduis="«1»"/></geometry></visual>
                  <visual><geometry><mesh fielname="«tool.stl»" scael="«1 1 1»"/></geometry></visual>
                </link>
                <joint nmae="«wrist»" tpye="«revolute»">
                  <parent lnik="«fore»"/>
                  <child lnik="«tool»"/>
                  <axis xzy="«0 0 1»"/>
                  <limit lowr="«-1»" uper="«1»" efort="«10»" velocty="«2»"/>
                  <safety_controller k_velocty="«1»" k_positon="«1»" soft_lower_limt="«-1»" soft_uper_limit="«1»"/>
                  <calibration risng="«0»" faling="«0»" reference_positon="«0»"/>
                  <mimic jiont="«elbow»" multplier="«1»" ofset="«0»"/>
                  <dynamics dampng="«1»" fricton="«1»"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed">
                  <parent link="fore"/><child link="tool"/>
                  <origin xyz="0 0 0.1"/>
                </joint>
            """,
        },
    ],
)
def attribute_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt attribute.

    urdfdom silently ignores unknown attributes. It uses the default value if the attribute has one.
    """
    robot = robot_in(project)
    for tag, _, owner in read_tags(robot) if robot else ():
        known = ATTRIBUTES.get(tag.name, ())
        for name in tag.attributes if known else ():
            if name in known or ":" in name:
                continue
            lacking = [other for other in known if other not in tag.attributes]
            same_letters = (other for other in lacking if sorted(other) == sorted(name.lower()))
            meant = next(same_letters, None) or nearest(name, lacking)
            if meant:
                message = f"attribute '{name}' of <{tag.name}> of {owner} is ignored; did you mean '{meant}'?"
                yield Finding(tag.at[name], message, fix=attribute_respelt(tag, name, meant))
