"""UC201."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.parts import Text
from urdfctl.model.transmission import Transmission, TransmissionEnd
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole, renamed
from urdfctl.rules.transmissions.common import inserted, misspelt, read_transmissions, with_prefix
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
    message = f"joint '{joint.name}' of {transmission.label} has no <hardwareInterface>"
    if joint.interfaces:
        message = f"the <hardwareInterface> of joint '{joint.name}' of {transmission.label} is empty"
    return Finding(joint.at, message, tuple(_why(transmission, joint)), _repair(transmission, joint, project))


def _repair(transmission: Transmission, joint: TransmissionEnd, project: Project) -> Fix:
    written = misspelt(joint.others, "hardwareInterface")
    if written and written.text:
        return Fix(f"write <hardwareInterface> for <{written.name}>", renamed(written, "hardwareInterface"), safe=True)
    known, reason = _intended(transmission, joint)
    example = with_prefix(known.value if known else "EffortJointInterface", project)
    element = f"<hardwareInterface>{example}</hardwareInterface>"
    older = example.startswith(PREFIX) and not set(project.distros) <= set(since("kinetic"))
    title = f"add {element}{reason}" + (" (before kinetic: without the prefix)" if older else "")
    literal = known is not None and known.at.content.span.text == known.value
    return Fix(title, inserted(joint.at, element) if literal and not joint.interfaces else (), safe=literal)


def _intended(transmission: Transmission, joint: TransmissionEnd) -> tuple[Text | None, str]:
    """The interface that was meant, and what tells so: a comment in the joint, an element beside it, or an actuator."""
    for interface in joint.interfaces:
        if interface.hidden:
            return interface._replace(value=interface.hidden), ", without a comment before the text"
    beside = [other for other in transmission.others if other.name == "hardwareInterface" and other.text]
    if beside:
        return Text(beside[0].text, beside[0].at), ", as beside the joint"
    named = {i.value: i for actuator in transmission.actuators for i in actuator.named_interfaces}
    if len(named) == 1:
        return next(iter(named.values())), ", as its actuator names"
    return None, ", or the position or velocity one"


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
