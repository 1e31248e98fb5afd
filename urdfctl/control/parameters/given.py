"""Parameters of a controller from its files, as the plain values that the rules of the catalogue check."""

from __future__ import annotations

from urdfctl.model.controllers import Parameters, Value, ValueKind
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.per_object import once_per_object


@once_per_object
def given_values(parameters: Parameters) -> dict[str, object]:
    """Return the values by full dotted name, without maps. For an unknown value, `is_known` returns False."""
    return {leaf.name: plain(leaf.value) for leaf in parameters.leaves if leaf.value.kind is not ValueKind.MAP}


def plain(value: Value) -> object:
    """Return one value as a plain object: a list as a list, null as None, an unknown value or a map as UNKNOWN."""
    if value.kind is ValueKind.LIST:
        return [plain(item) for item in value.items]
    if value.kind in (ValueKind.UNKNOWN, ValueKind.OTHER, ValueKind.MAP):
        return UNKNOWN
    return value.value
