"""UC201."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.transmission import Transmission, TransmissionEnd
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole
from urdfctl.rules.transmissions.common import misspelt, read_transmissions, with_prefix
from urdfctl.rules.transmissions.facts import PREFIX


@rule(
    "UC201",
    severity=Severity.ERROR,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'No valid hardware interface element "
    "found in joint'",
    bad={
        "robot.urdf": """
            <transmission name="elbow_trans">
              <type>transmission_interface/SimpleTransmission</type>
              «<joint name="elbow"/>»
              <actuator name="elbow_motor">
                <hardwareInterface>EffortJointInterface</hardwareInterface>
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
def transmission_joint_without_interface(project: Project) -> Iterator[Finding]:
    """A transmission's joint names no hardware interface.

    ros_control skips the joint, so no controller can claim it: the robot starts, and the joint never moves. Up to hydro
    the interface stood in <actuator>; from indigo on it is read from <joint> only.
    """
    for transmission in read_transmissions(project):
        for joint in transmission.joints:
            if joint.name and not joint.named_interfaces and is_whole(project, joint.at):
                yield _finding(transmission, joint, project)


def _finding(transmission: Transmission, joint: TransmissionEnd, project: Project) -> Finding:
    notes = list(_why(transmission, joint))
    known = _intended(transmission, joint)
    example = with_prefix(known or "EffortJointInterface", project)
    reason = ", as its actuator names" if known else ", or the position or velocity one"
    older = " (before kinetic: without the prefix)" if example.startswith(PREFIX) else ""
    title = f"add <hardwareInterface>{example}</hardwareInterface>{reason}{older}"
    message = f"joint '{joint.name}' of {transmission.label} has no <hardwareInterface>"
    if joint.interfaces:
        message = f"the <hardwareInterface> of joint '{joint.name}' of {transmission.label} is empty"
    return Finding(joint.at, message, tuple(notes), Fix(title))


def _intended(transmission: Transmission, joint: TransmissionEnd) -> str | None:
    """The interface that was meant: misspelt in the joint, hidden by a comment, or in the actuator."""
    written = misspelt(joint.others, "hardwareInterface")
    hidden = [interface.hidden for interface in joint.interfaces if interface.hidden]
    by_actuators = [i.value for actuator in transmission.actuators for i in actuator.named_interfaces]
    return next(iter([written.text] if written and written.text else [*hidden, *by_actuators]), None)


def _why(transmission: Transmission, joint: TransmissionEnd) -> Iterator[Note]:
    written = misspelt(joint.others, "hardwareInterface")
    if written:
        yield Note(f"<{written.name}> is not read: the element is spelt <hardwareInterface>", written.at)
    for interface in joint.interfaces:
        if interface.hidden:
            yield Note("a comment stands before the text, and ROS 1's XML reader gives nothing then", interface.at)
    for other in transmission.others:
        if other.name == "hardwareInterface":
            yield Note("this <hardwareInterface> stands beside the joint; it belongs inside <joint>", other.at)
    for actuator in transmission.actuators:
        for interface in actuator.named_interfaces:
            yield Note("the one in <actuator> is not read for the joint: move it, or repeat it there", interface.at)
