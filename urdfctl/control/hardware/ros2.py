"""Interfaces that the components of `<ros2_control>` offer.

The hardware plugin gets all interfaces listed in the tag, and the manager refuses a plugin that does not export them
(resource_manager.cpp, validate_storage), except in Gazebo, where what it does not export is only missing. A plugin may
export more. The simulated ones in the catalogue do not, except for command interfaces that parameters of mock hardware
add (mock_components/src/generic_system.cpp).
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.hardware import HardwareType
from urdfctl.control.hardware.behaviour import validates
from urdfctl.control.hardware.interfaces import UNKNOWN_HARDWARE, Offer, OfferedHardware, by_component, fixed_joints
from urdfctl.model.robot import ComponentPart, Interface, Robot, Ros2Control
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple


def described_hardware(robot: Robot, catalog: Catalog, distro: str) -> OfferedHardware:
    """Return the interfaces that all hardware components of a robot offer."""
    controls = tuple(control for control in robot.ros2_controls if control.parent == robot.element)
    if not controls or _is_partly_unknown(controls):
        return UNKNOWN_HARDWARE
    command: list[Offer] = []
    state: list[Offer] = []
    exact: set[str] = set()
    bare: set[str] = set()
    is_open = False
    for control in controls:
        plugin = _hardware_type(control, catalog, distro)
        known = _Exported(plugin, strict=validates(catalog, control.plugin, distro))
        command += _renamed(known.commands(_commands(control, plugin), control), plugin)
        offered = (offer for part in control.parts for offer in _offers(control, part, part.states))
        state += known.states(offered, control)
        if _exports_only_described(plugin):
            exact |= {part.name.strip() for part in control.parts if part.name}
        else:
            is_open = True
            has_own = plugin is not None and plugin.exports_own
            if has_own or not any(part.interfaces for part in control.parts):
                bare |= {part.name.strip() for part in control.parts if part.name}
    joints = frozenset(robot.joint_names)
    fixed = fixed_joints(robot)
    return OfferedHardware(
        by_component(command),
        by_component(state),
        frozenset(exact),
        joints,
        open=is_open,
        fixed=fixed,
        bare=frozenset(bare),
    )


def _is_partly_unknown(controls: tuple[Ros2Control, ...]) -> bool:
    """Whether a name in them is unknown; then no interface can be called missing."""
    parts = [part for control in controls for part in control.parts]
    names = [part.name for part in parts] + [interface.name for part in parts for interface in part.interfaces]
    return any(UNKNOWN in (name or "") for name in (*names, *(control.plugin for control in controls)))


def _hardware_type(control: Ros2Control, catalog: Catalog, distro: str) -> HardwareType | None:
    return catalog.hardware(control.plugin.strip(), distro) if control.plugin else None


def _exports_only_described(plugin: HardwareType | None) -> bool:
    """Whether a plugin exports only the described interfaces: simulated ones do, others are unknown."""
    return plugin is not None and plugin.simulator is not None


def _commands(control: Ros2Control, plugin: HardwareType | None) -> Iterator[Offer]:
    added = _commanded_states(control, plugin)
    for part in control.parts:
        if control.type != "sensor" and part.kind != "sensor":
            yield from _offers(control, part, part.commands)
        if part.kind in added:
            yield from _offers(control, part, part.states)


class _Exported(NamedTuple):
    """What a plugin exports of the described interfaces of its joints."""

    plugin: HardwareType | None
    strict: bool
    """Whether it is refused if it does not export all of them."""

    def commands(self, offers: Iterator[Offer], control: Ros2Control) -> Iterator[Offer]:
        return self._of(offers, control, self.plugin.command_interfaces if self.plugin else None)

    def states(self, offers: Iterator[Offer], control: Ros2Control) -> Iterator[Offer]:
        return self._of(offers, control, self.plugin.state_interfaces if self.plugin else None)

    def _of(self, offers: Iterator[Offer], control: Ros2Control, names: tuple[str, ...] | None) -> Iterator[Offer]:
        if self.strict or names is None:
            return offers
        joints = {(part.name or "").strip() for part in control.parts if part.kind == "joint"}
        return (offer for offer in offers if offer.interface in names or offer.component not in joints)


def _renamed(offers: Iterator[Offer], plugin: HardwareType | None) -> Iterator[Offer]:
    names = plugin.offered_as if plugin is not None else {}
    return (offer._replace(interface=names.get(offer.interface, offer.interface)) for offer in offers)


def _commanded_states(control: Ros2Control, plugin: HardwareType | None) -> set[str]:
    """The kinds of parts whose state interfaces are exported as command interfaces too."""
    if plugin is None or not control.hardware:
        return set()
    given = {name: control.hardware[-1].parameter(name) for name in plugin.states_commanded}
    true = {name for name, parameter in given.items() if parameter and parameter.value.strip().lower() == "true"}
    return {kind for name, kind in plugin.states_commanded.items() if name in true}


def _offers(control: Ros2Control, part: ComponentPart, interfaces: tuple[Interface, ...]) -> Iterator[Offer]:
    for interface in interfaces:
        if part.name and interface.name:
            yield Offer(part.name.strip(), interface.name.strip(), interface.at, control.name)
