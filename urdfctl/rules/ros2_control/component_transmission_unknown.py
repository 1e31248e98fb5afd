"""UC347."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label
from urdfctl.rules.ros2_control.common import component, components, corrected
from urdfctl.rules.ros2_control.kinds import other_kind


@rule(
    "UC347",
    runtime="refuses",
    because="only hardware that loads transmissions does",
    severity=Severity.WARNING,
    distros=ROS2,
    authority='ros2_control transmission_interface/ros2_control_plugins.xml has three types; "Failed to construct '
    'transmission" for any other',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    «<plugin>»transmission_interface/SimpelTransmission</plugin>
                    <joint name="elbow" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
                    <actuator name="elbow_motor" role="actuator1"/>
                  </transmission>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    «<plugin>»mock_components/GenericSystem</plugin>
                    <joint name="elbow" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
                    <actuator name="elbow_motor" role="actuator1"/>
                  </transmission>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_drivers/Arm</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <transmission name="elbow_gear">
                    «<plugin>»joint_trajectory_controller/JointTrajectoryController</plugin>
                    <joint name="elbow" role="joint1"><mechanical_reduction>30</mechanical_reduction></joint>
                    <actuator name="elbow_motor" role="actuator1"/>
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
def component_transmission_unknown(project: Project) -> Iterator[Finding]:
    """Unknown transmission type in a component.

    The description loads, but hardware that loads the transmission fails. Up to galactic, no transmission type is
    available.
    """
    known = {name for distro in project.distros for name in project.catalog.known_transmissions(distro)}
    for control in components(project):
        for transmission in control.transmissions:
            name = transmission.plugins[0].past_comments if transmission.plugins else ""
            if not name or not is_known(name) or name in known:
                continue
            meant = nearest(name, known) or _slashed(name, known)
            other = None if meant else _other(project, name)
            if other is not None:
                of = f"{label('transmission', transmission.name)} in {component(control)}"
                yield Finding(transmission.plugins[0].at, f"{of} names '{name}', which is {other}; {_EXPECTED}")
                continue
            if meant is None and not name.startswith("transmission_interface"):
                continue
            of = f"{label('transmission', transmission.name)} in {component(control)}"
            hint = f"did you mean '{meant}'?" if meant else _EXPECTED
            fix = corrected(transmission.plugins[0], meant) if meant else None
            yield Finding(transmission.plugins[0].at, f"{of} has unknown type '{name}'; {hint}", fix=fix)


def _other(project: Project, name: str) -> str | None:
    """What a name is, if it is certainly no transmission."""
    is_hardware = any(name in project.catalog.known_hardware(distro) for distro in project.distros)
    return "hardware" if is_hardware else other_kind(project, name)


_EXPECTED = "expected SimpleTransmission, DifferentialTransmission or FourBarLinkageTransmission"


def _slashed(name: str, known: Iterable[str]) -> str | None:
    tail = name.replace("::", "/").rsplit("/")[-1]
    return next((other for other in known if other.endswith("/" + tail)), None)
