"""The parameters that files give to a controller, as the plain values that the catalogue's rules are asked about."""

from __future__ import annotations

from urdfctl.memory import once_per_object
from urdfctl.model.parameters import Kind, Parameters, Value
from urdfctl.source.opaque import UNKNOWN


@once_per_object
def given_values(parameters: Parameters) -> dict[str, object]:
    """The values by full dotted name, without the maps. What is not known is a text that `is_known` denies."""
    return {leaf.name: plain(leaf.value) for leaf in parameters.leaves if leaf.value.kind is not Kind.MAP}


def plain(value: Value) -> object:
    """One value: a list as a list, nothing as None."""
    if value.kind is Kind.LIST:
        return [plain(item) for item in value.items]
    if value.kind in (Kind.UNKNOWN, Kind.OTHER, Kind.MAP):
        return UNKNOWN
    return value.value
