"""Transmissions that name one joint several times, once for each interface: their component has the joint once."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import indented, removal, root_of, step_of
from urdfctl.migrate.edits.places import ElementKey
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.interfaces import commands_of, states_of
from urdfctl.migrate.ros1.parts import is_one, joint_text
from urdfctl.migrate.ros1.passive import Passive
from urdfctl.migrate.ros1.uses import TransmissionUse, Uses, is_known
from urdfctl.migrate.shared.hardware import HARDWARE_OPTION, system_plugin, without_hardware
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry
from urdfctl.migrate.todo import for_you, todo_line
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = "ros2_control component_parser.cpp: one <joint> with all of its interfaces"
_STAYS = "a joint has several transmissions, and its robots differ: write it once, with all interfaces"

Joints = Mapping[str, tuple[str, ...]]
"""The joints of a component, each with its command interfaces."""


def doubled_elements(uses: Uses) -> set[ElementKey]:
    """Return the transmissions of robots in which one of their joints has several of them, and those beside them that no
    macro makes: joints of one component may mimic each other.

    Names that are not known, of macros that nothing calls, may be those of different joints.
    """
    found: set[ElementKey] = set()
    by_robot: dict[int, list[tuple[ElementKey, TransmissionUse]]] = {}
    for key, its in uses.by_element.items():
        for use in its:
            by_robot.setdefault(use.robot, []).append((key, use))
    for known in by_robot.values():
        names = (joint.name for _, use in known for joint in use.value.joints)
        counts = Counter(name for name in names if name and is_known(name))
        own = {key for key, use in known if any(counts[joint.name or ""] > 1 for joint in use.value.joints)}
        found |= own | {key for key, use in known if own and not use.calls and _is_clear(use)}
    return found


def _is_clear(use: TransmissionUse) -> bool:
    """Whether a transmission is its joints' interfaces alone, which are known."""
    ends = (*use.value.joints, *use.value.actuators)
    return bool(_joints([use], {})) and all(is_one(one.value) for end in ends for one in end.reductions)


def name_for(uses: Uses, number: int) -> str:
    """Return the name of the component of a robot in which joints have several transmissions."""
    robot = uses.robots[number].project.robot
    return f"{(robot.name if robot else None) or 'robot'}_system"


def components_of(
    packages: MigratedPackages, uses: Uses, passive: Passive, replaced: Collection[ElementKey]
) -> Iterator[Proposal]:
    """Yield the proposal to replace some transmissions by a component in the file of each robot."""
    elements = [key for key in uses.by_element if key in replaced]  # in the order of the files
    robots: dict[str, list[Joints]] = {}
    first: dict[str, int] = {}
    numbers = {use.robot for key in elements for use in uses.by_element[key]}
    for number in sorted(numbers):
        path = os.path.realpath(uses.robots[number].project.path)
        first.setdefault(path, number)
        own = [use for key in elements for use in uses.by_element[key] if use.robot == number]
        robots.setdefault(path, []).append(_joints(own, passive.of(number)))
    written = [element for key in elements if (element := uses.element(key)) is not None]
    roots = {path: root_of(packages.read(path)) for path in robots if packages.may_change(path)}
    is_one = all(all(each == joints[0] for each in joints) and joints[0] for joints in robots.values())
    if not is_one or any(root is None or root.close is None for root in roots.values()) or len(roots) < len(robots):
        yield from (for_you(element.at, _STAYS, authority=_AUTHORITY) for element in written)
        return
    edits = [removal(element) for element in written]
    entries = []
    for path, joints in robots.items():
        root = roots[path]
        assert root is not None  # noqa: S101 (checked above)
        name = name_for(uses, first[path])
        todo = without_hardware(packages, name)
        edits.append(
            _component(
                root, name, plugin=system_plugin(packages), joints=joints[0], passive=passive.of(first[path]), todo=todo
            )
        )
        message = f"the transmissions of {', '.join(joints[0])} became joints of component '{name}', each with all its "
        message += "interfaces, with the names that the robot has"
        entries.append(ReportEntry(EntryKind.DONE, message, root.at, authority=_AUTHORITY))
        entries += [ReportEntry(EntryKind.FOR_YOU, todo, file=path, option=HARDWARE_OPTION)] if todo else []
    yield Proposal(tuple(edits), entries=tuple(entries))


def _joints(uses: Sequence[TransmissionUse], passive: Mapping[str, str]) -> Joints:
    """The joints of a robot with their commands; none if something is not known."""
    found: dict[str, tuple[str, ...]] = {}
    for use in uses:
        for joint in use.value.joints:
            actuators = use.value.actuators[0].named_interfaces if use.value.actuators else ()
            values = [commands_of(one.value) for one in joint.named_interfaces or actuators]
            if not joint.name or not is_known(joint.name) or not values or None in values:
                return {}
            commands = [command for each in values for command in each or ()]
            found[joint.name] = tuple(dict.fromkeys((*found.get(joint.name, ()), *commands)))
    return {name: () if name in passive else commands for name, commands in found.items()}


def _component(root: Element, name: str, *, plugin: str, joints: Joints, passive: Mapping[str, str], todo: str) -> Edit:
    """The edit that writes a component at the end of a robot's file."""
    step = step_of(root.source)
    note = f"{step}{todo_line(root.source.path, todo)}\n" if todo else ""
    body = "".join(
        joint_text(joint, commands, states_of(commands), step, passive.get(joint, ""))
        for joint, commands in joints.items()
    )
    inner = f"<hardware>\n{note}{step}<plugin>{plugin}</plugin>\n</hardware>\n{body}"
    text = f'<ros2_control name="{name}" type="system">\n{indented(inner, step)}</ros2_control>\n'
    start = root.source.data.rfind(b"\n", 0, root.close) + 1
    return Edit(SourceSpan(root.source, start, start), indented(text, step))
