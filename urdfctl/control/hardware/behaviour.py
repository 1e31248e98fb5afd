"""What the plugin that runs a hardware component in a simulator does with it, by the catalogue."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfctl.catalog.catalog import Catalog
    from urdfctl.catalog.hardware import Behaviour


def behaviour_of(catalog: Catalog, hardware: str | None, distro: str, does: str) -> Behaviour | None:
    """Return what a hardware plugin, or its host, does in a step (see `Behaviour`) in a distro; None if not known."""
    known = catalog.hardware((hardware or "").strip(), distro) if hardware else None
    own = next((each for each in known.behaviour if each.does == does), None) if known else None
    if known is None or known.host is None or own is not None:
        return own
    host = next((plugin for plugin in catalog.simulator_plugins(distro) if plugin.id == known.host), None)
    return host.when(does) if host else None


def validates(catalog: Catalog, hardware: str | None, distro: str) -> bool:
    """Return whether hardware is refused that does not export every interface that is described."""
    validation = behaviour_of(catalog, hardware, distro, "validate")
    return validation is None or validation.strict


def lacking_joint(catalog: Catalog, plugin: str, distro: str) -> str | None:
    """Return what a plugin with this id does about a joint that the simulator's model lacks: all hardware is `refused`,
    or the joint `skipped`; None if it is not known."""
    known = next((each for each in catalog.simulator_plugins(distro) if each.id == plugin), None)
    initialising = known.when("init") if known else None
    return initialising.lacking if initialising else None
