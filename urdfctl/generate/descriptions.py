"""What is put into a robot's description: transmissions, a `<ros2_control>` component, the simulator's plugin."""

from __future__ import annotations

import re
from collections.abc import Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import since
from urdfctl.catalog.hardware import HardwareType
from urdfctl.control.claims import claims
from urdfctl.errors import UserError
from urdfctl.generate.facts import JointFacts
from urdfctl.generate.hardware import hardware, host
from urdfctl.generate.options import Options
from urdfctl.generate.parameters import Controller
from urdfctl.generate.scalars import yaml_float
from urdfctl.generate.templates import Templates
from urdfctl.record import NamedTuple

_STATES = ("position", "velocity")
OF_TRANSMISSIONS = tuple(f"{kind}JointInterface" for kind in ("Effort", "Velocity", "Position", "PosVel", "PosVelAcc"))


class Command(NamedTuple):
    """A command interface, with its least and greatest value where the robot tells them."""

    name: str
    limits: tuple[str, str] | None = None


class Part(NamedTuple):
    """A joint, sensor or gpio (`kind`) of a component."""

    kind: str
    name: str
    commands: tuple[Command, ...]
    states: tuple[str, ...]


def transmissions(joints: Sequence[JointFacts], options: Options, templates: Templates, given: dict[str, str]) -> str:
    """A transmission for each joint that controllers command, by the interface that `given` says; for each where there
    are none. UserError where none of their interfaces is one of transmissions."""
    if options.ros != 1:
        raise UserError(f"{options.distro} reads no transmissions of this form: see gen-ros2-control")
    prefix = "hardware_interface/" if options.distro in since("kinetic") else ""
    shown = []
    for joint in joints:
        asked = joint.interface or (None if given else options.interface or "effort")
        name = f"{asked.capitalize()}JointInterface" if asked else given.get(joint.name)
        if name in OF_TRANSMISSIONS:
            reduction = yaml_float(float(joint.reduction))
            shown.append({"name": joint.name, "interface": f"{prefix}{name}", "reduction": reduction})
    if not shown:
        names = ", ".join(sorted({*given.values()})) or "what is asked for"
        raise UserError(f"no transmission gives {names}; one gives {', '.join(OF_TRANSMISSIONS)}")
    form = "macro" if options.macro else "plain"
    return templates.render(f"transmissions/{form}.xacro", joints=shown, interface=shown[0]["interface"])


def component(
    joints: Sequence[JointFacts], options: Options, catalog: Catalog, templates: Templates, made: Sequence[Controller]
) -> str:
    """A component with what the controllers claim, or with what the options say of each joint."""
    if options.ros == 1:
        raise UserError(f"{options.distro} reads no <ros2_control>: see gen-transmissions")
    plugin = hardware(options, catalog)
    parts = _parts(joints, options, made)
    _check(parts, plugin)
    about = "a simulator" if plugin.simulator in ("gz", "gazebo-classic", "mujoco") else "hardware"
    return templates.render(
        "ros2_control/component.xacro",
        name="RobotSystem",
        type=plugin.component_types[0] if "system" not in plugin.component_types else "system",
        plugin=plugin.type,
        about="mock hardware, which does what it is told" if plugin.simulator == "mock" else about,
        parts=parts,
    )


def _check(parts: Sequence[Part], plugin: HardwareType) -> None:
    """UserError where a joint is to be commanded by what the hardware does not take."""
    if plugin.command_interfaces is None:
        return
    for part in parts:
        wrong = [one.name for one in part.commands if one.name not in plugin.command_interfaces]
        if wrong and part.kind == "joint":
            known = ", ".join(plugin.command_interfaces)
            raise UserError(f"'{plugin.type}' takes no '{wrong[0]}' of joint '{part.name}'; it takes {known}")


def simulator_plugin(options: Options, catalog: Catalog, templates: Templates) -> str:
    """The plugin that runs the controllers in the simulator."""
    found = host(options, catalog)
    return templates.render(
        f"gazebo/ros{options.ros}.xacro",
        filename=found.filenames[0],
        name=found.names[0] if found.names else found.package or found.id,
        namespace=options.namespace,
        legacy=options.distro == "kinetic",
        package=options.package or "my_robot_control",
        controllers_file=options.controllers_file,
    )


def wanted_interfaces(made: Sequence[Controller]) -> dict[str, str]:
    """The interfaces in which controllers of ROS 1 look for each joint that they command."""
    found: dict[str, str] = {}
    for one in made:
        claimed = claims(one.type, one.name, one.values)
        for claim in claimed.command if claimed else ():
            found.setdefault(claim.component, re.split("/|::", claim.interface)[-1])
    return found


def _parts(joints: Sequence[JointFacts], options: Options, made: Sequence[Controller]) -> list[Part]:
    known = {joint.name: joint for joint in joints}
    commands: dict[str, list[str]] = {}
    states: dict[str, list[str]] = {}
    names = {one.name for one in made}
    for one in made:
        claimed = claims(one.type, one.name, one.values)
        for found, into in ((claimed.command, commands), (claimed.state, states)) if claimed else ():
            for claim in found:
                if claim.component.partition("/")[0] not in names and not claim.best_effort:
                    into.setdefault(claim.component, []).append(claim.interface)
    if not commands and not states:
        commands = {joint.name: [joint.interface or options.interface or "position"] for joint in joints}
    ordered = dict.fromkeys([*known, *commands, *states])
    return [_part(name, known.get(name), commands.get(name, []), states.get(name, []), options) for name in ordered]


def _part(name: str, joint: JointFacts | None, commands: list[str], states: list[str], options: Options) -> Part:
    kind = "joint" if joint else "gpio" if commands else "sensor"
    own = (options.states or _STATES) if joint else ()
    limited = tuple(Command(one, _limits(joint, one) if joint else None) for one in dict.fromkeys(commands))
    return Part(kind, name, limited, tuple(dict.fromkeys((*own, *states))))


def _limits(joint: JointFacts, interface: str) -> tuple[str, str] | None:
    limit = {"velocity": joint.velocity, "effort": joint.effort}.get(interface)
    if interface == "position" and joint.lower is not None and joint.upper is not None and joint.lower < joint.upper:
        return yaml_float(float(joint.lower)), yaml_float(float(joint.upper))
    return (yaml_float(-float(limit)), yaml_float(float(limit))) if limit else None
