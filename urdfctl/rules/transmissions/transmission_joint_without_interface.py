"""UC201."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.session import session_of
from urdfctl.model.robot import ElementText, Transmission, TransmissionEnd
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole, renamed
from urdfctl.rules.insertions import inserted
from urdfctl.rules.transmissions.common import misspelt, read_transmissions, with_prefix
from urdfctl.rules.transmissions.facts import PREFIX
from urdfctl.startup.records import NamedTuple


@rule(
    "UC201",
    severity=Severity.ERROR,
    runtime="drops",
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'No valid hardware interface element "
    "found in joint'",
    bad=[
        {
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
def transmission_joint_without_interface(project: Project) -> Iterator[Finding]:
    """Transmission joint without a hardware interface.

    ros_control skips the joint, so no controller can claim it: the robot starts, but the joint never moves. Up to hydro
    the interface belonged in <actuator>; from indigo on it is read only from <joint>.
    """
    for transmission in read_transmissions(project):
        for joint in transmission.joints:
            if joint.name and not joint.named_interfaces and is_whole(project, joint.at):
                yield _finding(transmission, joint, project)


def _finding(transmission: Transmission, joint: TransmissionEnd, project: Project) -> Finding:
    message = f"joint '{joint.name}' of {transmission.label} has no <hardwareInterface>"
    if joint.interfaces:
        message = f"joint '{joint.name}' of {transmission.label} has an empty <hardwareInterface>"
    return Finding(joint.at, message, tuple(_why(transmission, joint)), _repair(transmission, joint, project))


def _repair(transmission: Transmission, joint: TransmissionEnd, project: Project) -> Fix:
    misspelled = misspelt(joint.others, "hardwareInterface")
    if misspelled and misspelled.text:
        edits = renamed(misspelled, "hardwareInterface")
        return Fix(f"rename <{misspelled.name}> to <hardwareInterface>", edits, safe=True)
    known, source = _intended(transmission, joint)
    demanded = None if known else _demanded(joint.name or "", project)
    source = f", which controller '{demanded.controller}' requires" if demanded else source
    example = known.value if known else demanded.interface if demanded else "EffortJointInterface"
    example = with_prefix(example, project)
    element = f"<hardwareInterface>{example}</hardwareInterface>"
    may_be_older = example.startswith(PREFIX) and not set(project.distros) <= set(since("kinetic"))
    title = f"add {element}{source}" + (" (before kinetic: without the prefix)" if may_be_older else "")
    literal = known is not None and known.at.content.span.text == known.value
    edits = inserted(joint.at, element) if (literal or demanded) and not joint.interfaces else ()
    return Fix(title, edits, safe=bool(edits))


class DemandedInterface(NamedTuple):
    """The only interface in which controllers require a joint, and the first of them."""

    interface: str
    controller: str


def _demanded(joint: str, project: Project) -> DemandedInterface | None:
    """What controllers require for a joint; None if that is nothing, or several interfaces."""
    if project.controllers is None or not project.controllers.complete:
        return None
    session = session_of(project, project.distros[-1])
    demanded = {
        claim.interface.rpartition("/")[2]: each.name
        for each in reversed(session.candidates)
        for claim in each.claims.command
        if claim.component == joint
    }
    return DemandedInterface(*demanded.popitem()) if len(demanded) == 1 else None


def _intended(transmission: Transmission, joint: TransmissionEnd) -> tuple[ElementText | None, str]:
    """The intended interface and its source: a comment in the joint, an element beside it, or an actuator."""
    for interface in joint.interfaces:
        if interface.hidden:
            return interface._replace(value=interface.hidden), ", without the comment before the text"
    beside = [other for other in transmission.others if other.name == "hardwareInterface" and other.text]
    if beside:
        return ElementText(beside[0].text, beside[0].at), ", as it is beside the joint"
    named = {text.value: text for actuator in transmission.actuators for text in actuator.named_interfaces}
    if len(named) == 1:
        return next(iter(named.values())), ", as in its actuator"
    return None, ", or the position or velocity interface"


def _why(transmission: Transmission, joint: TransmissionEnd) -> Iterator[Note]:
    misspelled = misspelt(joint.others, "hardwareInterface")
    if misspelled:
        yield Note(f"<{misspelled.name}> is ignored; the element is called <hardwareInterface>", misspelled.at)
    for interface in joint.interfaces:
        if interface.hidden:
            yield Note("a comment precedes the text, so ROS 1's XML reader finds none", interface.at)
    for other in transmission.others:
        if other.name == "hardwareInterface":
            yield Note("this <hardwareInterface> is outside the joint; move it into <joint>", other.at)
    for actuator in transmission.actuators:
        for interface in actuator.named_interfaces:
            yield Note("the one in <actuator> does not apply to the joint; move or copy it into <joint>", interface.at)
