"""UC204."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.gazebo_ros1 import control_plugins
from urdfctl.model.robot import Transmission
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole
from urdfctl.rules.transmissions.common import misspelt


@rule(
    "UC204",
    runtime="drops",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'No type element found in "
    "transmission', 'Skipping empty type element in transmission'",
    bad=[
        {
            "robot.urdf": """
                «<transmission name="elbow_trans" type="transmission_interface/SimpleTransmission">»
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def transmission_without_type(project: Project) -> Iterator[Finding]:
    """Transmission without a `<type>`.

    ros_control skips the whole transmission, so no controller can claim its joint. A type in an attribute is the form
    of the PR2, which ros_control does not read.
    """
    for transmission in project.robot.transmissions if project.robot else ():
        if transmission.is_pr2 and not control_plugins(project):
            continue
        if transmission.type is not None and not transmission.type.value:
            message = f"{transmission.label} has an empty <type>"
            yield Finding(transmission.type.at, message, tuple(_why(transmission)), _fix(transmission))
        elif transmission.type is None and is_whole(project, transmission.at):
            message = f"{transmission.label} has no <type>"
            yield Finding(transmission.at, message, tuple(_why(transmission)), _fix(transmission))


def _why(transmission: Transmission) -> Iterator[Note]:
    if transmission.type_attribute is not None:
        yield Note("ros_control does not read the attribute 'type'", transmission.at["type"])
    if transmission.type is not None and transmission.type.hidden:
        yield Note("a comment precedes the text, so ROS 1's XML reader finds none", transmission.type.at)
    misspelled = misspelt(transmission.others, "type")
    if misspelled:
        yield Note(f"<{misspelled.name}> is ignored; the element is called <type>", misspelled.at)


def _fix(transmission: Transmission) -> Fix:
    kind = "SimpleTransmission" if len(transmission.joints) < 2 else "DifferentialTransmission"  # noqa: PLR2004
    return Fix(f"add <type>transmission_interface/{kind}</type>")
