"""UC155."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import attribute_respelt, robot_in
from urdfctl.rules.urdf.grammar import ATTRIBUTES, read_tags
from urdfctl.suggest import nearest


@rule(
    "UC155",
    severity=Severity.WARNING,
    authority='urdfdom urdf_parser: Attribute("...") by exact names; unknown attributes are ignored without a word',
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
    """An attribute is spelt nearly like one that the element lacks.

    urdfdom ignores what it does not know, so nobody tells of the slip: where it may, it takes the default.
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
