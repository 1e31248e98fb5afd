"""Generate parts of a description: transmissions, a `<ros2_control>` component, the simulator's plugin."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import since
from urdfctl.catalog.hardware import HardwareType
from urdfctl.control.claims import claims
from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.files.hardware import hardware, host, takes_namespace
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import NO_ROBOT, JointFacts, RobotFacts
from urdfctl.generate.text.scalars import yaml_float
from urdfctl.generate.text.templates import Templates
from urdfctl.startup.records import NamedTuple

_MUJOCO = "mujoco_ros2_control/MujocoSystemInterface"
_STATES = ("position", "velocity")
OF_TRANSMISSIONS = tuple(f"{kind}JointInterface" for kind in ("Effort", "Velocity", "Position", "PosVel", "PosVelAcc"))


class CommandInterface(NamedTuple):
    """A command interface, with its minimum and maximum if the robot defines them."""

    name: str
    limits: tuple[str, str] | None = None


class PlannedPart(NamedTuple):
    """A joint, sensor or gpio (`kind`) of a component."""

    kind: str
    name: str
    commands: tuple[CommandInterface, ...]
    states: tuple[str, ...]
    parameters: tuple[tuple[str, str], ...] = ()


def transmissions(
    joints: Sequence[JointFacts], options: GeneratorOptions, templates: Templates, given: dict[str, str]
) -> str:
    """Return a transmission for each joint that the controllers command, with the interface from `given`.

    Without controllers, every joint gets one. UserError if transmissions provide none of the interfaces.
    """
    if options.ros != 1:
        raise UserError(f"{options.distro} does not read transmissions of this form; use gen-ros2-control")
    prefix = "hardware_interface/" if options.distro in since("kinetic") else ""
    shown = []
    for joint in joints:
        asked = joint.interface or (None if given else options.interface or "effort")
        name = f"{asked.capitalize()}JointInterface" if asked else given.get(joint.name)
        if name in OF_TRANSMISSIONS:
            reduction = yaml_float(float(joint.reduction))
            shown.append({"name": joint.name, "interface": f"{prefix}{name}", "reduction": reduction})
    if not shown:
        names = ", ".join(sorted({*given.values()})) or "the requested interface"
        raise UserError(f"transmissions do not provide {names}; they provide {', '.join(OF_TRANSMISSIONS)}")
    form = "macro" if options.macro else "plain"
    return templates.render(f"transmissions/{form}.xacro", joints=shown, interface=shown[0]["interface"])


def component(
    joints: Sequence[JointFacts],
    options: GeneratorOptions,
    catalog: Catalog,
    templates: Templates,
    made: Sequence[GeneratedController],
    robot: RobotFacts = NO_ROBOT,
) -> str | None:
    """Return a component with the interfaces that the controllers claim, or that the options give for each joint.

    Parts that a component of the robot has are left out; None if nothing remains.
    """
    if options.ros == 1:
        raise UserError(f"{options.distro} does not read <ros2_control>; use gen-transmissions")
    plugin = hardware(options, catalog)
    there = {part.name for part in robot.parts} - {*robot.generated}
    parts = [part for part in _parts(joints, options, made) if part.name not in there]
    if there:
        parts = [part for part in parts if part.commands or part.kind != "joint"]
    parts += _mimicking(parts, robot, plugin, there)
    if there and not parts:
        return None
    _check(parts, plugin)
    about = "a simulator" if plugin.simulator in ("gz", "gazebo-classic", "mujoco") else "hardware"
    return templates.render(
        "ros2_control/component.xacro",
        name=_unused("RobotSystem", [name for name in robot.components if name not in robot.generated]),
        type=plugin.component_types[0] if "system" not in plugin.component_types else "system",
        plugin=plugin.type,
        parameters=[("mujoco_model", options.model_path)] if plugin.type == _MUJOCO and options.model_path else [],
        about="mock hardware, which copies commands to states" if plugin.simulator == "mock" else about,
        parts=parts,
    )


def _mimicking(
    parts: Sequence[PlannedPart], robot: RobotFacts, plugin: HardwareType, there: set[str]
) -> Iterator[PlannedPart]:
    """The joints that mimic one of the parts, with its states. Up to iron, parameters say what they mimic."""
    leaders = {part.name: part for part in parts if part.kind == "joint"}
    for joint in robot.joints:
        leader = leaders.get(joint.mimic[0]) if joint.mimic else None
        if leader is None or joint.mimic is None or joint.name in leaders or joint.name in there:
            continue
        named = plugin.joint_parameters or {}
        given = {"mimic": joint.mimic[0], "multiplier": yaml_float(float(joint.mimic[1]))}
        parameters = tuple((name, value) for name, value in given.items() if name in named)
        yield PlannedPart("joint", joint.name, (), leader.states, parameters)


def _unused(name: str, taken: Sequence[str]) -> str:
    number = next(n for n in range(1, len(taken) + 2) if (name if n == 1 else f"{name}{n}") not in taken)
    return name if number == 1 else f"{name}{number}"


def _check(parts: Sequence[PlannedPart], plugin: HardwareType) -> None:
    """UserError if a joint is commanded through an interface that the hardware does not accept."""
    if plugin.command_interfaces is None:
        return
    for part in parts:
        wrong = [command.name for command in part.commands if command.name not in plugin.command_interfaces]
        if wrong and part.kind == "joint":
            known = ", ".join(plugin.command_interfaces)
            raise UserError(f"'{plugin.type}' does not accept '{wrong[0]}' for joint '{part.name}'; it accepts {known}")


def simulator_plugin(options: GeneratorOptions, catalog: Catalog, templates: Templates) -> str:
    """Return the plugin that runs the controllers in the simulator. Its namespace is an argument of the robot."""
    plugin = host(options, catalog)
    return templates.render(
        f"gazebo/ros{options.ros}.xacro",
        filename=plugin.filenames[0],
        name=plugin.names[0] if plugin.names else plugin.package or plugin.id,
        namespace=options.namespace,
        movable=takes_namespace(NO_ROBOT, options, catalog),
        legacy=options.distro == "kinetic",
        package=options.package or "my_robot_control",
        controllers_file=options.controllers_file,
    )


def wanted_interfaces(made: Sequence[GeneratedController]) -> dict[str, str]:
    """Return the hardware interface that controllers of ROS 1 use for each joint that they command."""
    interfaces: dict[str, str] = {}
    for controller in made:
        claimed = claims(controller.type, controller.name, controller.values)
        for claim in claimed.command if claimed else ():
            interfaces.setdefault(claim.component, re.split("/|::", claim.interface)[-1])
    return interfaces


def _parts(
    joints: Sequence[JointFacts], options: GeneratorOptions, made: Sequence[GeneratedController]
) -> list[PlannedPart]:
    known = {joint.name: joint for joint in joints}
    commands: dict[str, list[str]] = {}
    states: dict[str, list[str]] = {}
    names = {controller.name for controller in made}
    for controller in made:
        claimed = claims(controller.type, controller.name, controller.values)
        for claims_of_kind, into in ((claimed.command, commands), (claimed.state, states)) if claimed else ():
            for claim in claims_of_kind:
                if claim.component.partition("/")[0] not in names and not claim.best_effort:
                    into.setdefault(claim.component, []).append(claim.interface)
    if not commands and not states:
        commands = {joint.name: [joint.interface or options.interface or "position"] for joint in joints}
    ordered = dict.fromkeys([*known, *commands, *states])
    return [_part(name, known.get(name), commands.get(name, []), states.get(name, []), options) for name in ordered]


def _part(
    name: str, joint: JointFacts | None, commands: list[str], states: list[str], options: GeneratorOptions
) -> PlannedPart:
    kind = "joint" if joint else "gpio" if commands else "sensor"
    own = (options.states or _STATES) if joint else ()
    limited = tuple(CommandInterface(name, _limits(joint, name) if joint else None) for name in dict.fromkeys(commands))
    return PlannedPart(kind, name, limited, tuple(dict.fromkeys((*own, *states))))


def _limits(joint: JointFacts, interface: str) -> tuple[str, str] | None:
    limit = {"velocity": joint.velocity, "effort": joint.effort}.get(interface)
    if interface == "position" and joint.lower is not None and joint.upper is not None and joint.lower < joint.upper:
        return yaml_float(float(joint.lower)), yaml_float(float(joint.upper))
    return (yaml_float(-float(limit)), yaml_float(float(limit))) if limit else None
