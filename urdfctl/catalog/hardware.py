"""Catalogue entries of hardware plugins, simulator plugins and transmissions, for one distro."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from urdfctl.catalog.entries import NOTHING, ParameterEntry, Replacement
from urdfctl.catalog.reading import in_distro, read_parameters, replacement_of
from urdfctl.startup.records import NamedTuple

Plain = Mapping[str, Any]


class Behaviour(NamedTuple):
    """What a plugin that runs a controller manager, or hardware without one, does in one step, in one distro.

    does: `load`, `init`, `validate`, `read`, `write` or `mimic`. authority: file and lines.
    first: of the command interfaces of a joint that are claimed together, only the first of these is applied.
    last: of the command interfaces of a joint that are claimed together, only the last one is applied.
    lacking: what becomes of a joint that the simulator's model lacks: it is `skipped`, or all hardware is `refused`.
    offset: whether a mimic joint is moved with the offset of its <mimic>.
    needs: parameters of the manager without which it gives up.
    strict: whether an interface that is described, but not exported, is refused.
    description: what it gets the robot from: the parameters of a `node`, or a `topic`.
    """

    does: str
    authority: str
    first: tuple[str, ...] = ()
    needs: tuple[str, ...] = ()
    strict: bool = True
    description: str | None = None
    last: bool = False
    lacking: str | None = None
    offset: bool = True


class HardwareType(NamedTuple):
    """A hardware plugin in one distro.

    simulator: a simulator, `mock`, `topic` or `replay`; None for real hardware.
    host: the id of the simulator plugin that loads it.
    command_interfaces, state_interfaces: those of a joint; None if it has any, or they are not known.
    sensor_interfaces: by kind of sensor.
    states_commanded: boolean parameters, each with a kind of part whose state interfaces get command interfaces too.
    offered_as: exported names of renamed command interfaces, by declared name.
    exports_own: whether it exports interfaces of its own for each joint, whatever the description lists.
    behaviour: what it does, step by step, as far as its host does not.
    """

    type: str
    distro: str
    package: str
    component_types: tuple[str, ...]
    simulator: str | None = None
    host: str | None = None
    command_interfaces: tuple[str, ...] | None = None
    state_interfaces: tuple[str, ...] | None = None
    sensor_interfaces: Mapping[str, tuple[str, ...]] | None = None
    hardware_parameters: Mapping[str, ParameterEntry] | None = None
    joint_parameters: Mapping[str, ParameterEntry] | None = None
    deprecated: bool = False
    replacement: Replacement | None = None
    states_commanded: Mapping[str, str] = MappingProxyType({})
    offered_as: Mapping[str, str] = MappingProxyType({})
    exports_own: bool = False
    behaviour: tuple[Behaviour, ...] = ()


class PluginChild(NamedTuple):
    """An element that a simulator plugin reads.

    names: what its text must name: a `joint` or a `link`; None for other texts.
    """

    name: str
    type: str
    required: bool = False
    default: object = None
    repeatable: bool = False
    names: str | None = None
    validators: Mapping[str, object] = NOTHING
    aliases: tuple[str, ...] = ()
    note: str | None = None


class SimulatorPlugin(NamedTuple):
    """A simulator plugin in one distro.

    filenames: the file names of its library. names: its classes; empty if the name is free.
    old_names: classes that are accepted with a warning. replacement: the id of the plugin that replaces it.
    behaviour: what it does, step by step.
    external: whether it is from another package than the simulator's own; its distros are then uncertain.
    """

    id: str
    simulator: str
    package: str | None
    filenames: tuple[str, ...]
    names: tuple[str, ...]
    children: Mapping[str, PluginChild]
    hosts_control: bool = False
    default_hardware: str | None = None
    of_sensor: bool = False
    one_per_model: bool = False
    old_names: tuple[str, ...] = ()
    deprecated: bool = False
    replacement: str | None = None
    external: bool = False
    behaviour: tuple[Behaviour, ...] = ()

    def when(self, does: str) -> Behaviour | None:
        """Return what it does in a step; None if that is not known."""
        return next((each for each in self.behaviour if each.does == does), None)


class HardwareInterface(NamedTuple):
    """A hardware interface of ROS 1.

    kind: `command`, `state`, `mode`, `abstract` or `transmission_only`; None if not known.
    resource: what its handles are for: a joint, an actuator or a sensor.
    in_gazebo: how the simulation of gazebo_ros_control treats it as `<hardwareInterface>`: `accepted`, `refused`,
    `absent`, or `registered` for every joint, but refused.
    """

    name: str
    kind: str | None = None
    resource: str | None = None
    in_gazebo: str | None = None


class TransmissionType(NamedTuple):
    """A transmission type: the number of its joints and actuators, and their roles if it has some.

    joints, actuators: None if any number is accepted. legacy: whether another loader than ros_control's reads it.
    """

    type: str
    joints: int | None
    actuators: int | None
    joint_roles: tuple[str, ...] = ()
    actuator_roles: tuple[str, ...] = ()
    interfaces: tuple[str, ...] = ()
    legacy: bool = False


def hardware_type(own: Plain, distro: str) -> HardwareType:
    """Return a hardware plugin from its plain entry."""
    sensors = own.get("sensor_interfaces")
    parameters = _parameters(own.get("hardware_parameters"), distro)
    return HardwareType(
        type=own["type"],
        distro=distro,
        package=own.get("package", own["type"].partition("/")[0]),
        component_types=tuple(own.get("component_types", ("system",))),
        simulator=own.get("simulator"),
        host=own.get("host"),
        command_interfaces=_interfaces(own.get("command_interfaces")),
        state_interfaces=_interfaces(own.get("state_interfaces")),
        sensor_interfaces={kind: tuple(names) for kind, names in sensors.items()} if sensors is not None else None,
        hardware_parameters=parameters,
        joint_parameters=_parameters(own.get("joint_parameters"), distro),
        deprecated=_holds(own.get("deprecated"), distro),
        replacement=replacement_of(own),
        states_commanded={
            name: kind for name, kind in own.get("states_commanded", {}).items() if name in (parameters or ())
        },
        offered_as=own.get("offered_as", {}),
        exports_own=own.get("exports_own", False),
        behaviour=_behaviours(own, distro),
    )


def simulator_plugin(own: Plain, distro: str) -> SimulatorPlugin:
    """Return a simulator plugin from its plain entry."""
    children = {name: in_distro(child, distro) for name, child in own["children"].items()}
    return SimulatorPlugin(
        id=own["id"],
        simulator=own["simulator"],
        package=own.get("package"),
        filenames=tuple(own["filenames"]),
        names=tuple(own.get("names", ())),
        children={name: _child(name, child) for name, child in children.items() if child is not None},
        hosts_control=own.get("hosts_ros2_control", False) or own.get("hosts_ros_control", False),
        default_hardware=own.get("default_hardware"),
        of_sensor=own.get("of_sensor", False),
        one_per_model=own.get("one_per_model", False),
        old_names=tuple(own.get("old_names", ())),
        deprecated=_holds(own.get("deprecated"), distro),
        replacement=own.get("replacement"),
        external="origin" in own,
        behaviour=_behaviours(own, distro),
    )


def library_of(filename: str) -> str:
    """Return the library of a plugin's file name: without folder, `lib` and `.so`; Ignition's names become gz-sim's."""
    stem = filename.strip().rpartition("/")[2].removesuffix(".so").removeprefix("lib")
    return f"gz-sim{stem.removeprefix(_OF_IGNITION)}" if stem.startswith(_OF_IGNITION) else stem


_OF_IGNITION = "ignition-gazebo"


def hardware_interface(own: Plain) -> HardwareInterface:
    """Return a hardware interface from its plain entry."""
    return HardwareInterface(own["name"], own.get("class"), own.get("resource"), own.get("in_gazebo"))


def transmission_type(own: Plain, distro: str) -> TransmissionType:
    """Return a transmission type from its plain entry."""
    del distro  # overrides are already applied
    return TransmissionType(
        type=own["type"],
        joints=own.get("joints"),
        actuators=own.get("actuators"),
        joint_roles=tuple(own.get("joint_roles", ())),
        actuator_roles=tuple(own.get("actuator_roles", ())),
        interfaces=tuple(own.get("interfaces", ())),
        legacy=own.get("legacy", False),
    )


def _behaviours(own: Plain, distro: str) -> tuple[Behaviour, ...]:
    return tuple(_behaviour(each) for each in own.get("behaviour", ()) if in_distro(each, distro))


def _behaviour(own: Plain) -> Behaviour:
    return Behaviour(
        does=own["does"],
        authority=own["authority"],
        first=tuple(own.get("first", ())),
        needs=tuple(own.get("needs", ())),
        strict=own.get("strict", True),
        description=own.get("description"),
        last=own.get("last", False),
        lacking=own.get("lacking"),
        offset=own.get("offset", True),
    )


def _child(name: str, own: Plain) -> PluginChild:
    return PluginChild(
        name=name,
        type=own["type"],
        required=own.get("required", False),
        default=own.get("default"),
        repeatable=own.get("repeatable", False),
        names=own.get("names"),
        validators=own.get("validators", NOTHING),
        aliases=tuple(own.get("aliases", ())),
        note=own.get("note"),
    )


def _interfaces(plain: list[str] | str | None) -> tuple[str, ...] | None:
    return tuple(plain) if isinstance(plain, list) else None


def _parameters(plain: Mapping[str, Plain] | None, distro: str) -> Mapping[str, ParameterEntry] | None:
    return read_parameters(plain, distro) if plain is not None else None


def _holds(span: str | None, distro: str) -> bool:
    return span is not None and in_distro({"distros": span}, distro) is not None
