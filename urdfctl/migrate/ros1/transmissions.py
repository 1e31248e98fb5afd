"""Transmissions of ROS 1 become the joints of a `<ros2_control>` element."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from itertools import count

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import attribute, element_at, step_of
from urdfctl.migrate.edits.places import ElementKey, key_of_element, place_of, written_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.doubled import components_of, doubled_elements, name_for
from urdfctl.migrate.ros1.following import following, idle
from urdfctl.migrate.ros1.gathering import Component, Gathering, label_of, prefix_of, written_component
from urdfctl.migrate.ros1.parts import Converted, UnreadableTransmission, converted
from urdfctl.migrate.ros1.passive import HELD, Passive
from urdfctl.migrate.ros1.uses import Uses
from urdfctl.migrate.shared.hardware import HARDWARE_OPTION, simulated_by, system_plugin, without_hardware
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Element

_AUTHORITY = "ros2_control hardware_interface/src/component_parser.cpp: <ros2_control> is a child of <robot>"
_REDUCTIONS = "gazebo_ros_control DefaultRobotHWSim: <mechanicalReduction> is not read"
_NESTED = (
    "control.ros.org, transmission_interface; ros2_control#599: the hardware plugin must load transmissions itself"
)


def _transmissions(packages: MigratedPackages) -> Iterator[Proposal]:
    uses = Uses(packages)
    passive = Passive(packages, uses)
    done = _joints_of_components(packages)
    doubled = doubled_elements(uses)
    if doubled:
        yield from components_of(packages, uses, passive, doubled)
    single = (key for key in uses.by_element if key not in doubled)
    known = [element for key in single if (element := uses.element(key)) is not None]
    parts: list[tuple[Element, Converted]] = []
    for element in [*known, *uses.unused()]:
        if {attribute(joint, "name") for joint in element.elements() if joint.tagName == "joint"} & done:
            continue
        try:
            parts.append((element, _converted(packages, uses, passive, element)))
        except UnreadableTransmission as reason:
            yield _left(packages, element, str(reason))
    for key in uses.inserted:
        if (element := uses.element(key)) is not None:
            yield _left(packages, element, "it is passed to a macro as a block")
    yield from _components(packages, uses, passive, parts, doubled)


def _left(packages: MigratedPackages, element: Element, reason: str) -> Proposal:
    at = packages.read(element.source.path)
    found = element_at(at, element.start)
    text = f"transmission '{attribute(element, 'name')}' has no counterpart in ROS 2: {reason}"
    return for_you((found or element).at, text)


def _converted(packages: MigratedPackages, uses: Uses, passive: Passive, element: Element) -> Converted:
    its_uses = uses.by_element.get(key_of_element(element), [])
    joints = passive.shared({use.robot for use in its_uses})
    simulated = simulated_by(packages) != "none"
    return converted(element, its_uses, joints, simulated=simulated, step=step_of(element.source))


def _joints_of_components(packages: MigratedPackages) -> set[str]:
    """The joints that the `<ros2_control>` elements of half-migrated packages have, as they are written."""
    names = set()
    for element in written_elements(packages, "<ros2_control", (".xacro", ".urdf", ".xml", ".gazebo")):
        if element.tagName == "ros2_control":
            names |= {attribute(joint, "name") for joint in element.elements() if joint.tagName == "joint"}
    return names


def _components(
    packages: MigratedPackages,
    uses: Uses,
    passive: Passive,
    parts: list[tuple[Element, Converted]],
    doubled: Collection[ElementKey],
) -> Iterator[Proposal]:
    sources: Mapping[str, SourceText] = _Sources(packages)
    gathering = Gathering(sources)
    for element, part in parts:
        its_uses = uses.by_element.get(key_of_element(element), [])
        paths = [(use.robot, use.calls) for use in its_uses]
        gathering.add(element, part, paths, dict(idle(passive, its_uses)))
    try:
        components = list(gathering.components())
    except UnreadableTransmission as reason:
        for element, _ in parts:
            yield _left(packages, element, str(reason))
        return
    texts = {key_of_element(element): part for element, part in parts}
    names = _names(uses, components, doubled)
    lifted = [edit for edits in gathering.edits.values() for edit in edits]
    edits: list[Edit] = []
    entries: list[ReportEntry] = []
    for component, name in zip(components, names, strict=True):
        try:
            more = following(packages, uses, component)
            todo = without_hardware(packages, name)
            own = list(written_component(component, name, system_plugin(packages), more, todo))
        except UnreadableTransmission as reason:
            yield _left(packages, component.items[0].element, str(reason))
            if lifted:
                return
            continue
        edits += own
        entries += [*_entries(component, name, texts), *_moved(component, passive)]
        at = next(edit.span for edit in own if todo in edit.text)
        entries += [ReportEntry(EntryKind.FOR_YOU, todo, place_of(at), option=HARDWARE_OPTION)] if todo else []
    if edits:
        yield Proposal(edits=tuple(dict.fromkeys([*lifted, *edits])), entries=tuple(entries))


class _Sources(dict[str, SourceText]):
    """The texts of files by path, read when they are asked for."""

    def __init__(self, packages: MigratedPackages) -> None:
        super().__init__()
        self._packages = packages

    def __missing__(self, path: str) -> SourceText:
        return self._packages.read(path)


def _names(uses: Uses, components: list[Component], doubled: Collection[ElementKey]) -> list[str]:
    """A name for each component, different for those of one robot; also from that of its doubled transmissions."""
    known = {use.robot: name_for(uses, use.robot) for key in doubled for use in uses.by_element[key]}
    names: list[str] = []
    for component in components:
        robots = sorted({robot for item in component.items for robot, _ in item.paths})
        found = (uses.robots[number].project.robot for number in robots)
        label = label_of(component.unit, next((robot.name for robot in found if robot and robot.name), "robot"))
        prefix = prefix_of(name for item in component.items for name in item.names)
        name = f"{prefix}{label}_system"
        taken = {own for other, own in zip(components, names, strict=False) if _share(other, component)}
        taken |= {known[number] for number in robots if number in known}
        free = (f"{name}_{number}" if number > 1 else name for number in count(1))
        names.append(next(one for one in free if one not in taken))
    return names


def _share(one: Component, other: Component) -> bool:
    robots = [{robot for item in each.items for robot, _ in item.paths} for each in (one, other)]
    return bool(robots[0] & robots[1])


def _entries(component: Component, name: str, texts: Mapping[ElementKey, Converted]) -> Iterator[ReportEntry]:
    at = component.items[0].element.at
    joints = list(dict.fromkeys(joint for item in component.items for joint in item.names))
    shown = ", ".join(joints[:3]) + (f" and {len(joints) - 3} more" if len(joints) > 3 else "")  # noqa: PLR2004
    of_joints = f" of {shown}" if shown else ""
    message = f"transmissions{of_joints} became the joints of component '{name}' in <ros2_control>"
    yield ReportEntry(EntryKind.DONE, message, at, authority=_AUTHORITY)
    parts = [part for item in component.items if (part := texts.get(key_of_element(item.element)))]
    dropped = [part for part in parts if part.dropped]
    if dropped:
        yield ReportEntry(
            EntryKind.DECIDED,
            f"the reduction {dropped[0].dropped} of {len(dropped)} transmissions is dropped: simulators have no motors",
            at,
            authority=_REDUCTIONS,
            option="--simulator none",
        )
    if any(part.kept for part in parts):
        message = f"transmissions with a reduction are nested in component '{name}'; its hardware plugin must load them"
        yield ReportEntry(EntryKind.DECIDED, message, at, authority=_NESTED)


def _moved(component: Component, passive: Passive) -> Iterator[ReportEntry]:
    """Yield the decision on the joints of a component that another plugin of the simulator moves."""
    robots = {robot for item in component.items for robot, _ in item.paths}
    joints = sorted({joint for robot in robots for joint in passive.moved(robot)})
    if joints:
        names = f"'{joints[0]}'" + (f" and {len(joints) - 1} more" if len(joints) > 1 else "")
        message = (
            f"joint {names} has no command interface, or the simulator would hold it against the plugin that moves it"
        )
        yield ReportEntry(EntryKind.DECIDED, message, component.items[0].element.at, authority=HELD)


TRANSMISSIONS = Step(
    name="transmissions",
    part=Part.URDF,
    summary="Transmissions",
    propose=_transmissions,
    generation=1,
    is_needed=True,
    rows=(
        Row("<transmission> with EffortJointInterface", 'command "effort" in <ros2_control>', "", _AUTHORITY),
        Row("<transmission> with VelocityJointInterface", 'command "velocity" in <ros2_control>', "", _AUTHORITY),
        Row("<transmission> with PositionJointInterface", 'command "position" in <ros2_control>', "", _AUTHORITY),
        Row("PosVelJointInterface", 'commands "position" and "velocity"', "", _AUTHORITY),
        Row("PosVelAccJointInterface", 'commands "position", "velocity" and "acceleration"', "", _AUTHORITY),
        Row("<mechanicalReduction> in simulation", "", "", _REDUCTIONS),
        Row("<mechanicalReduction>", "<transmission> in <ros2_control>", "", _NESTED),
        Row("DifferentialTransmission, FourBarLinkageTransmission", "<transmission> in <ros2_control>", "", _NESTED),
    ),
    before=[
        {
            "options": "--from=noetic --to=jazzy --hardware=arm_driver/ArmSystem",
            "robot.urdf": """
                <transmission name="elbow_transmission">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor"/>
                </transmission>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <ros2_control name="arm_system" type="system">
                  <hardware>
                    <plugin>arm_driver/ArmSystem</plugin>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="effort"/>
                    <state_interface name="position"/>
                    <state_interface name="velocity"/>
                    <state_interface name="effort"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
