"""What uses the joint or link that a value belongs to: controllers, limits, transmissions, hardware and MoveIt."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from urdfctl.control.groups import Groups
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import session_of
from urdfctl.diagnostic import located
from urdfctl.model.project import Project
from urdfctl.source.span import Place
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple
from urdfctl.trace.address import parts_of


class PartUse(NamedTuple):
    """Something that uses a joint or link.

    kind: controller, limits, hardware, transmission, mimic, group or moveit.
    name: its name.
    how: how it uses it.
    at: where it names it; None if it does so by a rule, as a broadcaster of all joints does.
    """

    kind: str
    name: str
    how: str
    at: Place | None

    def as_json(self) -> dict[str, Any]:
        """Return it as plain data."""
        found: dict[str, Any] = {"kind": self.kind, "name": self.name, "how": self.how}
        if self.at is not None:
            at = located(self.at.span)
            found.update(file=at.file, line=at.line, column=at.column)
        return found


def uses_of(project: Project, element: Element) -> list[PartUse]:
    """Return what uses the joint that an element is of, or is in; of a link, the joints at it."""
    parts = parts_of(element)
    joint = next((part.attrs.get("name", "") for part in parts if part.tagName == "joint"), "")
    if joint:
        found = [
            *_controllers(project, joint),
            *_limits(project, joint),
            *_parts(project, joint),
            *_moveit(project, joint),
        ]
    else:
        link = next((part.attrs.get("name", "") for part in parts if part.tagName == "link"), "")
        found = [*_joints_at(project, link)] if link else []
    return list(dict.fromkeys(found))


def _controllers(project: Project, joint: str) -> Iterator[PartUse]:
    if project.controllers is None or not project.distros:
        return
    for each in session_of(project, project.distro or project.distros[-1]).controllers:
        name = each.controller.in_namespace
        for kind in ClaimKind:
            for claim in each.claimed(kind):
                if claim.component == joint:
                    at = _parameter(each.controller.parameters, claim.parameter, joint)
                    yield PartUse("controller", name, f"{kind.value} interface {claim.interface}".strip(), at)
        for parameter in each.controller.parameters.leaves:
            places = [at for text, at in parameter.value.strings if text == joint]
            if places or f".{joint}." in f".{parameter.name}.":
                yield PartUse("controller", name, f"parameter {parameter.name}", places[0] if places else parameter.key)


def _parameter(parameters: Any, name: str | None, joint: str) -> Place | None:
    value = parameters.value(name) if name else None
    return next((at for text, at in value.strings if text == joint), None) if value else None


def _limits(project: Project, joint: str) -> Iterator[PartUse]:
    for limits in project.moveit.limits if project.moveit else ():
        if limits.joint.text == joint:
            yield PartUse(
                "limits", "joint_limits.yaml", ", ".join(key.text for key, _ in limits.values), limits.joint.at
            )


def _parts(project: Project, joint: str) -> Iterator[PartUse]:
    robot = project.robot
    if robot is None:
        return
    for component in robot.ros2_controls:
        for own in component.of_kind("joint"):
            if own.name == joint:
                yield PartUse("hardware", component.name or "", "ros2_control", own.at)
    for transmission in robot.transmissions:
        for used in transmission.joints:
            if used.name == joint:
                yield PartUse(
                    "transmission",
                    transmission.name or "",
                    transmission.type.value if transmission.type else "",
                    used.at,
                )
    for other in robot.joints:
        if other.mimic is not None and other.mimic.joint == joint:
            yield PartUse("mimic", other.name or "", "follows it", other.mimic.at)


def _moveit(project: Project, joint: str) -> Iterator[PartUse]:
    moveit, robot = project.moveit, project.robot
    if moveit is None or robot is None:
        return
    if moveit.semantic is not None:
        groups = Groups(robot, moveit.semantic)
        for group in moveit.semantic.groups:
            if joint in groups.members(group):
                yield PartUse("group", group.name.text, "plans for it", group.name.at)
    for controller in moveit.controllers:
        for key in controller.joints:
            if key.text == joint:
                yield PartUse("moveit", controller.name.text, "MoveIt sends trajectories to it", key.at)


def _joints_at(project: Project, link: str) -> Iterator[PartUse]:
    for joint in project.robot.joints if project.robot else ():
        for role, reference in (("parent", joint.parent), ("child", joint.child)):
            if reference is not None and reference.name == link:
                yield PartUse("joint", joint.name or "", f"has it as its {role}", reference.at)
