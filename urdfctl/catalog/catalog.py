"""The catalogue: controllers, hardware, simulators and transmissions by distro, plus the user's additions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.catalog.distros import ALL, generation
from urdfctl.catalog.entries import NOTHING, ControllerType, ParameterEntry, Replacement
from urdfctl.catalog.reading import (
    controller_type,
    distros_of,
    extension,
    in_distro,
    is_external,
    package_of,
    read_parameters,
    replacement_of,
)
from urdfctl.catalog.store import plain, renamed

if TYPE_CHECKING:
    from urdfctl.catalog.hardware import HardwareInterface, HardwareType, SimulatorPlugin, TransmissionType

Plain = Mapping[str, Any]


class Catalog:
    """Looks up catalogue entries by name and distro. Lookups of unknown entries return None or an empty mapping."""

    def __init__(
        self, controllers: Mapping[str, Plain] | None = None, hardware: Mapping[str, Plain] | None = None
    ) -> None:
        self._controllers = dict(controllers or {})
        self._hardware = dict(hardware or {})
        self._controller_types: dict[tuple[str, str], ControllerType | None] = {}
        self._hardware_types: dict[tuple[str, str], HardwareType | None] = {}
        self._hardware_of: dict[str, tuple[str, ...]] = {}

    # -- controllers -------------------------------------------------------------------------------------------------

    def controller(self, name: str, distro: str) -> ControllerType | None:
        """Return the controller type `name` in a distro; None if the distro does not have it."""
        if (name, distro) not in self._controller_types:
            self._controller_types[name, distro] = self._controller_type(name, distro)
        return self._controller_types[name, distro]

    def known_types(self, distro: str) -> tuple[str, ...]:
        """Return the names of the controller types in a distro."""
        ros = generation(distro)
        return tuple(name for name, entry in self._controller_entries(ros) if distro in distros_of(entry, ros))

    def types_of_ros_control(self, distro: str) -> Iterator[tuple[str, str]]:
        """Yield the controller types in a distro that come with ros_control or ros2_control, with their packages."""
        for name, entry in self._controller_entries(generation(distro)):
            own = in_distro(entry, distro)
            if own is not None and not is_external(own):
                yield name, package_of(own)

    def distros_of(self, name: str) -> tuple[str, ...]:
        """Return the distros of both ROS generations that have a controller type; none if the type is unknown."""
        entries = ((ros, self._controller_entry(name, ros)) for ros in (1, 2))
        return tuple(distro for ros, entry in entries if entry for distro in distros_of(entry, ros))

    def replacement(self, name: str, distro: str) -> Replacement | None:
        """Return the replacement for a controller type that is removed, deprecated, or from the other ROS generation.

        None if there is no replacement, or the distro does not have it.
        """
        ros = generation(distro)
        entry = self._controller_entry(name, ros)
        replacement = replacement_of(entry) if entry else None
        if replacement is None and (entry is None or distro not in distros_of(entry, ros)):
            counterpart = renamed()[f"to_ros{ros}"].get(name)
            replacement = replacement_of({"replacement": counterpart}) if counterpart else None
        return replacement if replacement and self.controller(replacement.type, distro) else None

    # -- hardware, simulators, transmissions --------------------------------------------------------------------------

    def hardware(self, name: str, distro: str) -> HardwareType | None:
        """Return the hardware plugin `name` in a distro; None if the distro does not have it."""
        if (name, distro) not in self._hardware_types:
            from urdfctl.catalog.hardware import hardware_type

            ros = generation(distro)
            own = in_distro({**plain(ros, "hardware"), **self._hardware}.get(name, {"distros": "rolling"}), distro)
            self._hardware_types[name, distro] = hardware_type(own, distro) if own and "type" in own else None
        return self._hardware_types[name, distro]

    def known_hardware(self, distro: str) -> tuple[str, ...]:
        """Return the names of the hardware plugins in a distro."""
        if distro not in self._hardware_of:
            ros = generation(distro)
            entries = {**plain(ros, "hardware"), **self._hardware}
            self._hardware_of[distro] = tuple(n for n, entry in entries.items() if distro in distros_of(entry, ros))
        return self._hardware_of[distro]

    def hardware_replacement(self, name: str, distro: str) -> str | None:
        """Return the name of the hardware plugin that replaces `name`; None if the distro does not have it."""
        entry = plain(generation(distro), "hardware").get(name)
        replacement = replacement_of(entry) if entry else None
        return replacement.type if replacement and replacement.type in self.known_hardware(distro) else None

    def simulator_plugins(self, distro: str) -> tuple[SimulatorPlugin, ...]:
        """Return the simulator plugins that robots can load in a distro."""
        return _simulator_plugins(distro)

    def simulator_plugin(self, filename: str, distro: str) -> SimulatorPlugin | None:
        """Return the simulator plugin of a library in a distro; None if the distro does not have it.

        filename: name of the library file, with or without `lib` and `.so`.
        """
        from urdfctl.catalog.hardware import library_of

        return _simulator_plugin(library_of(filename), distro)

    def distros_of_library(self, filename: str) -> tuple[str, ...]:
        """Return the distros of both ROS generations that have a simulator plugin; none if the library is unknown."""
        from urdfctl.catalog.hardware import library_of

        return _distros_of_library(library_of(filename))

    def transmission(self, name: str, distro: str) -> TransmissionType | None:
        """Return the transmission type `name` in a distro; None if the distro does not have it."""
        from urdfctl.catalog.hardware import transmission_type

        entry = plain(generation(distro), "transmissions").get(name)
        own = in_distro(entry, distro) if entry else None
        return transmission_type(own, distro) if own else None

    def known_transmissions(self, distro: str) -> tuple[str, ...]:
        """Return the names of the transmission types in a distro."""
        ros = generation(distro)
        return tuple(name for name, entry in plain(ros, "transmissions").items() if distro in distros_of(entry, ros))

    def hardware_interfaces(self, distro: str) -> Mapping[str, HardwareInterface]:
        """Return the ROS 1 hardware interfaces in a distro, by name; none for ROS 2."""
        from urdfctl.catalog.hardware import hardware_interface

        if generation(distro) != 1:
            return {}
        entries = {name: in_distro(entry, distro) for name, entry in plain(1, "interfaces").items()}
        return {name: hardware_interface(own) for name, own in entries.items() if own}

    # -- the controller manager ---------------------------------------------------------------------------------------

    def manager_parameters(self, distro: str) -> Mapping[str, ParameterEntry]:
        """Return the parameters of the controller manager's own node, without those of its controllers."""
        return _manager(distro, "manager")

    def controller_keys(self, distro: str) -> Mapping[str, ParameterEntry]:
        """Return the parameters that the controller manager reads below each controller's name, such as `type`."""
        return _manager(distro, "controller")

    def common_parameters(self, distro: str) -> Mapping[str, ParameterEntry]:
        """Return the parameters that the node of every controller has."""
        return _manager(distro, "every_controller")

    def filters(self, distro: str) -> Mapping[str, Mapping[str, ParameterEntry]]:
        """Return the parameters of the filters that a filter chain can contain, by filter type."""
        filters = plain(generation(distro), "manager").get("filters", ())
        entries = {entry["type"]: in_distro(entry, distro) for entry in filters}
        return {name: read_parameters(own["parameters"], distro) for name, own in entries.items() if own}

    def standard_interfaces(self, distro: str) -> tuple[str, ...]:
        """Return the names of the standard interfaces: position, velocity, ...; none for ROS 1."""
        return tuple(_interfaces(distro).get("standard", ()))

    def sensor_interfaces(self, distro: str) -> Mapping[str, tuple[str, ...]]:
        """Return the interfaces of each kind of sensor (imu, force_torque, ...); none for ROS 1."""
        return {kind: tuple(names) for kind, names in _interfaces(distro).get("sensors", {}).items()}

    # -- the user's additions -----------------------------------------------------------------------------------------

    def extended(self, additions: Additions) -> Catalog:
        """Return a catalogue with these additions, which replace existing entries of the same type."""
        return Catalog(
            {**self._controllers, **{entry["type"]: entry for entry in additions.controllers}},
            {**self._hardware, **{entry["type"]: entry for entry in additions.hardware}},
        )

    def _controller_type(self, name: str, distro: str) -> ControllerType | None:
        entry = self._controller_entry(name, generation(distro))
        if entry is None:
            return None
        earlier = entry.get("same_as", NOTHING).get(distro)
        controller = self.controller(name, earlier) if earlier else controller_type(entry, distro)
        return controller._replace(distro=distro) if controller and earlier else controller

    def _controller_entries(self, ros: int) -> Iterator[tuple[str, Plain]]:
        for name in {**plain(ros, "controllers"), **self._controllers}:
            entry = self._controller_entry(name, ros)
            if entry is not None:
                yield name, entry

    def _controller_entry(self, name: str, ros: int, above: tuple[str, ...] = ()) -> Plain | None:
        """The entry of a type, merged with the entry it extends: another type, or the catalogue's type of that name.

        above: the types that extend this one, from the innermost on.
        None if the extended type is unknown, or is one of those `above`.
        """
        own = self._controllers.get(name)
        if own is None:
            return plain(ros, "controllers").get(name)
        extended = own.get("extends")
        if extended is None:
            return own
        if extended in above:
            return None
        if extended == name:
            base = plain(ros, "controllers").get(name)
        else:
            base = self._controller_entry(extended, ros, (name, *above))
        return extension(base, own) if base else None


CATALOG = Catalog()
"""The catalogue without the user's additions."""

_LAST: list[tuple[Additions, Catalog]] = [(NO_ADDITIONS, CATALOG)]
"""The additions and the catalogue of the last call of `catalog_with`."""


def catalog_with(additions: Additions) -> Catalog:
    """Return the catalogue with the user's additions. Repeated calls with one object return the same catalogue."""
    if not any(additions):
        return CATALOG
    if _LAST[0][0] is not additions:
        _LAST[0] = (additions, CATALOG.extended(additions))
    return _LAST[0][1]


@cache
def _simulator_plugins(distro: str) -> tuple[SimulatorPlugin, ...]:
    from urdfctl.catalog.hardware import simulator_plugin

    entries = (in_distro(entry, distro) for entry in plain(generation(distro), "simulators").values())
    return tuple(simulator_plugin(own, distro) for own in entries if own is not None)


@cache
def _simulator_plugin(library: str, distro: str) -> SimulatorPlugin | None:
    from urdfctl.catalog.hardware import simulator_plugin

    entry = _by_library(generation(distro)).get(library)
    own = in_distro(entry, distro) if entry else None
    return simulator_plugin(own, distro) if own else None


@cache
def _by_library(ros: int) -> Mapping[str, Plain]:
    from urdfctl.catalog.hardware import library_of

    entries = list(plain(ros, "simulators").values())
    return {library_of(name): entry for entry in reversed(entries) for name in reversed(entry["filenames"])}


@cache
def _distros_of_library(library: str) -> tuple[str, ...]:
    entries = ((distro, _by_library(generation(distro)).get(library)) for distro in ALL)
    return tuple(distro for distro, entry in entries if entry and distro in distros_of(entry, generation(distro)))


@cache
def _manager(distro: str, part: str) -> Mapping[str, ParameterEntry]:
    return read_parameters(plain(generation(distro), "manager").get(part, {}), distro)


def _interfaces(distro: str) -> Plain:
    parts = plain(generation(distro), "interfaces")
    return in_distro(parts, distro) or {} if generation(distro) == 2 else {}  # noqa: PLR2004
