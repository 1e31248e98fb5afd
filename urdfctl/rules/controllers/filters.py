"""The chains of filters that controllers may hold: `filter_chain.filter1.type`, and the parameters of each filter."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.map_parameters import expanded
from urdfctl.model.parameters import Kind, Parameter, Parameters
from urdfctl.record import NamedTuple
from urdfctl.rules.controllers.readers import Reader

_CHAIN = "filter_chain"


class Chain(NamedTuple):
    """A chain of filters: its full name, what is given below it, and the parameter itself."""

    name: str
    parameters: Parameters
    at: Parameter

    def filters(self) -> Iterator[tuple[str, Parameter]]:
        """The filters that are loaded: filter1, filter2 and so on, as long as the numbers follow each other."""
        number = 1
        while (found := self.parameters.get(f"filter{number}")) is not None:
            yield f"filter{number}", found
            number += 1


def chains(reader: Reader) -> Iterator[Chain]:
    """The chains that are given to a controller."""
    for parameter in reader.type.parameters.values() if reader.type else ():
        if not parameter.name.endswith(_CHAIN) or parameter.type != "none":
            continue
        for name in expanded(parameter.name, reader.given):
            given = reader.located.get(name)
            if given is not None and given.value.kind is Kind.MAP:
                yield Chain(name, reader.located.under(name), given)
