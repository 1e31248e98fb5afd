"""The types that the packages of a workspace define themselves."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple


class OwnTypes(NamedTuple):
    """Types that packages of the workspace export, as far as the project concerns them.

    controllers: entries of controllers in the form of the catalogue, by type. `open`: the controller may read other
        parameters too; if it has no `parameters`, they are unknown.
    hardware: the names of hardware plugins.
    nodes: the parameters of other nodes, by the node's name.
    """

    controllers: Mapping[str, Mapping[str, Any]] = MappingProxyType({})
    hardware: tuple[str, ...] = ()
    nodes: Mapping[str, Mapping[str, Mapping[str, Any]]] = MappingProxyType({})


NO_OWN_TYPES = OwnTypes()
