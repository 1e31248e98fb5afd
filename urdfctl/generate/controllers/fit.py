"""Compare what controllers command with what the robot already offers, before anything is written."""

from __future__ import annotations

import re
from collections.abc import Sequence

from urdfctl.control.claims import claims
from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import RobotFacts

_ROS1 = re.compile(r"(?:hardware_interface/)?(\w+)JointInterface")


def check_fit(made: Sequence[GeneratedController], robot: RobotFacts, options: GeneratorOptions) -> None:
    """UserError if a controller commands a joint through an interface that its part of the robot does not have.

    Joints that the robot does not offer at all are no fault: they can be added.
    """
    offered = offered_by(robot, options)
    own = {controller.name for controller in made}
    for controller in made:
        claimed = claims(controller.type, controller.name, controller.values)
        for claim in claimed.command if claimed else ():
            interface = _plain(claim.interface, options)
            there = offered.get(claim.component)
            if there is None or interface is None or interface in there or claim.component.partition("/")[0] in own:
                continue
            raise UserError(_message(controller, claim.component, interface, there, options))


def offered_by(robot: RobotFacts, options: GeneratorOptions) -> dict[str, tuple[str, ...]]:
    """Return the command interfaces that each joint of a robot already has, from its transmissions or components."""
    if options.ros == 1:
        return dict(robot.interfaces)
    return {part.name: part.commands for part in robot.of_kind("joint") if part.commands}


def copies_commands(options: GeneratorOptions) -> bool:
    """Return whether mock hardware is written: it copies commands to states of that name; no effort moves it."""
    return options.ros == 2 and not options.simulated and options.hardware in (None, "mock")  # noqa: PLR2004


def _plain(interface: str, options: GeneratorOptions) -> str | None:
    if options.ros == 2:  # noqa: PLR2004
        return interface
    match = _ROS1.fullmatch(interface)
    return match[1].lower() if match else None


def _message(
    controller: GeneratedController, joint: str, interface: str, there: tuple[str, ...], options: GeneratorOptions
) -> str:
    has = " and ".join(there)
    title = f"'{controller.name}' ({controller.type.type}) commands '{interface}' of joint '{joint}'"
    use = f"--controller {controller.name}={controller.task.kind}[{there[0]}]" if options.requests else ""
    use = use or f"--interface {there[0]}"
    other = f"use {use}" if there[0] in _choices(controller) else f"choose a type that commands {has}"
    if options.ros == 1:
        change = f"change its <hardwareInterface> to hardware_interface/{interface.capitalize()}JointInterface"
        return f"{title}, whose transmission has '{has}': {other}, or {change}"
    change = f'add <command_interface name="{interface}"/> to the joint'
    return f"{title}, which has only '{has}' in <ros2_control>: {other}, or {change}"


def _choices(controller: GeneratedController) -> tuple[str, ...]:
    """The interfaces that controllers of this kind can command."""
    return controller.task.fit
