"""Parameters as YAML gives them: typed, located, and found by their dotted names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from urdfctl.record import NamedTuple
from urdfctl.source.kinds import Kind
from urdfctl.source.span import Place


class Value(NamedTuple):
    """A value with its place. `value` is None for lists, maps, and what cannot be told; `text` is what is written,
    without its quotes; `items` are the elements of a list, `fields` what a map in a list holds."""

    kind: Kind
    value: bool | int | float | str | None
    text: str
    at: Place
    items: tuple[Value, ...] = ()
    fields: tuple[Parameter, ...] = ()

    @property
    def is_known(self) -> bool:
        """Whether it stands there as it will be read: neither it nor an element waits for a substitution."""
        return self.kind is not Kind.UNKNOWN and all(item.is_known for item in self.items)

    @property
    def strings(self) -> tuple[tuple[str, Place], ...]:
        """The texts in it that are strings to their reader: its own, or those of its elements."""
        found = [item for item in (self, *self.items) if item.kind is Kind.STRING]
        return tuple((item.text, item.at) for item in found)


class Parameter(NamedTuple):
    """A parameter, or a map of them (`Kind.MAP`): its dotted name, where its own key stands, and its value."""

    name: str
    key: Place
    value: Value

    @property
    def last(self) -> str:
        """The last part of the name."""
        return self.name.rpartition(".")[2]


class Parameters:
    """Parameters by their dotted names, in the order of the files; of a name given twice the last one."""

    __slots__ = ("_by_name", "_leaves")

    def __init__(self, parameters: Iterable[Parameter] = ()) -> None:
        self._by_name: Mapping[str, Parameter] = {parameter.name: parameter for parameter in parameters}
        self._leaves: tuple[Parameter, ...] | None = None

    def __iter__(self) -> Iterator[Parameter]:
        return iter(self._by_name.values())

    def __len__(self) -> int:
        return len(self._by_name)

    def __contains__(self, name: str) -> bool:
        return name in self._by_name

    def get(self, name: str) -> Parameter | None:
        """The parameter or map of a dotted name."""
        return self._by_name.get(name)

    def value(self, name: str) -> Value | None:
        """The value of a dotted name."""
        parameter = self._by_name.get(name)
        return parameter.value if parameter else None

    @property
    def leaves(self) -> tuple[Parameter, ...]:
        """The parameters that are no maps; an empty map counts as one."""
        if self._leaves is None:
            parents = {name.rpartition(".")[0] for name in self._by_name}
            self._leaves = tuple(p for p in self if p.value.kind is not Kind.MAP or p.name not in parents)
        return self._leaves

    def below(self, name: str = "") -> tuple[Parameter, ...]:
        """What stands directly in a map, or at the top: with its whole dotted name."""
        return tuple(parameter for parameter in self if parameter.name.rpartition(".")[0] == name)

    def under(self, name: str) -> Parameters:
        """What stands in a map at any depth, named as seen from there."""
        start = f"{name}."
        return Parameters(p._replace(name=p.name[len(start) :]) for p in self if p.name.startswith(start))


__all__ = ["Kind", "Parameter", "Parameters", "Value"]
