"""Parameters from YAML files: typed, located, and looked up by dotted name."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from itertools import islice, takewhile

from urdfctl.source.span import Place
from urdfctl.source.yaml.kinds import ValueKind
from urdfctl.startup.records import NamedTuple


class Value(NamedTuple):
    """A value with its place.

    kind: the type that the reader gives it.
    value: the typed value; None for lists, maps, null and unknown values.
    text: the text in the file, without quotes.
    items: the elements of a list.
    fields: the entries of a map that is an element of a list.
    """

    kind: ValueKind
    value: bool | int | float | str | None
    text: str
    at: Place
    items: tuple[Value, ...] = ()
    fields: tuple[Parameter, ...] = ()

    @property
    def is_known(self) -> bool:
        """Whether the value is literal: neither it nor an element contains a substitution."""
        return self.kind is not ValueKind.UNKNOWN and all(item.is_known for item in self.items)

    @property
    def strings(self) -> tuple[tuple[str, Place], ...]:
        """The text of the value or of its elements, as far as their reader types them as strings, with places."""
        strings = [item for item in (self, *self.items) if item.kind is ValueKind.STRING]
        return tuple((item.text, item.at) for item in strings)


class Parameter(NamedTuple):
    """A parameter, or a map of parameters (`Kind.MAP`).

    name: the dotted name.
    key: the place of its own key, the last one.
    value: the value.
    """

    name: str
    key: Place
    value: Value

    @property
    def last(self) -> str:
        """The last part of the name."""
        return self.name.rpartition(".")[2]


class Parameters:
    """Parameters by dotted name, in the order of the files. Of duplicate names, the last one is kept."""

    __slots__ = ("_by_name", "_by_parent", "_leaves", "_sorted")

    def __init__(self, parameters: Iterable[Parameter] = ()) -> None:
        self._by_name: Mapping[str, Parameter] = {parameter.name: parameter for parameter in parameters}
        self._leaves: tuple[Parameter, ...] | None = None
        self._by_parent: dict[str, list[Parameter]] | None = None
        self._sorted: list[tuple[str, int, Parameter]] | None = None

    def __iter__(self) -> Iterator[Parameter]:
        return iter(self._by_name.values())

    def __len__(self) -> int:
        return len(self._by_name)

    def __contains__(self, name: str) -> bool:
        return name in self._by_name

    def get(self, name: str) -> Parameter | None:
        """Return the parameter or map with a dotted name, if any."""
        return self._by_name.get(name)

    def value(self, name: str) -> Value | None:
        """Return the value of a dotted name, if any."""
        parameter = self._by_name.get(name)
        return parameter.value if parameter else None

    @property
    def leaves(self) -> tuple[Parameter, ...]:
        """The parameters that are not maps, and empty maps."""
        if self._leaves is None:
            parents = {name.rpartition(".")[0] for name in self._by_name}
            self._leaves = tuple(p for p in self if p.value.kind is not ValueKind.MAP or p.name not in parents)
        return self._leaves

    def below(self, name: str = "") -> tuple[Parameter, ...]:
        """Return the direct children of a map, or the top-level parameters, with their full dotted names."""
        if self._by_parent is None:
            self._by_parent = {}
            for parameter in self:
                self._by_parent.setdefault(parameter.name.rpartition(".")[0], []).append(parameter)
        return tuple(self._by_parent.get(name, ()))

    def under(self, name: str) -> Parameters:
        """Return all parameters in a map, at any depth, with names relative to the map."""
        start = f"{name}."
        if self._sorted is None:
            self._sorted = sorted((parameter.name, number, parameter) for number, parameter in enumerate(self))
        first = bisect_left(self._sorted, (start,))
        found = takewhile(lambda one: one[0].startswith(start), islice(self._sorted, first, None))
        in_order = sorted(found, key=lambda one: one[1])
        return Parameters(parameter._replace(name=name[len(start) :]) for name, _, parameter in in_order)


__all__ = ["Parameter", "Parameters", "Value", "ValueKind"]
