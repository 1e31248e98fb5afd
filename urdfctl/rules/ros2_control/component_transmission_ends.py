"""UC348."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, label
from urdfctl.rules.ros2_control.common import components


@rule(
    "UC348",
    severity=Severity.WARNING,
    runtime="refuses",
    because="only hardware that loads transmissions does",
    distros=since("humble"),
    authority='ros2_control transmission_interface/src/differential_transmission_loader.cpp: "Failed to construct '
    'transmission"; "There should be exactly two unique joint names"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  «<transmission name="elbow_gear">»
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
                  </transmission>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
                    <actuator name="elbow_motor" role="actuator1"/>
                  </transmission>
                </ros2_control>
            """,
        },
    ],
)
def component_transmission_ends(project: Project) -> Iterator[Finding]:
    """Wrong number of joints or actuators in a transmission of a component.

    A simple transmission has one joint and one actuator; a differential and a four-bar linkage have two of each. The
    description loads, but hardware that loads the transmission fails if there are too few. If there are too many, the
    first ones are used. For a component of type `actuator`, the parser creates the actuator.
    """
    for control in components(project):
        for transmission in control.transmissions:
            name = transmission.plugins[0].past_comments if transmission.plugins else ""
            kinds = [project.catalog.transmission(name, distro) for distro in project.distros]
            kind = next((kind for kind in kinds if kind), None)
            if (
                kind is None
                or not is_all_there(project, transmission.tag)
                or (control.type or "").strip() == "actuator"
            ):
                continue
            for what, ends, required in (
                ("joint", transmission.joints, kind.joints),
                ("actuator", transmission.actuators, kind.actuators),
            ):
                if required is not None and len(ends) != required:
                    count = {0: f"no {what}", 1: f"1 {what}"}.get(len(ends), f"{len(ends)} {what}s")
                    short = name.rsplit("/")[-1]
                    message = f"{label('transmission', transmission.name)} has {count}, but {short} requires {required}"
                    yield Finding(transmission.at, message)
