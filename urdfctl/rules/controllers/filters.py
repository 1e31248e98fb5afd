"""Filter chains in controller parameters: `filter_chain.filter1.type`, and the parameters of each filter."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.map_parameters import expanded
from urdfctl.control.parameters.readers import Reader
from urdfctl.model.controllers import Parameter, Parameters, ValueKind
from urdfctl.startup.records import NamedTuple

_CHAIN = "filter_chain"


class FilterChain(NamedTuple):
    """A filter chain."""

    name: str
    """Full parameter name of the chain."""
    parameters: Parameters
    """Parameters below the chain, by names relative to it."""
    at: Parameter
    """The parameter that holds the chain."""

    def filters(self) -> Iterator[tuple[str, Parameter]]:
        """Yield name and parameter of each filter that ROS loads: filter1, filter2 and so on, up to the first gap."""
        number = 1
        while (parameter := self.parameters.get(f"filter{number}")) is not None:
            yield f"filter{number}", parameter
            number += 1


def chains(reader: Reader) -> Iterator[FilterChain]:
    """Yield the filter chains in a controller's parameters."""
    for parameter in reader.type.parameters.values() if reader.type else ():
        if not parameter.name.endswith(_CHAIN) or parameter.type != "none":
            continue
        for name in expanded(parameter.name, reader.given):
            given = reader.located.get(name)
            if given is not None and given.value.kind is ValueKind.MAP:
                yield FilterChain(name, reader.located.under(name), given)
