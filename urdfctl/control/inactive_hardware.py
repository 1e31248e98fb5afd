"""Hardware that the controller manager is configured to leave inactive or unconfigured.

Unconfigured hardware has no interfaces to claim. Inactive hardware has them, but from jazzy 4.38 on controllers that
command it are refused too, unless the manager is configured to allow them (controller_manager.cpp,
init_resource_manager; prepare_command_mode_switch gets the command interfaces alone).
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import Configured, Session
from urdfctl.model.controllers import Value
from urdfctl.startup.records import NamedTuple

_STATES = "hardware_components_initial_state"
_ALLOWED = "defaults.allow_controller_activation_with_inactive_hardware"


class Inactive(NamedTuple):
    """A hardware component that a controller needs, and that is not activated.

    state: `inactive` or `unconfigured`.
    named: the element of the list that names the component.
    """

    hardware: str
    state: str
    named: Value


def inactive_hardware(session: Session, controller: Configured) -> Iterator[Inactive]:
    """Yield the hardware of a started controller that stays inactive; nothing if it is unknown what is started."""
    manager = controller.controller.manager
    if session.started is None or manager is None or session.distro not in since("humble"):
        return
    allowed = manager.parameters.value(_ALLOWED)
    states = ["unconfigured"]
    if session.distro in since("jazzy") and not (allowed and (allowed.value is True or not allowed.is_known)):
        states.append("inactive")
    for state in states:
        names = manager.parameters.value(f"{_STATES}.{state}")
        for hardware in sorted(_needed(session, controller, state)):
            named = _named(names, hardware)
            if named is not None:
                yield Inactive(hardware, state, named)


def _needed(session: Session, controller: Configured, state: str) -> set[str]:
    """The hardware components that the controller cannot be activated without, if they stay in a state.

    A controller of all interfaces takes those that are there. The state of inactive hardware may be read.
    """
    components: set[str] = set()
    for kind in ClaimKind if state == "unconfigured" else (ClaimKind.COMMAND,):
        for claim in controller.claimed(kind):
            if claim.best_effort:
                continue
            offers = session.hardware.of(kind, claim.component)
            components.update(offer.by for offer in offers if offer.interface == claim.interface and offer.by)
    return components


def _named(names: Value | None, hardware: str) -> Value | None:
    return next((item for item in names.items if item.text == hardware), None) if names else None
