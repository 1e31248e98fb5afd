"""What the catalogue tells of hardware plugins, simulator plugins and transmissions, for one distro."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from urdfctl.catalog.entries import NOTHING, Parameter, Replacement
from urdfctl.catalog.reading import in_distro, read_parameters, replacement_of
from urdfctl.hints import Any
from urdfctl.record import NamedTuple

Plain = Mapping[str, Any]


class HardwareType(NamedTuple):
    """A hardware plugin as one distro has it.

    `simulator` is what it simulates with: a simulator's name, `mock`, `topic` or `replay`; None is real hardware.
    `host` is the id of the simulator plugin that loads it. Interfaces of None are any, or not known.
    `sensor_interfaces` are by kind of sensor. `states_commanded`: a parameter that is true adds a command interface to
    each state interface of a kind of part. Commands of some names are `offered_as` others.
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
    hardware_parameters: Mapping[str, Parameter] | None = None
    joint_parameters: Mapping[str, Parameter] | None = None
    deprecated: bool = False
    replacement: Replacement | None = None
    states_commanded: Mapping[str, str] = MappingProxyType({})
    offered_as: Mapping[str, str] = MappingProxyType({})


class PluginChild(NamedTuple):
    """An element that a simulator plugin reads. `names` says what its text must name: a `joint` or a `link`."""

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
    """A plugin of a simulator as one distro has it: by its library's file names, and by its own names where they are
    not free. `old_names` are taken too, with a warning; `replacement` is the id of the one that takes its place. Of an
    `external` one, of another package than the simulator's own, the distros are not sure."""

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


class HardwareInterface(NamedTuple):
    """A hardware interface of ROS 1.

    `kind` is `command`, `state`, `mode`, `abstract` or `transmission_only`, None where not known. `resource` is what
    its handles are of: a joint, an actuator, a sensor. `in_gazebo` tells what gazebo_ros_control's own simulation makes
    of it as `<hardwareInterface>`: `accepted`, `refused`, `absent`, or `registered` for every joint, and refused.
    """

    name: str
    kind: str | None = None
    resource: str | None = None
    in_gazebo: str | None = None


class TransmissionType(NamedTuple):
    """How many ends of each side a type of transmission wants, and their roles where they have some.

    A `legacy` one is of another loader than ros_control's.
    """

    type: str
    joints: int | None
    actuators: int | None
    joint_roles: tuple[str, ...] = ()
    actuator_roles: tuple[str, ...] = ()
    interfaces: tuple[str, ...] = ()
    legacy: bool = False


def hardware_type(own: Plain, distro: str) -> HardwareType:
    """A hardware plugin of its plain entry."""
    sensors = own.get("sensor_interfaces")
    parameters = _parameters(own.get("hardware_parameters"), distro)
    return HardwareType(
        own["type"],
        distro,
        own.get("package", own["type"].partition("/")[0]),
        tuple(own.get("component_types", ("system",))),
        own.get("simulator"),
        own.get("host"),
        _interfaces(own.get("command_interfaces")),
        _interfaces(own.get("state_interfaces")),
        {kind: tuple(names) for kind, names in sensors.items()} if sensors is not None else None,
        parameters,
        _parameters(own.get("joint_parameters"), distro),
        _holds(own.get("deprecated"), distro),
        replacement_of(own),
        {name: kind for name, kind in own.get("states_commanded", {}).items() if name in (parameters or ())},
        own.get("offered_as", {}),
    )


def simulator_plugin(own: Plain, distro: str) -> SimulatorPlugin:
    """A simulator plugin of its plain entry."""
    children = {name: in_distro(child, distro) for name, child in own["children"].items()}
    return SimulatorPlugin(
        own["id"],
        own["simulator"],
        own.get("package"),
        tuple(own["filenames"]),
        tuple(own.get("names", ())),
        {name: _child(name, child) for name, child in children.items() if child is not None},
        own.get("hosts_ros2_control", False) or own.get("hosts_ros_control", False),
        own.get("default_hardware"),
        own.get("of_sensor", False),
        own.get("one_per_model", False),
        tuple(own.get("old_names", ())),
        _holds(own.get("deprecated"), distro),
        own.get("replacement"),
        "origin" in own,
    )


def library_of(filename: str) -> str:
    """What a plugin's file name says, however it is written: without folder, `lib` and `.so`, and by gz-sim's name of
    today where Ignition's is given."""
    stem = filename.strip().rpartition("/")[2].removesuffix(".so").removeprefix("lib")
    return f"gz-sim{stem.removeprefix(_OF_IGNITION)}" if stem.startswith(_OF_IGNITION) else stem


_OF_IGNITION = "ignition-gazebo"


def hardware_interface(own: Plain) -> HardwareInterface:
    """A hardware interface of its plain entry."""
    return HardwareInterface(own["name"], own.get("class"), own.get("resource"), own.get("in_gazebo"))


def transmission_type(own: Plain, distro: str) -> TransmissionType:
    """A type of transmission of its plain entry."""
    del distro  # its overrides are applied
    return TransmissionType(
        own["type"],
        own.get("joints"),
        own.get("actuators"),
        tuple(own.get("joint_roles", ())),
        tuple(own.get("actuator_roles", ())),
        tuple(own.get("interfaces", ())),
        own.get("legacy", False),
    )


def _child(name: str, own: Plain) -> PluginChild:
    return PluginChild(
        name,
        own["type"],
        own.get("required", False),
        own.get("default"),
        own.get("repeatable", False),
        own.get("names"),
        own.get("validators", NOTHING),
        tuple(own.get("aliases", ())),
        own.get("note"),
    )


def _interfaces(plain: list[str] | str | None) -> tuple[str, ...] | None:
    return tuple(plain) if isinstance(plain, list) else None


def _parameters(plain: Mapping[str, Plain] | None, distro: str) -> Mapping[str, Parameter] | None:
    return read_parameters(plain, distro) if plain is not None else None


def _holds(span: str | None, distro: str) -> bool:
    return span is not None and in_distro({"distros": span}, distro) is not None
