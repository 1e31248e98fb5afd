"""UC136."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import sure_simulator
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.bodies import inertial_of
from urdfctl.rules.urdf.common import may_be_ros2
from urdfctl.rules.urdf.inertia import Moments, moments_of, principal_moments

TOLERANCE_OF_SDFORMAT = 1e-6
TOLERANCE_ELSEWHERE = 1e-2


@rule(
    "UC136",
    runtime="refuses",
    because="only Gazebo does, and the robot may not run there",
    severity=Severity.WARNING,
    authority="gz-math MassMatrix3::IsValid(), sdformat src/Link.cc: 'A link named ... has invalid inertia.'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial>
                    <mass value="1"/>
                    «<inertia ixx="1" ixy="0" ixz="0" iyy="2.5" iyz="0" izz="0.5"/>»
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
                  <inertial>
                    <mass value="1"/>
                    <inertia ixx="1" ixy="0" ixz="0" iyy="1.5" iyz="0" izz="0.5"/>
                  </inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def inertia_impossible(project: Project) -> Iterator[Finding]:
    """Physically impossible inertia.

    No principal moment may be negative, or greater than the sum of the other two. urdfdom does not check this. Gazebo
    rejects the robot from sdformat 9 on, and other engines become unstable. It is an error if gz runs the robot.
    """
    robot = robot_in(project)
    if robot is None:
        return
    tolerance = TOLERANCE_OF_SDFORMAT if may_be_ros2(project) else TOLERANCE_ELSEWHERE
    severity = Severity.ERROR if sure_simulator(project) == "gz" else None
    for link in robot.links:
        inertial = inertial_of(link)
        moments = moments_of(inertial)
        if inertial is None or inertial.inertia_at is None or moments is None:
            continue
        fault = _fault(moments, tolerance)
        if fault:
            message = f"<inertia> of {label('link', link.name)} is impossible: {fault}"
            message += "; gz rejects the robot" if severity else ""
            yield Finding(inertial.inertia_at, message, severity=severity)


def _fault(moments: Moments, tolerance: float) -> str:
    least, middle, most = principal_moments(moments)
    aligned = not (moments[1] or moments[2] or moments[4])
    if least < -tolerance * max(abs(least), abs(most)):
        return (
            f"moment {least:g} is negative"
            if aligned
            else f"it is not positive definite, its smallest principal moment is {least:g}"
        )
    if least + middle < most * (1 - tolerance):
        kind = "moment" if aligned else "principal moment"
        return f"{kind} {most:g} is greater than the sum of the other two, {least:g} and {middle:g}"
    return ""
