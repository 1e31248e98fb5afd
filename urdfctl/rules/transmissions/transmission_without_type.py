"""UC204."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.transmission import Transmission
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole
from urdfctl.rules.transmissions.common import control_plugins, misspelt


@rule(
    "UC204",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'No type element found in "
    "transmission', 'Skipping empty type element in transmission'",
    bad={
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
    good={
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
)
def transmission_without_type(project: Project) -> Iterator[Finding]:
    """A transmission has no `<type>`, or an empty one.

    ros_control skips the whole transmission, so that no controller can claim its joint. A type in an attribute is
    the form of the PR2, which ros_control does not read.
    """
    for transmission in project.robot.transmissions if project.robot else ():
        if transmission.is_pr2 and not control_plugins(project):
            continue
        if transmission.type is not None and not transmission.type.value:
            message = f"the <type> of {transmission.label} is empty"
            yield Finding(transmission.type.at, message, tuple(_why(transmission)), _fix(transmission))
        elif transmission.type is None and is_whole(project, transmission.at):
            message = f"{transmission.label} has no <type>"
            yield Finding(transmission.at, message, tuple(_why(transmission)), _fix(transmission))


def _why(transmission: Transmission) -> Iterator[Note]:
    if transmission.type_attribute is not None:
        yield Note("the attribute type is not read by ros_control", transmission.at["type"])
    if transmission.type is not None and transmission.type.hidden:
        yield Note("a comment stands before the text, and ROS 1's XML reader gives nothing then", transmission.type.at)
    written = misspelt(transmission.others, "type")
    if written:
        yield Note(f"<{written.name}> is not read: the element is spelt <type>", written.at)


def _fix(transmission: Transmission) -> Fix:
    kind = "SimpleTransmission" if len(transmission.joints) < 2 else "DifferentialTransmission"  # noqa: PLR2004
    return Fix(f"add <type>transmission_interface/{kind}</type>")
