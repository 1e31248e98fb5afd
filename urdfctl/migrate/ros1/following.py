"""Write the joints that mimic another one as joints of `<ros2_control>` that nothing commands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.migrate.edits.markup import step_of
from urdfctl.migrate.edits.places import key_of_element
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.followers import followers_of
from urdfctl.migrate.ros1.gathering import Component, Path, prefix_of
from urdfctl.migrate.ros1.interfaces import states_of
from urdfctl.migrate.ros1.parts import joint_text
from urdfctl.migrate.ros1.passive import Passive
from urdfctl.migrate.ros1.uses import TransmissionUse, Uses
from urdfctl.model.robot import Robot


def idle(passive: Passive, its_uses: Sequence[TransmissionUse]) -> Iterator[tuple[Path, str]]:
    """Yield the robots in which nothing commands the joint of a transmission, with what is written for it there."""
    for use in its_uses:
        joints = passive.of(use.robot)
        names = [joint.name for joint in use.value.joints if joint.name]
        if names and all(name in joints for name in names):
            texts = (joint_text(name, (), states_of(()), "  ", joints[name]) for name in names)
            yield (use.robot, use.calls), "".join(texts)


def following(packages: MigratedPackages, uses: Uses, component: Component) -> str:
    """Return the joints that mimic a joint of a component and have no transmission themselves.

    The name of one is written with the same prefix as those of the component's joints.
    """
    step = step_of(component.unit.source)
    prefix = prefix_of(name for item in component.items for name in item.names)
    written: dict[str, str] = {}
    for number in {robot for item in component.items for robot, _ in item.paths}:
        project = uses.robots[number].project
        leaders = _joints(uses, component, number)
        before = _prefix_in(uses, component, number, prefix) if prefix else ""
        for name, leader in _mimicking(project.robot) if project.robot else ():
            if leader not in leaders or not name.startswith(before):
                continue
            texts = followers_of(packages, project).get(name, "")
            texts = texts.replace(f">{leader}<", f">{prefix}{leader.removeprefix(before)}<")
            own = f"{prefix}{name.removeprefix(before)}"
            written.setdefault(own, joint_text(own, (), states_of(()), step, texts))
    return "".join(written.values())


def _mimicking(robot: Robot) -> Iterator[tuple[str, str]]:
    """The joints that mimic another one and have no transmission, each with the mimicked joint."""
    own = {joint.name for transmission in robot.transmissions for joint in transmission.joints}
    for joint in robot.joints:
        if joint.name and joint.name not in own and joint.mimic and joint.mimic.joint:
            yield joint.name, joint.mimic.joint


def _uses_in(uses: Uses, component: Component, robot: int) -> Iterator[tuple[str, str]]:
    """The joints of a component in a robot: as they are written, and their names.

    Those of a macro that the component calls belong to it, too; those of other components of the robot do not.
    """
    own = {key_of_element(item.element): item for item in component.items}
    for key, its_uses in uses.by_element.items():
        for use in its_uses:
            item = next((own[one] for one in (key, *use.calls) if one in own), None)
            if item is not None and use.robot == robot:
                yield from zip(item.names or ("",) * 9, (joint.name or "" for joint in use.value.joints), strict=False)


def _joints(uses: Uses, component: Component, robot: int) -> set[str]:
    return {name for _, name in _uses_in(uses, component, robot)}


def _prefix_in(uses: Uses, component: Component, robot: int, prefix: str) -> str:
    """What the prefix of a component's joints is in a robot."""
    for written, name in _uses_in(uses, component, robot):
        rest = written.removeprefix(prefix)
        if written and "$" not in rest and name.endswith(rest):
            return name.removesuffix(rest)
    return ""
