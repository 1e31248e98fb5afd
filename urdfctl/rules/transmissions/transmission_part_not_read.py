"""UC227."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.robot import Tag, Transmission, TransmissionEnd
from urdfctl.names import folded
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.transmissions.common import is_of_another_package, read_transmissions

_CHILDREN = ("type", "joint", "actuator")
_OF_AN_END = ("hardwareInterface", "mechanicalReduction", "role", "offset")
_SIMPLE = "SimpleTransmission"
_TRANSMISSION = """
    <transmission name="elbow_trans"%s>
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"%s>
        <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>%s
      </joint>
      <actuator name="elbow_motor">
        <mechanicalReduction>1</mechanicalReduction>%s
      </actuator>%s
    </transmission>
"""


@rule(
    "UC227",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS1,
    authority='ros_control transmission_interface/src/transmission_parser.cpp: FirstChildElement() and Attribute("name") by exact '
    "names; simple_transmission_loader.cpp reads the reduction of the actuator only",
    options=["--distro=noetic"],
    bad=[
        {"robot.urdf": _TRANSMISSION % (' type="«SimpleTransmission»"', ' role="«joint1»"', "", "", "")},
        {
            "robot.urdf": _TRANSMISSION
            % (
                "",
                "",
                "«<mechanicalReduction>»50</mechanicalReduction>«<gear>»2</gear>",
                "«<motorTorqueConstant>»1</motorTorqueConstant>",
                '«<mechanicalReduction>»50</mechanicalReduction>«<compensator k_belt="1"/>»',
            )
        },
        {
            "robot.urdf": _TRANSMISSION
            % ("", "", "", "", "«<hardwareInterface>»hardware_interface/PositionJointInterface</hardwareInterface>")
        },
    ],
    good=[
        {"robot.urdf": _TRANSMISSION % ("", "", "<offset>0.1</offset>", "", "")},
        {"robot.urdf": _TRANSMISSION % ("", "", "<mechanicalReduction>1</mechanicalReduction>", "", "")},
        {
            "robot.urdf": _TRANSMISSION
            % ("", "", "<Offset>0.1</Offset>", "", '<Joint name="wrist"/><Actuator name="motor"/>')
        },
    ],
)
def transmission_part_not_read(project: Project) -> Iterator[Finding]:
    """Part of a transmission that nothing reads.

    ros_control reads the elements of a transmission by their names and places, and silently ignores all others: a
    reduction outside of the <actuator> reduces nothing, and the attributes of the PR2's form have no effect.
    """
    for transmission in read_transmissions(project):
        if is_of_another_package(transmission):
            continue
        yield from _attributes(transmission.tag, transmission.label)
        for child in transmission.others:
            if not _is_slip(child, _CHILDREN) and not _is_missed(child, transmission):
                yield Finding(child.at, f"<{child.name}> directly in {transmission.label} is ignored{_belongs(child)}")
        for end in (*transmission.joints, *transmission.actuators):
            yield from _of_end(end, transmission)


def _of_end(end: TransmissionEnd, transmission: Transmission) -> Iterator[Finding]:
    owner = f"{end.tag.name} '{end.name}' of {transmission.label}"
    yield from _attributes(end.tag, owner)
    for child in end.others:
        if not _is_slip(child, _OF_AN_END):
            yield Finding(child.at, f"<{child.name}> of {owner} is ignored")
    if end.tag.name == "joint" and _is_simple(transmission) and all(each.reductions for each in transmission.actuators):
        for reduction in end.reductions:
            if reduction.value not in ("", "1", "1.0"):
                message = f"<mechanicalReduction> of {owner} is ignored; it belongs into the <actuator>"
                yield Finding(reduction.at, message)


def _attributes(tag: Tag, owner: str) -> Iterator[Finding]:
    for name in tag.attributes:
        if name != "name" and ":" not in name and (name != "type" or tag.name == "transmission"):
            child = name in (*_CHILDREN, *_OF_AN_END)
            hint = f"; write it as an element <{name}>" if child else ""
            yield Finding(tag.at[name], f"attribute '{name}' of {owner} is ignored{hint}")


def _belongs(child: Tag) -> str:
    return (
        f"; it belongs into <{'joint' if child.name == 'hardwareInterface' else 'actuator'}>"
        if child.name in _OF_AN_END
        else ""
    )


def _is_slip(child: Tag, names: tuple[str, ...]) -> bool:
    """Whether an element is a misspelt one, which the rule about what is missing then names."""
    return any(child.name != name and folded(child.name) == folded(name) for name in names)


def _is_missed(child: Tag, transmission: Transmission) -> bool:
    """Whether an element is what a joint or actuator lacks, which another rule reports."""
    if child.name == "hardwareInterface":
        return not all(joint.named_interfaces for joint in transmission.joints)
    return child.name == "mechanicalReduction" and not all(end.reductions for end in transmission.actuators)


def _is_simple(transmission: Transmission) -> bool:
    return transmission.type is not None and transmission.type.value.endswith(_SIMPLE)
