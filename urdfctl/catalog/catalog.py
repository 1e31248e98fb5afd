"""The catalogue: what the world offers of controllers, hardware and simulators, by distro, with what the user adds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.catalog.distros import ALL, generation
from urdfctl.catalog.entries import NOTHING, ControllerType, Parameter, Replacement
from urdfctl.catalog.reading import controller_type, distros_of, extension, in_distro, read_parameters, replacement_of
from urdfctl.catalog.store import plain, renamed
from urdfctl.hints import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from urdfctl.catalog.hardware import HardwareInterface, HardwareType, SimulatorPlugin, TransmissionType

Plain = Mapping[str, Any]


class Catalog:
    """Asked for something of a distro that it does not know, it answers None, or an empty mapping."""

    def __init__(
        self, controllers: Mapping[str, Plain] | None = None, hardware: Mapping[str, Plain] | None = None
    ) -> None:
        self._controllers = dict(controllers or {})
        self._hardware = dict(hardware or {})
        self._made: dict[tuple[str, str], ControllerType | None] = {}
        self._made_hardware: dict[tuple[str, str], HardwareType | None] = {}
        self._hardware_of: dict[str, tuple[str, ...]] = {}

    # -- controllers -------------------------------------------------------------------------------------------------

    def controller(self, name: str, distro: str) -> ControllerType | None:
        """A type of controller as a distro has it; None where it has it not."""
        if (name, distro) not in self._made:
            self._made[name, distro] = self._controller_type(name, distro)
        return self._made[name, distro]

    def known_types(self, distro: str) -> tuple[str, ...]:
        """The types of controllers that a distro has."""
        ros = generation(distro)
        return tuple(name for name, entry in self._controller_entries(ros) if distro in distros_of(entry, ros))

    def distros_of(self, name: str) -> tuple[str, ...]:
        """The distros of both generations that have a type of controller; none where it is not known at all."""
        entries = ((ros, self._controller_entry(name, ros)) for ros in (1, 2))
        return tuple(distro for ros, entry in entries if entry for distro in distros_of(entry, ros))

    def replacement(self, name: str, distro: str) -> Replacement | None:
        """What takes the place of a type in a distro: of one removed or deprecated, or of the other generation's.

        None also where what would take its place is not in that distro.
        """
        ros = generation(distro)
        entry = self._controller_entry(name, ros)
        found = replacement_of(entry) if entry else None
        if found is None and (entry is None or distro not in distros_of(entry, ros)):
            other = renamed()[f"to_ros{ros}"].get(name)
            found = replacement_of({"replacement": other}) if other else None
        return found if found and self.controller(found.type, distro) else None

    # -- hardware, simulators, transmissions --------------------------------------------------------------------------

    def hardware(self, name: str, distro: str) -> HardwareType | None:
        """A hardware plugin as a distro has it; None where it has it not."""
        if (name, distro) not in self._made_hardware:
            from urdfctl.catalog.hardware import hardware_type

            ros = generation(distro)
            own = in_distro({**plain(ros, "hardware"), **self._hardware}.get(name, {"distros": "rolling"}), distro)
            self._made_hardware[name, distro] = hardware_type(own, distro) if own and "type" in own else None
        return self._made_hardware[name, distro]

    def known_hardware(self, distro: str) -> tuple[str, ...]:
        """The hardware plugins that a distro has."""
        if distro not in self._hardware_of:
            ros = generation(distro)
            entries = {**plain(ros, "hardware"), **self._hardware}
            self._hardware_of[distro] = tuple(n for n, entry in entries.items() if distro in distros_of(entry, ros))
        return self._hardware_of[distro]

    def hardware_replacement(self, name: str, distro: str) -> str | None:
        """The hardware plugin that takes the place of one in a distro."""
        entry = plain(generation(distro), "hardware").get(name)
        found = replacement_of(entry) if entry else None
        return found.type if found and found.type in self.known_hardware(distro) else None

    def simulator_plugins(self, distro: str) -> tuple[SimulatorPlugin, ...]:
        """The simulator plugins that robots of a distro may load."""
        return _simulator_plugins(distro)

    def simulator_plugin(self, filename: str, distro: str) -> SimulatorPlugin | None:
        """The simulator plugin of a library, by its file name with or without `lib` and `.so`, as a distro has it; None
        where it has it not."""
        from urdfctl.catalog.hardware import library_of

        return _simulator_plugin(library_of(filename), distro)

    def distros_of_library(self, filename: str) -> tuple[str, ...]:
        """The distros of both generations that have a simulator plugin; none where it is not known at all."""
        from urdfctl.catalog.hardware import library_of

        return _distros_of_library(library_of(filename))

    def transmission(self, name: str, distro: str) -> TransmissionType | None:
        """A type of transmission as a distro has it; None where it has it not."""
        from urdfctl.catalog.hardware import transmission_type

        entry = plain(generation(distro), "transmissions").get(name)
        own = in_distro(entry, distro) if entry else None
        return transmission_type(own, distro) if own else None

    def known_transmissions(self, distro: str) -> tuple[str, ...]:
        """The types of transmissions that a distro has."""
        ros = generation(distro)
        return tuple(name for name, entry in plain(ros, "transmissions").items() if distro in distros_of(entry, ros))

    def hardware_interfaces(self, distro: str) -> Mapping[str, HardwareInterface]:
        """The hardware interfaces of ROS 1 that a distro has, by name; none in ROS 2."""
        from urdfctl.catalog.hardware import hardware_interface

        if generation(distro) != 1:
            return {}
        found = {name: in_distro(entry, distro) for name, entry in plain(1, "interfaces").items()}
        return {name: hardware_interface(own) for name, own in found.items() if own}

    # -- the controller manager ---------------------------------------------------------------------------------------

    def manager_parameters(self, distro: str) -> Mapping[str, Parameter]:
        """The parameters of the controller manager's own node, without those of its controllers."""
        return _manager(distro, "manager")

    def controller_keys(self, distro: str) -> Mapping[str, Parameter]:
        """What the controller manager reads of each controller, below the controller's name: its type, and more."""
        return _manager(distro, "controller")

    def common_parameters(self, distro: str) -> Mapping[str, Parameter]:
        """The parameters that every controller's node has beside its own."""
        return _manager(distro, "every_controller")

    def filters(self, distro: str) -> Mapping[str, Mapping[str, Parameter]]:
        """The parameters of the filters that a chain may hold, by the filter's type."""
        found = {f["type"]: in_distro(f, distro) for f in plain(generation(distro), "manager").get("filters", ())}
        return {name: read_parameters(own["parameters"], distro) for name, own in found.items() if own}

    def standard_interfaces(self, distro: str) -> tuple[str, ...]:
        """The names of interfaces that have a meaning of their own: position, velocity, ...; ROS 2."""
        return tuple(_interfaces(distro).get("standard", ()))

    def sensor_interfaces(self, distro: str) -> Mapping[str, tuple[str, ...]]:
        """The interfaces of a sensor of a kind (imu, force_torque, ...); ROS 2."""
        return {kind: tuple(names) for kind, names in _interfaces(distro).get("sensors", {}).items()}

    # -- the user's ---------------------------------------------------------------------------------------------------

    def extended(self, additions: Additions) -> Catalog:
        """A catalogue with further entries, which go over those of the same type."""
        return Catalog(
            {**self._controllers, **{entry["type"]: entry for entry in additions.controllers}},
            {**self._hardware, **{entry["type"]: entry for entry in additions.hardware}},
        )

    def _controller_type(self, name: str, distro: str) -> ControllerType | None:
        entry = self._controller_entry(name, generation(distro))
        if entry is None:
            return None
        earlier = entry.get("same_as", NOTHING).get(distro)
        made = self.controller(name, earlier) if earlier else controller_type(entry, distro)
        return made._replace(distro=distro) if made and earlier else made

    def _controller_entries(self, ros: int) -> Iterator[tuple[str, Plain]]:
        for name in {**plain(ros, "controllers"), **self._controllers}:
            entry = self._controller_entry(name, ros)
            if entry is not None:
                yield name, entry

    def _controller_entry(self, name: str, ros: int, above: tuple[str, ...] = ()) -> Plain | None:
        """The entry of a type, with what it extends: another type's, or the catalogue's own of the same name.

        None where that is not known, or leads back to one of those `above`.
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
"""The catalogue without anything of the user's."""

_LAST: list[tuple[Additions, Catalog]] = [(NO_ADDITIONS, CATALOG)]


def catalog_with(additions: Additions) -> Catalog:
    """The catalogue with the user's entries: the same one as the last time, where they are the same."""
    if not any(additions):
        return CATALOG
    if _LAST[0][0] is not additions:
        _LAST[0] = (additions, CATALOG.extended(additions))
    return _LAST[0][1]


@cache
def _simulator_plugins(distro: str) -> tuple[SimulatorPlugin, ...]:
    from urdfctl.catalog.hardware import simulator_plugin

    found = (in_distro(entry, distro) for entry in plain(generation(distro), "simulators").values())
    return tuple(simulator_plugin(own, distro) for own in found if own is not None)


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
    found = ((distro, _by_library(generation(distro)).get(library)) for distro in ALL)
    return tuple(distro for distro, entry in found if entry and distro in distros_of(entry, generation(distro)))


@cache
def _manager(distro: str, part: str) -> Mapping[str, Parameter]:
    return read_parameters(plain(generation(distro), "manager").get(part, {}), distro)


def _interfaces(distro: str) -> Plain:
    parts = plain(generation(distro), "interfaces")
    return in_distro(parts, distro) or {} if generation(distro) == 2 else {}  # noqa: PLR2004
