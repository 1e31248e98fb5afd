"""UC134."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.common import lacking
from urdfctl.rules.urdf.numbers import MOMENTS


@rule(
    "UC134",
    severity=Severity.WARNING,
    runtime="drops",
    because="only Gazebo does, and the robot may not run there",
    authority="urdfdom urdf_parser/src/link.cpp parseInertial(): 'Inertial element must have a mass element', "
    "'Inertial: inertia element missing ixx attribute'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/>«<inertia ixx="0.01" iyy="0.01" izz="0.01"/>»</inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def inertial_incomplete(project: Project) -> Iterator[Finding]:
    """Incomplete <inertial>.

    An <inertial> needs a mass and all six moments of inertia. urdfdom prints an error, drops the <inertial> with the
    visuals and collisions of the link, and continues. Gazebo then drops the link.
    """
    robot = robot_in(project)
    for link in robot.links if robot else ():
        inertial = next(link.tag.named("inertial"), None)
        if inertial is None:
            continue
        for name, attributes in (("mass", ("value",)), ("inertia", MOMENTS)):
            element = next(inertial.named(name), None)
            if element is None:
                if not project.complete:
                    continue  # the part that could not be expanded may define it
                yield Finding(inertial.at, f"<inertial> of {label('link', link.name)} has no <{name}>; it is dropped")
            elif missing := lacking(element, attributes):
                message = f"<{name}> of {label('link', link.name)} has no {missing}; the whole <inertial> is dropped"
                yield Finding(element.at, message)
