"""What the plugin that runs a hardware component in a simulator does with it, by the catalogue."""

from __future__ import annotations

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.hardware import Behaviour


def behaviour_of(catalog: Catalog, hardware: str | None, distro: str, does: str) -> Behaviour | None:
    """Return what the host of a hardware plugin does in a step (`load`, `validate`, `read`, `write`) in a distro.

    None for hardware that no simulator runs, or if it is not known.
    """
    known = catalog.hardware((hardware or "").strip(), distro) if hardware else None
    if known is None or known.host is None:
        return None
    host = next((plugin for plugin in catalog.simulator_plugins(distro) if plugin.id == known.host), None)
    return host.when(does) if host else None


def validates(catalog: Catalog, hardware: str | None, distro: str) -> bool:
    """Return whether hardware is refused that does not export every interface that is described."""
    validation = behaviour_of(catalog, hardware, distro, "validate")
    return validation is None or validation.strict
