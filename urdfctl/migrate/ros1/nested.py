"""Transmissions in the form of ROS 1 inside of `<ros2_control>`, which no distro of ROS 2 can read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, children, element_at, indent_of, indented, removal, span_of, step_of
from urdfctl.migrate.edits.places import ElementKey, key_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.parts import UnreadableTransmission, converted
from urdfctl.migrate.shared.hardware import simulated_by
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.xml.dom import Element

_AUTHORITY = "ros2_control component_parser.cpp: 'Missing <plugin> tag of <transmission>'; interfaces are in <joint>"


def _nested(packages: MigratedPackages) -> Iterator[Proposal]:
    for key, known in _found(packages).items():
        element = element_at(packages.read(key[0]), key[1])
        if element is not None and packages.may_change(key[0]):
            yield _proposal(packages, element, known)


def _found(packages: MigratedPackages) -> dict[ElementKey, list[bool | None]]:
    """The transmissions as they are written: whether the component of each robot has all of the joints as parts; None
    if it has some of them."""
    found: dict[ElementKey, list[bool | None]] = {}
    for loaded in packages.loaded():
        for control in loaded.project.robot.ros2_controls if loaded.project.robot else ():
            parts = {part.name for part in control.of_kind("joint") if part.name}
            for transmission in control.transmissions:
                if transmission.is_ros1:
                    names = {joint.name for joint in transmission.joints}
                    has_joints = True if names <= parts else None if names & parts else False
                    found.setdefault(key_of(transmission.tag.at), []).append(has_joints)
    return found


def _proposal(packages: MigratedPackages, element: Element, known: Sequence[bool | None]) -> Proposal:
    name, has_joints = attribute(element, "name"), known[0]
    try:
        simulated = simulated_by(packages) != "none"
        part = converted(element, (), {}, simulated=simulated, step=step_of(element.source))
    except UnreadableTransmission as reason:
        text = f"transmission '{name}' in <ros2_control> is one of ROS 1: {reason}"
        return for_you(element.at, text, authority=_AUTHORITY)
    if has_joints is None or len(set(known)) > 1:
        text = f"write the interfaces of transmission '{name}' in <joint>: only some of its joints have them"
        return for_you(element.at, text, authority=_AUTHORITY)
    text = _without_joints(part.text) if has_joints else part.text
    what = "superfluous: its joint has interfaces" if has_joints else "a joint with interfaces"
    what = "one of ROS 2" if has_joints and text else what
    names = ", ".join(attribute(joint, "name") for joint in children(element, "joint"))
    entry = ReportEntry(EntryKind.DONE, f"the transmission of {names} became {what}", element.at, authority=_AUTHORITY)
    edit = Edit(span_of(element), indented(text, indent_of(element)).strip()) if text else removal(element)
    return Proposal((edit,), entries=(entry,))


def _without_joints(text: str) -> str:
    """The part of a text that is a transmission."""
    start = text.find("<transmission")
    return text[start:] if start >= 0 else ""


NESTED = Step(
    name="transmissions-in-components",
    part=Part.URDF,
    summary="Transmissions of ROS 1 in <ros2_control>",
    propose=_nested,
    is_needed=True,
    rows=(Row("<ros2_control>: <transmission> with <type>", "<joint> with interfaces", "", _AUTHORITY),),
    before=[
        {
            "options": "--from=humble --to=jazzy --simulator=none",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                  </hardware>
                  <transmission name="elbow_motor">
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow">
                      <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>
                    </joint>
                    <actuator name="motor"/>
                  </transmission>
                </ros2_control>
            """,
        },
        {
            "options": "--from=humble --to=jazzy --simulator=none",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                  <transmission name="elbow_motor">
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow">
                      <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>
                    </joint>
                    <actuator name="motor"/>
                  </transmission>
                </ros2_control>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                    <state_interface name="velocity"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
