"""UC135."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import sure_simulator
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import label, whole_robot_in
from urdfctl.rules.urdf.bodies import LEAST_MASS, inertial_of, vanishing
from urdfctl.rules.written import where_written


@rule(
    "UC135",
    severity=Severity.WARNING,
    stage=StageDependsOn.LOST_JOINTS,
    runtime="drops",
    because="only Gazebo does, and the robot may not run there",
    authority="sdformat src/parser_urdf.cc CreateSDF(): 'a mass value of less than or equal to zero'; "
    "src/Link.cc: 'A link named ... has invalid inertia.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial>
                    <mass value="«0»"/>
                    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
                  </inertial>
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
def mass_not_positive(project: Project) -> Iterator[Finding]:
    """Negative mass, or moving link without mass.

    Gazebo drops a moving link without mass (below 1e-6 kg) and everything below it. It rejects a robot with a negative
    mass. This is an error if the robot certainly runs in Gazebo. A link without mass is harmless if it is fixed to a link with mass.
    """
    robot = whole_robot_in(project)
    if robot is None or not project.may_be_simulated:
        return
    severity = Severity.ERROR if sure_simulator(project) else None
    masses = [(link, inertial.mass) for link in robot.links if (inertial := inertial_of(link)) and inertial.mass]
    suspects = [
        (link, mass, value) for link, mass in masses if (value := mass.value) is not None and value <= LEAST_MASS
    ]
    vanished = {id(link) for body in vanishing(robot) for link in body.links} if suspects else set()
    for link, mass, value in suspects:
        if value < 0:
            yield Finding(mass.at, f"<mass> of {label('link', link.name)} is negative: {mass.text}", severity=severity)
        elif id(link) in vanished:
            amount = "no mass" if value == 0 else f"a mass of only {mass.text} kg"
            message = f"{label('link', link.name)} moves but has {amount}; Gazebo drops it and everything below it"
            yield Finding(where_written(mass.at, mass.text, None).at, message, severity=severity)
