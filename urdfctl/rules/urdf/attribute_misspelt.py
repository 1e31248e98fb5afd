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
    bad={
        "robot.urdf": """
            <link name="tool"/>
            <joint name="flange" type="fixed">
              <parent link="fore"/><child link="tool"/>
              <origin xzy="«0 0 0.1»"/>
            </joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="tool"/>
            <joint name="flange" type="fixed">
              <parent link="fore"/><child link="tool"/>
              <origin xyz="0 0 0.1"/>
            </joint>
        """,
    },
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
